#include "analysis/plan_texts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.h"

namespace weftlight::analysis {

using base::arg, base::fill, base::tr, base::tr_n;
using design::sleying_text;

namespace {

std::string edge_text(const EdgeBinding& edge, const char* never, const char* sometimes) {
  return edge.never() ? std::string(never) : fill(sometimes, arg("picks", edge.unbound_picks));
}

}  // namespace

std::string sleying_words(const std::vector<int>& sleying) {
  if (sleying.size() == 1)
    return fill(tr_n("{count} end in each dent", "{count} ends in each dent", sleying.front()),
                arg("count", sleying.front()));
  return fill(tr("{pattern} ends in the dents, repeated"), arg("pattern", sleying_text(sleying)));
}

std::string ends_text(const ClothMeasures& m) {
  const std::string ends = fill(tr_n("{count} end", "{count} ends", m.ends), arg("count", m.ends));
  return m.floating == 0
             ? ends
             : fill(tr("{ends}, {floating} floating selvedges"), arg("ends", ends), arg("floating", m.floating));
}

std::string repeats_text(const WarpingPlan& plan) {
  if (plan.whole_repeats == 1 && plan.more_ends == 0) return {};
  std::string repeats = fill(tr_n("{count} repeat of the draft", "{count} repeats of the draft", plan.whole_repeats),
                             arg("count", plan.whole_repeats));
  const std::string ends = fill(tr_n("{count} end", "{count} ends", plan.more_ends), arg("count", plan.more_ends));
  if (plan.more_ends == 0) return repeats;
  if (plan.whole_repeats == 0) return fill(tr("the first {ends} of the draft"), arg("ends", ends));
  return fill(tr("{repeats} and {ends}"), arg("repeats", repeats), arg("ends", ends));
}

std::string bouts_text(const WarpingPlan& plan) {
  if (plan.bouts <= 1)
    return fill(tr_n("one bout of {count} end", "one bout of {count} ends", plan.ends_in_last),
                arg("count", plan.ends_in_last));
  if (plan.bouts == 2 && plan.ends_in_last != plan.ends_in_bout)
    return fill(tr("2 bouts, of {first} and {last} ends"), arg("first", plan.ends_in_bout),
                arg("last", plan.ends_in_last));
  const char* same = tr_n("{bouts} bouts of {ends} end", "{bouts} bouts of {ends} ends", plan.ends_in_bout);
  const char* shorter = tr("{bouts} bouts of {ends} ends, the last of {last}");
  return fill(plan.ends_in_last == plan.ends_in_bout ? same : shorter, arg("bouts", plan.bouts),
              arg("ends", plan.ends_in_bout), arg("last", plan.ends_in_last));
}

std::string raddle_text(const WarpingPlan& plan) {
  const int64_t groups = plan.raddle_groups, last = plan.ends_in_last_group;
  if (groups == 1) return fill(tr_n("one group of {count} end", "one group of {count} ends", last), arg("count", last));
  std::vector<int> pattern = plan.raddle;
  const auto size = static_cast<int64_t>(pattern.size());
  // Of a pattern that is not repeated, every group is named.
  if (groups > 0 && groups <= size && size > 1) {
    pattern.resize(static_cast<size_t>(groups));
    pattern.back() = static_cast<int>(last);
  }
  const bool full = last == pattern[static_cast<size_t>(std::max<int64_t>(groups - 1, 0) % size)];
  const char* in_turn = full ? tr("{groups} groups of {pattern} ends in turn")
                             : tr("{groups} groups of {pattern} ends in turn, the last of {last}");
  const char* alike = full
                          ? tr_n("{groups} groups of {ends} end", "{groups} groups of {ends} ends", plan.raddle.front())
                          : tr("{groups} groups of {ends} ends, the last of {last}");
  return fill(plan.raddle.size() == 1 ? alike : in_turn, arg("groups", groups), arg("ends", plan.raddle.front()),
              arg("pattern", sleying_text(pattern)), arg("last", last));
}

std::string selvedges_text(const Selvedges& s) {
  if (s.any_direction()) return tr("Not needed: the weft catches both edge ends at every turn.");
  if (!s.floating_needed())
    return s.better() == 0
               ? tr("Not needed if the first pick goes from end 1 to the last end; the other way an edge end floats.")
               : tr("Not needed if the first pick goes from the last end to end 1; the other way an edge end floats.");
  const Selvedges::Start& best = s.starts[static_cast<size_t>(s.better())];
  const bool first = best.first.missed >= best.last.missed;
  return first ? edge_text(best.first, tr("Needed: the weft never catches end 1."),
                           tr("Needed: the weft passes end 1 for up to {picks} picks without catching it."))
               : edge_text(best.last, tr("Needed: the weft never catches the last end."),
                           tr("Needed: the weft passes the last end for up to {picks} picks without catching it."));
}

std::string deviation_text(double fraction) {
  if (std::abs(fraction) < 0.0005) return tr("exact");
  return fill("{percent:+.1f}%", arg("percent", 100 * fraction));
}

std::string bought_text(const YarnToBuy& one, Units units) {
  if (one.cones == 0) return weight_text(one.weight_g, units);
  return fill(tr_n("{count} cone", "{count} cones", one.cones), arg("count", one.cones));
}

}  // namespace weftlight::analysis
