#include "weaves/joined_drafts.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "design/loom.h"
#include "draft/drawdown.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using design::Assembly, design::Loom, design::weaves_on_loom;
using draft::Draft, draft::Threads, draft::drawdown, draft::kMaxCells, draft::kMaxColors, draft::kMaxShafts,
    draft::kMaxThreads;

namespace {

/// A thread of the first draft or of the second.
struct Source {
  bool second = false;
  int thread = 0;
};

int groups(int threads, int each) { return (threads + each - 1) / each; }

/// So many threads of each in turn.
std::vector<Source> in_turn(int of_first, int of_second, const Joining& joining) {
  std::vector<Source> out;
  const int rounds = std::max(groups(of_first, joining.first), groups(of_second, joining.second));
  for (int round = 0; round < rounds; ++round) {
    for (int i = 0; i < joining.first; ++i) out.push_back({false, (round * joining.first + i) % of_first});
    for (int i = 0; i < joining.second; ++i) out.push_back({true, (round * joining.second + i) % of_second});
  }
  return out;
}

int64_t count_in_turn(int of_first, int of_second, const Joining& joining) {
  return int64_t{std::max(groups(of_first, joining.first), groups(of_second, joining.second))} *
         (joining.first + joining.second);
}

/// The shafts of threads in turn: those of the first draft, then those of the second.
std::vector<int> stacked(const std::vector<Source>& order, const std::vector<int>& first,
                         const std::vector<int>& second, int of_first) {
  std::vector<int> out;
  for (const Source& s : order)
    out.push_back(s.second ? of_first + second[static_cast<size_t>(s.thread)] : first[static_cast<size_t>(s.thread)]);
  return out;
}

/// Threads that are of both drafts: a number for each pair, by first use, and the pairs.
struct Pairs {
  std::vector<int> of_thread;
  std::vector<std::pair<int, int>> pairs;
};
Pairs paired(const std::vector<int>& first, const std::vector<int>& second) {
  Pairs out;
  std::map<std::pair<int, int>, int> number;
  for (size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
    const std::pair<int, int> pair{first[i % first.size()], second[i % second.size()]};
    const auto [found, added] = number.try_emplace(pair, static_cast<int>(out.pairs.size()));
    if (added) out.pairs.push_back(pair);
    out.of_thread.push_back(found->second);
  }
  return out;
}

std::vector<int> moved(const std::vector<int>& shafts, int by) {
  std::vector<int> out;
  for (const int s : shafts) out.push_back(s + by);
  return out;
}

Recipe by_ends(const Recipe& a, const Recipe& b, const std::vector<Source>& ends) {
  Recipe out{a.shafts + b.shafts, stacked(ends, a.threading, b.threading, a.shafts), {}, {}};
  Pairs picks = paired(a.treadling, b.treadling);
  for (const auto& [of_a, of_b] : picks.pairs) {
    if (out.tieup.size() > static_cast<size_t>(kMaxShafts)) break;  // refused
    out.tieup.push_back(a.tieup[static_cast<size_t>(of_a)]);
    const std::vector<int> second = moved(b.tieup[static_cast<size_t>(of_b)], a.shafts);
    out.tieup.back().insert(out.tieup.back().end(), second.begin(), second.end());
  }
  out.treadling = std::move(picks.of_thread);
  return out;
}

Recipe by_picks(const Recipe& a, const Recipe& b, const std::vector<Source>& picks) {
  Pairs ends = paired(a.threading, b.threading);
  Recipe out{static_cast<int>(ends.pairs.size()), std::move(ends.of_thread), {}, {}};
  if (out.shafts > kMaxShafts) return out;  // refused
  for (const auto& [recipe, second] : {std::pair{&a, false}, std::pair{&b, true}})
    for (const std::vector<int>& shafts : recipe->tieup) {
      std::vector<bool> lifted(static_cast<size_t>(recipe->shafts), false);
      for (const int s : shafts) lifted[static_cast<size_t>(s)] = true;
      out.tieup.emplace_back();
      for (int s = 0; s < out.shafts; ++s) {
        const auto& [of_a, of_b] = ends.pairs[static_cast<size_t>(s)];
        if (lifted[static_cast<size_t>(second ? of_b : of_a)]) out.tieup.back().push_back(s);
      }
    }
  out.treadling = stacked(picks, a.treadling, b.treadling, static_cast<int>(a.tieup.size()));
  return out;
}

/// The second cloth is woven below: all ends of the first are lifted for it.
Recipe by_layers(const Recipe& a, const Recipe& b, const std::vector<Source>& ends, const std::vector<Source>& picks) {
  Recipe out{a.shafts + b.shafts, stacked(ends, a.threading, b.threading, a.shafts), a.tieup,
             stacked(picks, a.treadling, b.treadling, static_cast<int>(a.tieup.size()))};
  for (const std::vector<int>& lifted : b.tieup) {
    out.tieup.push_back(moved(lifted, a.shafts));
    for (int s = 0; s < a.shafts; ++s) out.tieup.back().push_back(s);
  }
  return out;
}

/// Where the second design's things stand in the list of the first.
template <class T>
std::vector<int> merged(std::vector<T>& into, const std::vector<T>& other) {
  std::vector<int> at;
  for (const T& one : other) {
    const auto found = std::ranges::find(into, one);
    at.push_back(static_cast<int>(found - into.begin()));
    if (found == into.end()) into.push_back(one);
  }
  return at;
}

struct Tables {
  std::vector<int> color, yarn;  // of the second design
};

/// Colour, yarn, spacing and thickness go with the threads. `closer`: by how much each draft's threads are.
void copy_threads(Threads& to, const std::vector<Source>& order, const Threads& first, const Threads& second,
                  const Tables& tables, std::pair<float, float> closer) {
  for (size_t i = 0; i < order.size(); ++i) {
    const Threads& from = order[i].second ? second : first;
    const auto at = static_cast<size_t>(order[i].thread);
    const auto color = static_cast<size_t>(from.color[at]), yarn = static_cast<size_t>(from.yarn[at]);
    to.color[i] = order[i].second ? tables.color[color] : from.color[at];
    to.yarn[i] = order[i].second ? tables.yarn[yarn] : from.yarn[at];
    to.thickness_mm[i] = from.thickness_mm[at];
    const float mm = from.spacing_mm[at];
    to.spacing_mm[i] = mm > 0 ? mm * (order[i].second ? closer.second : closer.first) : mm;
  }
}

/// Threads of both drafts are the longer one's, then the first's.
std::vector<Source> longer(int of_first, int of_second) {
  std::vector<Source> out;
  for (int i = 0; i < std::max(of_first, of_second); ++i) out.push_back({of_second > of_first, i});
  return out;
}

base::Failure impossible(std::string why) { return base::failure(base::ErrorKind::kInput, std::move(why)); }

}  // namespace

