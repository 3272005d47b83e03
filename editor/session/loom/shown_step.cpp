#include "session/loom/shown_step.h"

#include <algorithm>

#include "base/text.h"
#include "loom/tabby.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr, base::tr_n;
using draft::BitMatrix, draft::ShedControl, draft::System, draft::for_each_bit;

namespace {

std::string numbers_of(const std::vector<int>& marks) {
  std::string numbers;
  for (const int mark : marks) numbers.append(numbers.empty() ? "" : " + ").append(std::to_string(mark + 1));
  return numbers;
}

std::string lift_text(const Draft& draft, const std::vector<int>& shafts) {
  return fill(draft.rising ? tr("Lift {numbers}") : tr("Lower {numbers}"), arg("numbers", numbers_of(shafts)));
}

ShownColor color_of(const Design& design, System system, int thread) {
  const draft::Threads& threads = design.draft.threads(system);
  const int color = threads.color[static_cast<size_t>(thread)];
  const auto yarn = static_cast<size_t>(threads.yarn[static_cast<size_t>(thread)]);
  return {design.draft.palette[static_cast<size_t>(color)],
          fill(tr("Colour {number}, {yarn}"), arg("number", color + 1), arg("yarn", design.yarns[yarn].name))};
}

/// The colour that follows another, or how long this one lasts.
std::optional<ShownColor> color_after(const Design& design, System system, int thread, int next) {
  const std::vector<int>& color = design.draft.threads(system).color;
  const auto of = [&color](int i) { return color[static_cast<size_t>(i)]; };
  if (of(next) != of(thread)) return ShownColor{design.draft.palette[static_cast<size_t>(of(next))], tr("then")};
  int same = 0;
  while (static_cast<size_t>(thread) + static_cast<size_t>(same) < color.size() && of(thread + same) == of(thread))
    ++same;
  if (same < 2) return {};
  const char* text = system == System::kWarp ? tr_n("for {count} end", "for {count} ends", same)
                                             : tr_n("for {count} pick", "for {count} picks", same);
  return ShownColor{design.draft.palette[static_cast<size_t>(of(thread))], fill(text, arg("count", same))};
}

/// The pick as a tabby pick.
void show_tabby(const Design& design, const loom::TabbySheds& sheds, bool second, ShownStep& step) {
  const Draft& draft = design.draft;
  step.tabby = true;
  step.heading = second ? tr("Tabby B before pick") : tr("Tabby A before pick");
  const std::vector<int> treadles = loom::treadles_of_shed(draft, sheds, second);
  const std::vector<int>& up = second ? sheds.second : sheds.first;
  step.what = treadles.empty() ? lift_text(draft, draft.rising == second ? sheds.second : sheds.first)
                               : fill(tr("Treadle {numbers}"), arg("numbers", numbers_of(treadles)));
  step.shafts.assign(static_cast<size_t>(draft.shafts), false);
  for (const int shaft : up) step.shafts[static_cast<size_t>(shaft)] = true;
}

ShownStep shown_pick(const AtLoom& at, const Design& design, const BitMatrix& lifts, const LoomGroups& groups) {
  ShownStep step;
  const Draft& draft = design.draft;
  const loom::WeavingState place = place_of(at, design);
  const int pick = place.next_pick;
  step.heading = tr("Pick");
  step.number = pick + 1;
  step.of = draft.picks();
  step.progress = fill(tr_n("Woven: {count} pick", "Woven: {count} picks", place.woven), arg("count", place.woven));
  if (step.done()) return step;
  step.group = group_text(groups.picks, System::kWeft, pick);
  if (const auto sheds = place.at_tabby ? loom::tabby_sheds(draft) : std::nullopt) {
    show_tabby(design, *sheds, place.second_tabby, step);
    return step;
  }
  step.what = press_text(draft, pick);
  for (int shaft = 0; shaft < draft.shafts; ++shaft) step.shafts.push_back(lifts.get(pick, shaft) == draft.rising);
  step.color = color_of(design, System::kWeft, pick);
  step.next_color =
      color_after(design, System::kWeft, pick, loom::advanced(place, at.section, draft.picks()).next_pick);
  return step;
}

/// Step `at` of so many, counted from 0; `all_done` if it is beyond them.
ShownStep step_of(LoomWork work, const char* heading, int at, int of, const char* all_done) {
  ShownStep step;
  step.work = work;
  step.heading = heading;
  step.of = of;
  step.number = std::min(at, of) + 1;
  if (step.done()) step.what = all_done;
  return step;
}

ShownStep shown_end(const Design& design, const LoomGroups& groups) {
  const Draft& draft = design.draft;
  ShownStep step =
      step_of(LoomWork::kThread, tr("End"), design.loom.next_end, ends_on_loom(design), tr("All ends are threaded"));
  const int end = step.number - 1;
  step.progress = fill(tr_n("Threaded: {count} end", "Threaded: {count} ends", end), arg("count", end));
  if (step.done()) return step;
  const int in_draft = end % draft.ends();
  step.group = group_text(groups.ends, System::kWarp, end);
  std::vector<int> shafts;
  for_each_bit(draft.threading.row(in_draft), [&shafts](int shaft) { shafts.push_back(shaft); });
  step.what = shafts.empty() ? tr("No heddle") : fill(tr("Shaft {numbers}"), arg("numbers", numbers_of(shafts)));
  step.shafts.assign(static_cast<size_t>(draft.shafts), false);
  for (const int shaft : shafts) step.shafts[static_cast<size_t>(shaft)] = true;
  step.color = color_of(design, System::kWarp, in_draft);
  step.next_color = color_after(design, System::kWarp, in_draft, (in_draft + 1) % draft.ends());
  return step;
}

std::string dent_text(const DentEnds& dent) {
  if (dent.floating) return tr("Floating selvedge");
  if (dent.count == 0) return tr("Leave empty");
  if (dent.count == 1) return fill(tr("End {first}"), arg("first", dent.first + 1));
  if (dent.count == 2)
    return fill(tr("Ends {first} and {last}"), arg("first", dent.first + 1), arg("last", dent.first + 2));
  return fill(tr("Ends {first} to {last}"), arg("first", dent.first + 1), arg("last", dent.first + dent.count));
}

ShownStep shown_dent(const Design& design, const LoomGroups& groups) {
  ShownStep step =
      step_of(LoomWork::kSley, tr("Dent"), design.loom.next_dent, dents_on_loom(design), tr("All dents are sleyed"));
  const int dent = step.number - 1;
  step.progress = fill(tr_n("Sleyed: {count} dent", "Sleyed: {count} dents", dent), arg("count", dent));
  if (step.done()) return step;
  const DentEnds ends = ends_in_dent(design, dent);
  step.what = dent_text(ends);
  if (ends.floating || ends.count == 0) return step;
  step.group = group_text(groups.ends, System::kWarp, ends.first);
  step.color = color_of(design, System::kWarp, ends.first % design.draft.ends());
  return step;
}

}  // namespace

