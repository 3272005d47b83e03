#include "render_data/stage_list.h"

#include <algorithm>
#include <utility>

namespace weftlight::render_data {
namespace {

bool waits(WhenQuick quick, Change input, bool made) {
  switch (quick) {
    case WhenQuick::kRuns:
      return false;
    case WhenQuick::kWaitsForWhole:
      return input != Change::kAll;
    case WhenQuick::kWaitsOnceMade:
      return made;
    case WhenQuick::kWaits:
      return true;
  }
  return false;
}

}  // namespace

void StageKeys::changed(Node part) { at(part).whole = ++at(part).version; }

Change StageKeys::input_change(const Stage& stage) const {
  const std::vector<uint64_t>& key = at(stage.output).key;
  if (key.empty()) return Change::kAll;
  Change change = Change::kNone;
  auto version = key.begin();
  for (const Node n : stage.inputs) {
    const State& input = at(n);
    if (*version < input.whole) return Change::kAll;
    if (*version++ < input.version) change = Change::kPart;
  }
  return change;
}

void StageKeys::run_stage(const Stage& stage, StageWork& work, Change input, bool quick) {
  const base::Result<Outcome> outcome = stage.run(work, input);
  State& state = at(stage.output);
  state.key.clear();
  for (const Node n : stage.inputs) state.key.push_back(at(n).version);
  state.made = outcome.transform([](const Outcome&) {});
  // What failed in a quick update, or where there was no memory, is tried again by the next full one. Once it succeeds,
  // all of it has changed.
  const bool again = quick || (!outcome && outcome.error().kind == base::ErrorKind::kMemory);
  const Outcome made = outcome.value_or(Outcome{Change::kAll, again});
  state.rough = made.rough || (quick && state.rough);
  if (made.change != Change::kNone || state.version == 0) ++state.version;
  if (made.change == Change::kAll || state.whole == 0) state.whole = state.version;
}

bool StageKeys::run(std::span<const Stage> list, StageWork& work, Effort effort, const StageWatch& watch) {
  const bool quick = effort == Effort::kQuick;
  std::array<bool, kNodes> without{};  // have no output because of a problem, here or in an input
  for (size_t i = 0; i < list.size(); ++i) {
    const Stage& stage = list[i];
    const State& state = at(stage.output);
    const auto fails = [&](Node n) { return without[static_cast<size_t>(n)] || !at(n).made; };
    if (std::ranges::any_of(stage.inputs, fails)) {
      without[static_cast<size_t>(stage.output)] = true;
      continue;
    }
    const Change input = state.rough && !quick ? Change::kAll : input_change(stage);
    if (input == Change::kNone || (quick && waits(stage.quick, input, state.version > 0))) continue;
    if (watch.stop.stop_requested()) return false;
    if (watch.starts) watch.starts(stage.name, i, list.size());
    run_stage(stage, work, input, quick);
    if (effort == Effort::kOnce && !state.made) break;  // a single picture needs them all
  }
  return true;
}

base::Result<void> StageKeys::made(std::span<const Stage> list) const {
  const auto failed = std::ranges::find_if(list, [this](const Stage& s) { return !at(s.output).made; });
  return failed == list.end() ? base::Result<void>() : at(failed->output).made;
}

}  // namespace weftlight::render_data
