#include "analysis/difference.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/decimals.h"
#include "base/text.h"

namespace weftlight::analysis {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using draft::Draft, draft::ShedControl, draft::System, draft::Threads, draft::drawdown, draft::for_each_bit,
    draft::lifts;

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return base::with_decimal_point(text);
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
  // The rows that both have. A column that only one has counts where it is marked.
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
  c.threads(warp ? mark("warp colours") : mark("weft colours"), n, [&](int i) {
    return c.a.draft.palette[static_cast<size_t>(at(x.color, i))] ==
           c.b.draft.palette[static_cast<size_t>(at(y.color, i))];
  });
  c.threads(warp ? mark("warp yarns") : mark("weft yarns"), n, [&](int i) {
    return c.a.yarns[static_cast<size_t>(at(x.yarn, i))] == c.b.yarns[static_cast<size_t>(at(y.yarn, i))];
  });
  c.threads(warp ? mark("warp spacing") : mark("weft spacing"), n,
            [&](int i) { return at(x.spacing_mm, i) == at(y.spacing_mm, i); });
  c.threads(warp ? mark("warp thickness") : mark("weft thickness"), n,
            [&](int i) { return at(x.thickness_mm, i) == at(y.thickness_mm, i); });
}

void include(CellRect& rect, int end, int pick) {
  if (rect.empty()) rect = {end, end + 1, pick, pick + 1};
  rect = {std::min(rect.end0, end), std::max(rect.end1, end + 1), std::min(rect.pick0, pick),
          std::max(rect.pick1, pick + 1)};
}

/// Adds the rectangles of the threads, neighbours joined into one.
void add_runs(std::vector<CellRect>& regions, const std::vector<CellRect>& threads) {
  CellRect now;
  for (const CellRect& thread : threads) {
    if (thread.empty()) {
      if (!now.empty()) regions.push_back(std::exchange(now, {}));
      continue;
    }
    include(now, thread.end0, thread.pick0);
    include(now, thread.end1 - 1, thread.pick1 - 1);
  }
  if (!now.empty()) regions.push_back(now);
}

void compare_cloth(Comparison& out, const BitMatrix& x, const BitMatrix& y) {
  const BitMatrix differ = differing_crossings(x, y);
  out.crossings = differ.count();
  for (int p = 0; p < differ.rows() && out.crossings > 0; ++p)
    for_each_bit(differ.row(p), [&](int end) { include(out.where, end, p); });
  out.same_cloth = out.crossings == 0 && x.rows() == y.rows() && x.cols() == y.cols();
}

std::string version_names(const Design& design) {
  std::string names;
  for (const design::Version& version : design.versions) names.append(names.empty() ? "" : ", ").append(version.name);
  return names;
}

}  // namespace

Comparison compare(const Design& a, const Design& b) {
  Comparison out;
  const Comparer c{a, b, out.differences};
  const Draft &x = a.draft, &y = b.draft;
  c.text(mark("title"), a.title, b.title);
  c.text(mark("author"), a.author, b.author);
  if (a.notes != b.notes) out.differences.push_back({mark("notes"), {}, {}, {}});
  c.count(mark("ends"), x.ends(), y.ends());
  c.count(mark("picks"), x.picks(), y.picks());
  c.count(mark("shafts"), x.shafts, y.shafts);
  c.count(mark("treadles"), x.treadles, y.treadles);
  const auto shed = [](const Draft& d) { return std::string(d.rising ? tr("rising") : tr("sinking")); };
  c.text(mark("shed"), shed(x), shed(y));
  const auto shed_control = [](const Draft& d) {
    return std::string(d.shed_control == ShedControl::kLiftplan ? tr("liftplan") : tr("tie-up and treadling"));
  };
  c.text(mark("shed control"), shed_control(x), shed_control(y));
  c.rows(mark("threading"), x.threading, y.threading);
  if (x.shed_control == ShedControl::kTreadling && y.shed_control == ShedControl::kTreadling) {
    c.rows(mark("tie-up"), x.tieup, y.tieup);
    c.rows(mark("treadling"), x.treadling, y.treadling);
  }
  c.rows(mark("lifts"), lifts(x), lifts(y));
  compare_threads(c, System::kWarp);
  compare_threads(c, System::kWeft);
  c.text(mark("tolerance"), number(static_cast<double>(a.look.tolerance)),
         number(static_cast<double>(b.look.tolerance)));
  c.text(mark("mesh"), a.scene.mesh, b.scene.mesh);
  if (a.versions != b.versions) out.differences.push_back({mark("versions"), version_names(a), version_names(b), {}});
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

std::vector<CellRect> differing_regions(const BitMatrix& differing, size_t most) {
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
  std::vector<CellRect> regions;
  add_runs(regions, ends);
  add_runs(regions, picks);
  if (regions.size() > most) regions.resize(most);
  return regions;
}

std::string region_text(const CellRect& region) {
  const int end_count = region.end1 - region.end0, pick_count = region.pick1 - region.pick0;
  const std::string ends = fill(tr_n("end {first}", "ends {first}\xE2\x80\x93{last}", end_count),
                                arg("first", region.end0 + 1), arg("last", region.end1));
  const std::string picks = fill(tr_n("pick {first}", "picks {first}\xE2\x80\x93{last}", pick_count),
                                 arg("first", region.pick0 + 1), arg("last", region.pick1));
  const bool ends_first = end_count <= pick_count;
  return fill(tr("{first}, {second}"), arg("first", ends_first ? ends : picks),
              arg("second", ends_first ? picks : ends));
}

std::string thread_list(const std::vector<int>& threads) {
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