LoomGroups loom_groups(const Design& design) { return {groups_of_ends(design), groups_of_picks(design)}; }

ShownStep shown_step(const AtLoom& at, const Design& design, const BitMatrix& lifts, const LoomGroups& groups) {
  switch (at.work) {
    case LoomWork::kThread:
      return shown_end(design, groups);
    case LoomWork::kSley:
      return shown_dent(design, groups);
    case LoomWork::kWeave:
      break;
  }
  return shown_pick(at, design, lifts, groups);
}

std::string words_of(const ShownStep& step) {
  std::string what = step.what;
  // "3 + 5" is read out as a list, and not as a sum.
  for (size_t at = 0; (at = what.find(" + ", at)) != std::string::npos;) what.replace(at, 3, ", ");
  return step.done() ? step.heading : step.heading + " " + std::to_string(step.number) + ". " + what;
}

std::string press_text(const Draft& draft, int pick) {
  const std::vector<int> marks = to_press(draft, pick);
  const bool liftplan = draft.shed_control == ShedControl::kLiftplan;
  if (marks.empty()) return liftplan ? tr("Lift nothing") : tr("No treadle");
  return liftplan ? lift_text(draft, marks) : fill(tr("Treadle {numbers}"), arg("numbers", numbers_of(marks)));
}

}  // namespace weftlight::session
