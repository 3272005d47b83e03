#include "app/draft_prompts.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/file_filters.h"
#include "app/window.h"
#include "base/text.h"
#include "design/edits.h"
#include "design/repeat.h"
#include "design/selection_edits.h"
#include "design/versions.h"
#include "session/editing/selection_state.h"
#include "session/loom/at_loom.h"
#include "weaves/sections.h"

namespace weftlight::app {

using base::mark, base::tr;
using design::Design, design::Loom, design::Repeat, design::structure_repeat, design::ThreadRange, design::WeaveUse,
    design::free_version_name, design::threads_of, design::with_size;
using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::Selection, draft::System;
using session::AtLoom, session::LoomWork, session::MaybeEdit, session::OpenResult, session::color_deletion,
    session::color_deletion_words, session::delete_color_edit, session::delete_yarn_edit, session::go_to,
    session::scroll_to, session::with_added, session::yarn_deletion, session::yarn_deletion_words;
using views::ClosestWeavePrompt, views::GradientPrompt, views::JoinPrompt, views::NotesPrompt, views::PicturePrompt,
    views::PictureStage, views::Question, views::SectionsPrompt, views::SizePrompt, views::ThreadPrompt,
    views::VersionPictures, views::VersionsPrompt, views::WeaveOverPrompt, views::WeavePrompt, views::prompt_for;
using weaves::free_section_name, weaves::weave_kinds;

namespace {

// Numbers of the gestures of dialogs, distinct from those of the mouse and from each other.
constexpr uint64_t kWeaveStrokes = uint64_t{1} << 62;
constexpr uint64_t kSectionStrokes = uint64_t{3} << 61;
constexpr uint64_t kClosestStrokes = uint64_t{5} << 60;
constexpr uint64_t kJoinStrokes = uint64_t{7} << 60;
constexpr uint64_t kGradientStrokes = uint64_t{9} << 59;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// The repeat of a weave, if it is small enough to stand for a colour; otherwise empty.
BitMatrix small_repeat(const BitMatrix& cells) {
  constexpr int kMaxRepeat = 64;
  const Repeat repeat = structure_repeat(cells);
  if (repeat.ends > kMaxRepeat || repeat.picks > kMaxRepeat) return {};
  BitMatrix out(repeat.picks, repeat.ends);
  for (int pick = 0; pick < repeat.picks; ++pick)
    for (int end = 0; end < repeat.ends; ++end) out.set(pick, end, cells.get(pick, end));
  return out;
}

}  // namespace

void DraftPrompts::ask_new_draft(int weave) {
  const Draft& d = document().now().draft;
  dialogs_.ask(prompt_for(weave, {d.ends(), d.picks()}, views::units_of(settings_)), [this](int) {
    files_.open_new(views::new_design(dialogs_.prompt<WeavePrompt>()));
    // From afar a new cloth is of one colour; its threads are what a weaver wants to see first.
    show_flat_();
  });
}

void DraftPrompts::ask_size() {
  const Draft& d = document().now().draft;
  const Loom& loom = document().now().loom;
  dialogs_.ask(SizePrompt{tr("Size of the draft"), mark("Change"), d.ends(), d.picks(), d.shafts, d.treadles,
                          loom.shafts, loom.treadles, document().snapshot()},
               [this](int) {
                 editing_.commit({tr("Change size"), [p = dialogs_.prompt<SizePrompt>()](Design d2) {
                                    d2.loom.shafts = p.loom_shafts;
                                    d2.loom.treadles = p.loom_treadles;
                                    return with_size(std::move(d2), p.ends, p.picks, p.shafts, p.treadles);
                                  }});
                 view().draft.pitch = 0;
               });
}

void DraftPrompts::ask_notes() {
  const Design& d = document().now();
  dialogs_.ask(NotesPrompt{d.title, d.author, joined(d.notes)}, [this](int) {
    editing_.commit({tr("Change title and notes"), [p = dialogs_.prompt<NotesPrompt>()](Design d2) {
                       d2.title = p.title;
                       d2.author = p.author;
                       d2.notes = split_lines(p.notes);
                       return d2;
                     }});
  });
}

/// At the loom, the end to thread or the pick to weave next.
void DraftPrompts::ask_thread() {
  const Draft& d = document().now().draft;
  const AtLoom& at = view().at_loom;
  const System system = !at.open ? view().chosen.system : at.work == LoomWork::kWeave ? System::kWeft : System::kWarp;
  dialogs_.ask(ThreadPrompt{system, d.ends(), d.picks()}, [this](int) {
    const ThreadPrompt p = dialogs_.prompt<ThreadPrompt>();
    const int thread = std::clamp(p.number, 1, document().now().draft.threads(p.system).size()) - 1;
    if (AtLoom& loom = view().at_loom; loom.open) {
      loom.work = p.system == System::kWarp ? LoomWork::kThread : LoomWork::kWeave;
      if (const MaybeEdit there = go_to(loom, document().now(), thread).edit) editing_.commit(*there);
      return;
    }
    scroll_to(view().draft, p.system, thread);
    view().chosen = {p.system, {thread}, thread, {}, false, false};
  });
}

void DraftPrompts::ask_weave() {
  const Draft& d = document().now().draft;
  const Selection& s = view().select.selected;
  const bool ends = !s.empty() && (s.grid == BitGrid::kThreading || s.grid == BitGrid::kDrawdown);
  const bool picks =
      !s.empty() && (s.grid == BitGrid::kTreadling || s.grid == BitGrid::kLiftplan || s.grid == BitGrid::kDrawdown);
  WeaveOverPrompt p;
  p.whole = !ends && !picks;
  p.use.ends = ends ? s.a1 - s.a0 : d.ends();
  p.use.first_end = ends ? s.a0 : 0;
  p.use.picks = picks ? s.b1 - s.b0 : d.picks();
  p.use.first_pick = picks ? s.b0 : 0;
  std::string weave = "twill";
  // If a weave made these threads, its values are shown again.
  for (const WeaveUse& before : document().now().weaves)
    if (before.first_end == p.use.first_end && before.ends == p.use.ends && before.first_pick == p.use.first_pick &&
        before.picks == p.use.picks)
      weave = before.weave, p.use.values = before.values;
  for (size_t i = 0; i < weave_kinds().size(); ++i)
    if (weave_kinds()[i].id == weave) p.kind = static_cast<int>(i);
  p.base = document().snapshot();
  p.stroke = kWeaveStrokes | ++asked_;
  dialogs_.ask(std::move(p), [this](int button) {
    if (button != 0) return;
    const auto& done = dialogs_.prompt<WeaveOverPrompt>();
    const std::string name = tr(weave_kinds()[static_cast<size_t>(done.kind)].name);
    const std::string said = with_added(name, done.base->draft, document().now().draft);
    if (said != name) messages_.say(said);
  });
}

void DraftPrompts::ask_sections() {
  const Design& d = document().now();
  const Selection& s = view().select.selected;
  SectionsPrompt p;
  p.last_end = d.draft.ends(), p.last_pick = d.draft.picks();
  if (const std::optional<ThreadRange> range = s.empty() ? std::nullopt : threads_of(s)) {
    p.system = range->system;
    (range->system == System::kWarp ? p.first_end : p.first_pick) = range->first + 1;
    (range->system == System::kWarp ? p.last_end : p.last_pick) = range->end;
  }
  p.warp = d.warp_assembly, p.weft = d.weft_assembly;
  p.name = free_section_name(p.system == System::kWarp ? p.warp : p.weft);
  p.base = document().snapshot();
  p.stroke = kSectionStrokes | ++asked_;
  dialogs_.ask(std::move(p), [](int) {});
}

void DraftPrompts::ask_join() {
  dialogs_.ask_path(FileAsk::kOpen, tr("Join with another draft"), document().path(), [this](const std::string& path) {
    files_.read(path, [this, path, asked_for = document().snapshot()](OpenResult result) {
      if (!result.document) return messages_.report(std::move(result.remarks), path);
      if (document().snapshot() != asked_for) return;  // another draft is shown, or this one was changed
      JoinPrompt p;
      p.name = std::filesystem::path(path).filename().string();
      p.other = result.document->snapshot();
      p.base = asked_for;
      p.stroke = kJoinStrokes | ++asked_;
      dialogs_.ask(std::move(p), [](int) {});
    });
  });
}

void DraftPrompts::ask_picture() {
  dialogs_.ask_path(
      FileAsk::kOpen, tr("Picture to weave"), document().path(),
      [this](const std::string& path) {
        PicturePrompt p;
        p.name = std::filesystem::path(path).filename().string();
        p.stage = std::make_shared<PictureStage>(path, document().snapshot(), Window::wake);
        p.own_weave = small_repeat(document().cells());
        dialogs_.ask(std::move(p), [](int) {});
      },
      kPictureEnding);
}

void DraftPrompts::ask_versions() {
  VersionsPrompt p;
  p.name = free_version_name(document().now());
  p.pictures = std::make_shared<VersionPictures>(Window::wake);
  dialogs_.ask(std::move(p), [](int) {});
}

void DraftPrompts::ask_gradient() {
  const Draft& d = document().now().draft;
  const auto active = static_cast<size_t>(view().drawing.color);
  GradientPrompt p;
  p.system = view().chosen.system;
  p.chosen_of = p.system;
  p.chosen = view().chosen.threads;
  p.gradient.from = d.palette[active];
  p.gradient.to = d.palette[active + 1 < d.palette.size() ? active + 1 : 0];
  p.base = document().snapshot();
  p.stroke = kGradientStrokes | ++asked_;
  dialogs_.ask(std::move(p), [](int) {});
}

void DraftPrompts::delete_or_ask(const Deletion& deletion, const Edit& edit, const std::string& words,
                                 int DrawingState::*active) {
  if (deletion.heir < 0) return;
  const auto remove = [this, edit, active, heir = deletion.heir - (deletion.heir > deletion.entry ? 1 : 0)] {
    editing_.commit(edit);
    view().drawing.*active = heir;
  };
  if (!deletion.is_used()) return remove();
  dialogs_.ask(Question{edit.label, words, {mark("Delete"), mark("Cancel")}}, [remove](int button) {
    if (button == 0) remove();
  });
}

void DraftPrompts::ask_delete_color() {
  const Deletion d = color_deletion(document().now(), view().drawing.color);
  delete_or_ask(d, delete_color_edit(d), color_deletion_words(d), &DrawingState::color);
}

void DraftPrompts::ask_delete_yarn() {
  const Design& now = document().now();
  const Deletion d = yarn_deletion(now, view().drawing.yarn);
  if (d.heir < 0) return;
  delete_or_ask(d, delete_yarn_edit(now, d), yarn_deletion_words(now, d), &DrawingState::yarn);
}

void DraftPrompts::ask_closest_weave() {
  if (!view().rejected_edit || !view().rejected_edit->closest) return;
  ClosestWeavePrompt p{view().rejected_edit->closest, document().snapshot(), kClosestStrokes | ++asked_};
  Edit edit{tr("Use closest weave"), [closest = p.closest](const Design&) { return *closest->design; }};
  edit.stroke = p.stroke;
  editing_.commit(edit);
  view().differences.closest = p.closest;
  view().differences.place = -1;
  dialogs_.ask(std::move(p), [](int) {});
}

DraftDialogs DraftPrompts::actions() {
  return {.size = [this] { ask_size(); },
          .notes = [this] { ask_notes(); },
          .go_to = [this] { ask_thread(); },
          .weave = [this] { ask_weave(); },
          .sections = [this] { ask_sections(); },
          .picture = [this] { ask_picture(); },
          .versions = [this] { ask_versions(); },
          .gradient = [this] { ask_gradient(); },
          .delete_color = [this] { ask_delete_color(); },
          .delete_yarn = [this] { ask_delete_yarn(); },
          .join = [this] { ask_join(); },
          .closest_weave = [this] { ask_closest_weave(); }};
}

}  // namespace weftlight::app
