// Actions on the chosen threads: the Threads panel by menu and keyboard.

#include <numeric>
#include <span>

#include "actions/action_parts.h"
#include "design/edits.h"
#include "design/thread_text.h"

namespace weftlight::actions {
namespace {

Action& add_one(Actions& all, const char* id, const char* label, const char* key,
                std::function<void(ActionHost&)> run) {
  Action& a = add(all, "Draft", id, label, key, std::move(run));
  a.item.submenu = mark("Threads");
  return a;
}

Action& add_focus(Actions& all, const char* id, const char* label, const char* key, const char* control) {
  return add_one(all, id, label, key, [control](ActionHost& e) { e.focus(control); });
}

void choose_other_system(ActionHost& e) {
  ThreadChoice& choice = e.view().chosen;
  choice = {choice.system == System::kWarp ? System::kWeft : System::kWarp, {}, -1, {}, false, false};
}

void choose_alike(ActionHost& e) {
  ThreadChoice& choice = e.view().chosen;
  choice.threads = threads_alike(e.document().now().draft, choice.system, choice.threads);
}

void choose_every_other(ActionHost& e) {
  ThreadChoice& choice = e.view().chosen;
  const std::vector<int> all = concerned(choice, e.document().now().draft);
  choice.threads.clear();
  for (size_t i = 0; i < all.size(); i += 2) choice.threads.push_back(all[i]);
}

void leave_to_yarn(ActionHost& e) {
  const ThreadChoice& choice = e.view().chosen;
  const std::vector<int> threads = concerned(choice, e.document().now().draft);
  e.commit({thread_label(tr("Thickness and spacing"), choice.system, threads.size()),
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

void copy_bar(ActionHost& e, const char* label, Design (*with)(Design, System), System from) {
  e.commit({label, [=](Design d) { return with(std::move(d), from); }});
}

using ThreadText = std::string (*)(const Draft&, System, std::span<const int>);

/// Copies a property of the chosen threads, or of all of the system.
void copy_properties(ActionHost& e, const char* what, ThreadText text) {
  const ThreadChoice& choice = e.view().chosen;
  const Draft& d = e.document().now().draft;
  const std::vector<int> threads = concerned(choice, d);
  e.set_clipboard(text(d, choice.system, threads));
  e.say(fill(tr("Copied {text}"), arg("text", thread_label(tr(what), choice.system, threads.size()))));
}

void paste_properties(ActionHost& e) {
  const base::Result<ThreadProperties> read = read_thread_properties(e.clipboard());
  if (!read) return e.say(message(read.error()));
  const ThreadChoice& choice = e.view().chosen;
  const std::vector<int> threads = concerned(choice, e.document().now().draft);
  const char* what = read->colors.empty() ? tr("Paste thickness") : tr("Paste colours");
  e.commit({thread_label(what, choice.system, threads.size()),
            [threads, system = choice.system, properties = *read](Design d) {
              return with_properties(std::move(d), system, threads, properties);
            }});
}

}  // namespace

void add_thread_actions(Actions& all) {
  const auto some = [](const ActionHost& e) { return !e.view().chosen.threads.empty(); };
  new_group(add_focus(all, "threads.choose", tr("Choose threads\xE2\x80\xA6"), "Ctrl+T", "threads.which"));
  add_one(all, "threads.swap", tr("Switch between warp and weft"), "", choose_other_system);
  add_one(all, "threads.alike", tr("Choose similar threads"), "", choose_alike).enabled = some;
  add_one(all, "threads.every_other", tr("Choose every other"), "", choose_every_other);
  add_one(all, "threads.clear", tr("Choose none"), "", [](ActionHost& e) { e.view().chosen.threads.clear(); }).enabled =
      some;
  new_group(add_focus(all, "threads.set_thickness", tr("Thickness\xE2\x80\xA6"), "T", "threads.thickness"));
  add_focus(all, "threads.set_spacing", tr("Spacing\xE2\x80\xA6"), "", "threads.spacing");
  add_focus(all, "threads.set_sett", tr("Sett\xE2\x80\xA6"), "", "threads.sett");
  new_group(add_one(all, "threads.weft_as_warp", tr("Copy warp colours to weft"), "", [](ActionHost& e) {
    copy_bar(e, tr("Copy warp colours to weft"), with_colors_of, System::kWarp);
  }));
  add_one(all, "threads.warp_as_weft", tr("Copy weft colours to warp"), "",
          [](ActionHost& e) { copy_bar(e, tr("Copy weft colours to warp"), with_colors_of, System::kWeft); });
  add_one(all, "threads.weft_thick_as_warp", tr("Copy warp thickness to weft"), "",
          [](ActionHost& e) { copy_bar(e, tr("Copy warp thickness to weft"), with_thickness_of, System::kWarp); });
  add_one(all, "threads.warp_thick_as_weft", tr("Copy weft thickness to warp"), "",
          [](ActionHost& e) { copy_bar(e, tr("Copy weft thickness to warp"), with_thickness_of, System::kWeft); });
  new_group(add_one(all, "threads.copy_colors", tr("Copy thread colours"), "Ctrl+Alt+C",
                    [](ActionHost& e) { copy_properties(e, mark("colours"), color_text); }));
  add_one(all, "threads.copy_thickness", tr("Copy thread thickness"), "",
          [](ActionHost& e) { copy_properties(e, mark("thickness"), thickness_text); });
  add_one(all, "threads.paste_looks", tr("Paste colours or thickness"), "Ctrl+Alt+V", paste_properties);
  add_one(all, "threads.from_yarn", tr("Use the yarn's thickness and spacing"), "", leave_to_yarn);
}

}  // namespace weftlight::actions
