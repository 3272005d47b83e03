// What is done with chosen threads, by menu and keys: the way round the mouse for the Threads panel.

#include "actions/action_parts.h"
#include "draft/edits.h"

namespace weftlight::actions {
namespace {

Action& add_one(Actions& all, const char* id, const char* label, const char* key, std::function<void(Desk&)> run) {
  Action& a = add(all, "Draft", id, label, key, std::move(run));
  a.item.submenu = "Threads";
  return a;
}

Action& add_focus(Actions& all, const char* id, const char* label, const char* key, const char* control) {
  return add_one(all, id, label, key, [control](Desk& e) { e.focus(control); });
}

void choose_other_system(Desk& e) {
  ThreadChoice& choice = e.view().chosen;
  choice = {choice.system == System::kWarp ? System::kWeft : System::kWarp, {}, -1, {}, false, false};
}

void choose_alike(Desk& e) {
  ThreadChoice& choice = e.view().chosen;
  choice.threads = threads_alike(e.document().now().draft, choice.system, choice.threads);
}

void choose_every_other(Desk& e) {
  ThreadChoice& choice = e.view().chosen;
  const std::vector<int> all = concerned(choice, e.document().now().draft);
  choice.threads.clear();
  for (size_t i = 0; i < all.size(); i += 2) choice.threads.push_back(all[i]);
}

void leave_to_yarn(Desk& e) {
  const ThreadChoice& choice = e.view().chosen;
  const std::vector<int> threads = concerned(choice, e.document().now().draft);
  e.commit({thread_label("Thickness and spacing", choice.system, threads.size()),
            [threads, system = choice.system](Design d) {
              return with_thread_spacing(with_thread_thickness(std::move(d), system, threads, kFromYarn), system,
                                         threads, kFromYarn);
            }});
}

/// The colours of one system for the threads of the other, over and over.
Design with_colors_of(Design d, System from) {
  const System to = from == System::kWarp ? System::kWeft : System::kWarp;
  const std::vector<int> colors = d.draft.threads(from).color;
  const int threads = d.draft.threads(to).size();
  for (int i = 0; i < threads && !colors.empty(); ++i)
    d = with_thread_color(std::move(d), to, i, colors[static_cast<size_t>(i) % colors.size()]);
  return d;
}

void copy_colors(Desk& e, const char* label, System from) {
  e.commit({label, [from](Design d) { return with_colors_of(std::move(d), from); }});
}

}  // namespace

void add_thread_actions(Actions& all) {
  const auto some = [](const Desk& e) { return !e.view().chosen.threads.empty(); };
  new_group(add_focus(all, "threads.choose", "Choose threads\xE2\x80\xA6", "Ctrl+T", "threads.which"));
  add_one(all, "threads.swap", "Warp or weft", "", choose_other_system);
  add_one(all, "threads.alike", "Choose all alike", "", choose_alike).enabled = some;
  add_one(all, "threads.every_other", "Choose every other", "", choose_every_other);
  add_one(all, "threads.clear", "Choose none", "", [](Desk& e) { e.view().chosen.threads.clear(); }).enabled = some;
  new_group(add_focus(all, "threads.set_thickness", "Thickness\xE2\x80\xA6", "T", "threads.thickness"));
  add_focus(all, "threads.set_spacing", "Spacing\xE2\x80\xA6", "", "threads.spacing");
  add_focus(all, "threads.set_sett", "Ends or picks in a centimetre or inch\xE2\x80\xA6", "", "threads.sett");
  new_group(add_one(all, "threads.weft_as_warp", "Weft colours as the warp", "",
                    [](Desk& e) { copy_colors(e, "Weft colours as the warp", System::kWarp); }));
  add_one(all, "threads.warp_as_weft", "Warp colours as the weft", "",
          [](Desk& e) { copy_colors(e, "Warp colours as the weft", System::kWeft); });
  add_one(all, "threads.from_yarn", "Leave thickness and spacing to the yarn", "", leave_to_yarn);
}

}  // namespace weftlight::actions
