#include "analysis/difference.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace weftlight::analysis {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

struct Comparer {
  const Design& a;
  const Design& b;
  std::vector<Difference>& out;

  void text(const char* what, const std::string& x, const std::string& y) const {
    if (x != y) out.push_back({what, x, y, {}});
  }
  void count(const char* what, int x, int y) const { text(what, std::to_string(x), std::to_string(y)); }
  template <class Same>
  void threads(const char* what, int n, Same same) const {
    std::vector<int> differ;
    for (int i = 0; i < n; ++i)
      if (!same(i)) differ.push_back(i);
    if (!differ.empty()) out.push_back({what, {}, {}, std::move(differ)});
  }
  // Rows that both have; columns beyond one of the two count when they are marked.
  void rows(const char* what, const BitMatrix& x, const BitMatrix& y) const {
    threads(what, std::min(x.rows(), y.rows()), [&](int r) {
      const auto s = x.row(r), t = y.row(r);
      for (size_t w = 0; w < std::max(s.size(), t.size()); ++w)
        if ((w < s.size() ? s[w] : 0) != (w < t.size() ? t[w] : 0)) return false;
      return true;
    });
  }
};

void compare_threads(const Comparer& c, System system) {
  const bool warp = system == System::kWarp;
  const Threads &x = c.a.draft.threads(system), &y = c.b.draft.threads(system);
  const int n = std::min(x.size(), y.size());
  const auto at = [](const auto& table, int i) { return table[static_cast<size_t>(i)]; };
  c.threads(warp ? "warp colours" : "weft colours", n, [&](int i) {
    return c.a.draft.palette[static_cast<size_t>(at(x.color, i))] ==
           c.b.draft.palette[static_cast<size_t>(at(y.color, i))];
  });
  c.threads(warp ? "warp yarns" : "weft yarns", n, [&](int i) {
    return c.a.yarns[static_cast<size_t>(at(x.yarn, i))] == c.b.yarns[static_cast<size_t>(at(y.yarn, i))];
  });
  c.threads(warp ? "warp spacing" : "weft spacing", n,
            [&](int i) { return at(x.spacing_mm, i) == at(y.spacing_mm, i); });
  c.threads(warp ? "warp thickness" : "weft thickness", n,
            [&](int i) { return at(x.thickness_mm, i) == at(y.thickness_mm, i); });
}

void include(CellRect& rect, int end, int pick) {
  if (rect.empty()) rect = {end, end + 1, pick, pick + 1};
  rect = {std::min(rect.end0, end), std::max(rect.end1, end + 1), std::min(rect.pick0, pick),
          std::max(rect.pick1, pick + 1)};
}

/// Neighbours that are not empty become one.
void add_runs(std::vector<CellRect>& places, const std::vector<CellRect>& threads) {
  CellRect now;
  for (const CellRect& thread : threads) {
    if (thread.empty()) {
      if (!now.empty()) places.push_back(std::exchange(now, {}));
      continue;
    }
    include(now, thread.end0, thread.pick0);
    include(now, thread.end1 - 1, thread.pick1 - 1);
  }
  if (!now.empty()) places.push_back(now);
}

void compare_cloth(Comparison& out, const BitMatrix& x, const BitMatrix& y) {
  const BitMatrix differ = differing_crossings(x, y);
  out.crossings = differ.count();
  for (int p = 0; p < differ.rows() && out.crossings > 0; ++p)
    for_each_bit(differ.row(p), [&](int end) { include(out.where, end, p); });
  out.same_cloth = out.crossings == 0 && x.rows() == y.rows() && x.cols() == y.cols();
}

}  // namespace