base::Result<Design> joined_drafts(const Design& first, const Design& second, const Joining& asked) {
  const Draft &a = first.draft, &b = second.draft;
  const Joining joining{asked.by, std::clamp(asked.first, 1, kMaxThreads), std::clamp(asked.second, 1, kMaxThreads)};
  if (a.ends() == 0 || a.picks() == 0 || b.ends() == 0 || b.picks() == 0)
    return impossible(tr("a draft has no threads"));
  const bool ends_in_turn = joining.by != JoinBy::kPicks, picks_in_turn = joining.by != JoinBy::kEnds;
  const int64_t ends = ends_in_turn ? count_in_turn(a.ends(), b.ends(), joining) : std::max(a.ends(), b.ends());
  const int64_t picks = picks_in_turn ? count_in_turn(a.picks(), b.picks(), joining) : std::max(a.picks(), b.picks());
  if (ends > kMaxThreads || picks > kMaxThreads)
    return impossible(fill(tr("this is more than {most} threads"), arg("most", kMaxThreads)));
  if (ends * picks > kMaxCells) return impossible(tr("too many crossings"));
  const Recipe of_a = recipe_of(drawdown(a)), of_b = recipe_of(drawdown(b));
  const std::vector<Source> warp = ends_in_turn ? in_turn(a.ends(), b.ends(), joining) : longer(a.ends(), b.ends()),
                            weft =
                                picks_in_turn ? in_turn(a.picks(), b.picks(), joining) : longer(a.picks(), b.picks());
  const Recipe recipe = joining.by == JoinBy::kEnds    ? by_ends(of_a, of_b, warp)
                        : joining.by == JoinBy::kPicks ? by_picks(of_a, of_b, weft)
                                                       : by_layers(of_a, of_b, warp, weft);
  if (recipe.shafts > kMaxShafts || recipe.tieup.size() > static_cast<size_t>(kMaxShafts))
    return impossible(fill(tr("together they need more than {most} shafts or treadles"), arg("most", kMaxShafts)));
  Design out = first;
  out.weaves.clear();
  out.warp_assembly = out.weft_assembly = Assembly{};
  out.loom = Loom{};
  out.loom.shafts = first.loom.shafts, out.loom.treadles = first.loom.treadles;
  out.draft = make_design(recipe, {static_cast<int>(ends), static_cast<int>(picks)}).draft;
  if (const base::Result<void> possible = weaves_on_loom(first, out.draft); !possible) return failed(possible);
  out.draft.palette = a.palette;
  const Tables tables{merged(out.draft.palette, b.palette), merged(out.yarns, second.yarns)};
  if (out.draft.palette.size() > static_cast<size_t>(kMaxColors))
    return impossible(tr("together they have too many colours"));
  // Layers lie on each other, so that each keeps its own sett.
  const auto all = static_cast<float>(joining.first + joining.second);
  const bool layers = joining.by == JoinBy::kLayers;
  const std::pair<float, float> closer =
      layers ? std::pair{static_cast<float>(joining.first) / all, static_cast<float>(joining.second) / all}
             : std::pair{1.0f, 1.0f};
  copy_threads(out.draft.warp, warp, a.warp, b.warp, tables, closer);
  copy_threads(out.draft.weft, weft, a.weft, b.weft, tables, closer);
  return out;
}

}  // namespace weftlight::weaves
