// Actions on the chosen threads: the Threads panel by menu and keyboard.

#include <numeric>
#include <span>

#include "actions/action_parts.h"
#include "design/edits.h"
#include "design/thread_text.h"

namespace weftlight::actions {

using base::fill, base::mark, base::message, base::tr, base::tr_n;
using design::Design, design::ThreadProperties, design::color_text, design::read_thread_properties,
    design::thickness_text, design::with_properties, design::with_thread_color, design::with_thread_spacing,
    design::with_thread_thickness;
using draft::Draft, draft::System, draft::kFromYarn;
using session::ThreadChoice, session::ThreadProperty, session::concerned, session::thread_label, session::threads_alike;

namespace {

Action& add_one(Actions& all, const char* id, const char* label, const char* key, std::function<void()> run) {
  Action& a = add(all, "Draft", id, label, key, std::move(run));
  a.item.submenu = mark("Threads");
  return a;
}

Action& add_focus(Actions& all, const WindowActions& window, const char* id, const char* label, const char* key,
                  const char* control) {
  return add_one(all, id, label, key, [&window, control] { window.focus(control); });
}

void choose_other_system(const ActiveDraft& draft) {
  ThreadChoice& choice = draft.view().chosen;
  choice = {choice.system == System::kWarp ? System::kWeft : System::kWarp, {}, -1, {}, false, false};
}

void choose_alike(const ActiveDraft& draft) {
  ThreadChoice& choice = draft.view().chosen;
  choice.threads = threads_alike(draft.document().now().draft, choice.system, choice.threads);
}

void choose_every_other(const ActiveDraft& draft) {
  ThreadChoice& choice = draft.view().chosen;
  const std::vector<int> all = concerned(choice, draft.document().now().draft);
  choice.threads.clear();
  for (size_t i = 0; i < all.size(); i += 2) choice.threads.push_back(all[i]);
}

void leave_to_yarn(const ActiveDraft& draft) {
  const ThreadChoice& choice = draft.view().chosen;
  const std::vector<int> threads = concerned(choice, draft.document().now().draft);
  draft.commit({thread_label(ThreadProperty::kThicknessAndSpacing, choice.system, threads.size()),
                [threads, system = choice.system](Design d) {
                  return with_thread_spacing(with_thread_thickness(std::move(d), system, threads, kFromYarn), system,
                                             threads, kFromYarn);
                }});
}

/// Copies the colours of one system to the other, repeated as needed.
Design with_colors_of(Design d, System from) {
  const System to = from == System::kWarp ? System::kWeft : System::kWarp;
  const std::vector<int> colors = d.draft.threads(from).color;
  const int threads = d.draft.threads(to).size();
  for (int i = 0; i < threads && !colors.empty(); ++i)
    d = with_thread_color(std::move(d), to, i, colors[static_cast<size_t>(i) % colors.size()]);
  return d;
}

/// The same for the thickness.
Design with_thickness_of(Design d, System from) {
  const System to = from == System::kWarp ? System::kWeft : System::kWarp;
  const ThreadProperties properties{{}, d.draft.threads(from).thickness_mm};
  std::vector<int> threads(static_cast<size_t>(d.draft.threads(to).size()));
  std::iota(threads.begin(), threads.end(), 0);
  return with_properties(std::move(d), to, threads, properties);
}

void copy_bar(const ActiveDraft& draft, const char* label, Design (*with)(Design, System), System from) {
  draft.commit({label, [=](Design d) { return with(std::move(d), from); }});
}

/// What the actions that copy and paste properties act on.
struct PropertySubjects {
  const ActiveDraft& draft;
  const Clipboard& clipboard;
  const WindowActions& window;
};

using ThreadText = std::string (*)(const Draft&, System, std::span<const int>);

/// The texts of copying and pasting a property, each for a number of ends or of picks.
struct PropertyTexts {
  const char *copied, *paste;
};
PropertyTexts color_texts(System system, size_t count) {
  const auto n = static_cast<long long>(count);
  if (system == System::kWarp)
    return {tr_n("Copied colours of {count} end", "Copied colours of {count} ends", n),
            tr_n("Paste colours of {count} end", "Paste colours of {count} ends", n)};
  return {tr_n("Copied colours of {count} pick", "Copied colours of {count} picks", n),
          tr_n("Paste colours of {count} pick", "Paste colours of {count} picks", n)};
}
PropertyTexts thickness_texts(System system, size_t count) {
  const auto n = static_cast<long long>(count);
  if (system == System::kWarp)
    return {tr_n("Copied thickness of {count} end", "Copied thickness of {count} ends", n),
            tr_n("Paste thickness of {count} end", "Paste thickness of {count} ends", n)};
  return {tr_n("Copied thickness of {count} pick", "Copied thickness of {count} picks", n),
          tr_n("Paste thickness of {count} pick", "Paste thickness of {count} picks", n)};
}

/// Copies a property of the chosen threads, or of all of the system.
void copy_properties(const PropertySubjects& e, PropertyTexts (*texts)(System, size_t), ThreadText text) {
  const ThreadChoice& choice = e.draft.view().chosen;
  const Draft& d = e.draft.document().now().draft;
  const std::vector<int> threads = concerned(choice, d);
  e.clipboard.set_text(text(d, choice.system, threads));
  e.window.say(fill(texts(choice.system, threads.size()).copied, arg("count", threads.size())));
}

void paste_properties(const PropertySubjects& e) {
  const base::Result<ThreadProperties> read = read_thread_properties(e.clipboard.text());
  if (!read) return e.window.refuse(message(read.error()));
  const ThreadChoice& choice = e.draft.view().chosen;
  const std::vector<int> threads = concerned(choice, e.draft.document().now().draft);
  const auto texts = read->colors.empty() ? thickness_texts : color_texts;
  e.draft.commit({fill(texts(choice.system, threads.size()).paste, arg("count", threads.size())),
                  [threads, system = choice.system, properties = *read](Design d) {
                    return with_properties(std::move(d), system, threads, properties);
                  }});
}

}  // namespace

void add_thread_actions(Actions& all, const ActiveDraft& draft, const Clipboard& clipboard,
                        const WindowActions& window) {
  const PropertySubjects subjects{draft, clipboard, window};
  const auto some = [&draft] { return !draft.view().chosen.threads.empty(); };
  new_group(add_focus(all, window, "threads.choose", tr("Select threads\xE2\x80\xA6"), "Ctrl+T", "threads.which"));
  add_one(all, "threads.swap", tr("Switch between warp and weft"), "", [&draft] { choose_other_system(draft); });
  add_one(all, "threads.alike", tr("Select similar threads"), "", [&draft] { choose_alike(draft); }).enabled = some;
  add_one(all, "threads.every_other", tr("Select every other thread"), "", [&draft] { choose_every_other(draft); });
  add_one(all, "threads.clear", tr("Clear thread selection"), "", [&draft] {
    draft.view().chosen.threads.clear();
  }).enabled = some;
  new_group(add_focus(all, window, "threads.set_thickness", tr("Thickness\xE2\x80\xA6"), "T", "threads.thickness"));
  add_focus(all, window, "threads.set_spacing", tr("Spacing\xE2\x80\xA6"), "", "threads.spacing");
  add_focus(all, window, "threads.set_sett", tr("Sett\xE2\x80\xA6"), "", "threads.sett");
  new_group(add_one(all, "threads.weft_as_warp", tr("Copy warp colours to weft"), "",
                    [&draft] { copy_bar(draft, tr("Copy warp colours to weft"), with_colors_of, System::kWarp); }));
  add_one(all, "threads.warp_as_weft", tr("Copy weft colours to warp"), "",
          [&draft] { copy_bar(draft, tr("Copy weft colours to warp"), with_colors_of, System::kWeft); });
  add_one(all, "threads.weft_thick_as_warp", tr("Copy warp thickness to weft"), "",
          [&draft] { copy_bar(draft, tr("Copy warp thickness to weft"), with_thickness_of, System::kWarp); });
  add_one(all, "threads.warp_thick_as_weft", tr("Copy weft thickness to warp"), "",
          [&draft] { copy_bar(draft, tr("Copy weft thickness to warp"), with_thickness_of, System::kWeft); });
  new_group(add_one(all, "threads.copy_colors", tr("Copy thread colours"), "Ctrl+Alt+C",
                    [subjects] { copy_properties(subjects, color_texts, color_text); }));
  add_one(all, "threads.copy_thickness", tr("Copy thread thickness"), "",
          [subjects] { copy_properties(subjects, thickness_texts, thickness_text); });
  add_one(all, "threads.paste_looks", tr("Paste colours or thickness"), "Ctrl+Alt+V",
          [subjects] { paste_properties(subjects); });
  add_one(all, "threads.from_yarn", tr("Use the yarn's thickness and spacing"), "", [&draft] { leave_to_yarn(draft); });
}

}  // namespace weftlight::actions