Comparison compare(const Design& a, const Design& b) {
  Comparison out;
  const Comparer c{a, b, out.differences};
  const Draft &x = a.draft, &y = b.draft;
  c.text("title", a.title, b.title);
  c.text("author", a.author, b.author);
  if (a.notes != b.notes) out.differences.push_back({"notes", {}, {}, {}});
  c.count("ends", x.ends(), y.ends());
  c.count("picks", x.picks(), y.picks());
  c.count("shafts", x.shafts, y.shafts);
  c.count("treadles", x.treadles, y.treadles);
  const auto shed = [](const Draft& d) { return std::string(d.rising ? "rising" : "sinking"); };
  c.text("shed", shed(x), shed(y));
  const auto drive = [](const Draft& d) {
    return std::string(d.drive == ShedControl::kLiftplan ? "liftplan" : "tie-up and treadling");
  };
  c.text("driven by", drive(x), drive(y));
  c.rows("threading", x.threading, y.threading);
  if (x.drive == ShedControl::kTreadling && y.drive == ShedControl::kTreadling) {
    c.rows("tie-up", x.tieup, y.tieup);
    c.rows("treadling", x.treadling, y.treadling);
  }
  c.rows("lifts", lifts(x), lifts(y));
  compare_threads(c, System::kWarp);
  compare_threads(c, System::kWeft);
  c.text("tolerance", number(static_cast<double>(a.look.tolerance)), number(static_cast<double>(b.look.tolerance)));
  c.text("mesh", a.scene.mesh, b.scene.mesh);
  compare_cloth(out, drawdown(x), drawdown(y));
  return out;
}

BitMatrix differing_crossings(const BitMatrix& x, const BitMatrix& y) {
  BitMatrix out(x.rows(), x.cols());
  const int picks = std::min(x.rows(), y.rows()), ends = std::min(x.cols(), y.cols());
  for (int p = 0; p < picks; ++p)
    for (int w = 0; w * 64 < ends; ++w) {
      uint64_t differ = x.row(p)[static_cast<size_t>(w)] ^ y.row(p)[static_cast<size_t>(w)];
      if (ends - w * 64 < 64) differ &= (uint64_t{1} << (ends - w * 64)) - 1;
      out.row(p)[static_cast<size_t>(w)] = differ;
    }
  return out;
}

std::vector<CellRect> differing_places(const BitMatrix& differing, size_t most) {
  std::vector<int> of_end(static_cast<size_t>(differing.cols())), of_pick;
  for (int p = 0; p < differing.rows(); ++p) {
    of_pick.push_back(differing.count(p));
    for_each_bit(differing.row(p), [&](int end) { ++of_end[static_cast<size_t>(end)]; });
  }
  std::vector<CellRect> ends(of_end.size()), picks(of_pick.size());
  for (int p = 0; p < differing.rows(); ++p)
    for_each_bit(differing.row(p), [&](int end) {
      const bool by_end = of_end[static_cast<size_t>(end)] > of_pick[static_cast<size_t>(p)];
      include(by_end ? ends[static_cast<size_t>(end)] : picks[static_cast<size_t>(p)], end, p);
    });
  std::vector<CellRect> places;
  add_runs(places, ends);
  add_runs(places, picks);
  if (places.size() > most) places.resize(most);
  return places;
}

std::string place_text(const CellRect& at) {
  const auto span = [](const char* one, int first, int end) {
    return end - first == 1
               ? std::string(one) + " " + std::to_string(first + 1)
               : std::string(one) + "s " + std::to_string(first + 1) + "\xE2\x80\x93" + std::to_string(end);
  };
  const std::string ends = span("end", at.end0, at.end1), picks = span("pick", at.pick0, at.pick1);
  return at.end1 - at.end0 <= at.pick1 - at.pick0 ? ends + ", " + picks : picks + ", " + ends;
}

std::string listed(const std::vector<int>& threads) {
  std::string text;
  for (size_t i = 0; i < threads.size();) {
    size_t last = i;
    while (last + 1 < threads.size() && threads[last + 1] == threads[last] + 1) ++last;
    if (!text.empty()) text += ", ";
    text += std::to_string(threads[i] + 1);
    if (last > i) text.append(last == i + 1 ? ", " : "-").append(std::to_string(threads[last] + 1));
    i = last + 1;
  }
  return text;
}

}  // namespace weftlight::analysis
