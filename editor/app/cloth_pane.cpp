#include "app/cloth_pane.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "app/window.h"
#include "base/text.h"
#include "design/lights.h"
#include "files/environment.h"
#include "session/editing/scene_views.h"
#include "views/cloth/preview_panel.h"

namespace weftlight::app {

using base::arg, base::fill, base::mark, base::message, base::tr;
using design::NamedView, design::is_environment, design::lit_by_environment;
using files::check_environment;
using scene::kFlatMesh, scene::view_named;
using session::MaybeEdit, session::flat_orbit, session::is_calibrated, session::px_a_mm, session::true_view_distance,
    session::free_view_name, session::keep_view_edit, session::orbit_of, session::rename_views_edit,
    session::seen_scene, session::with_orbit;
using views::CardPrompt, views::NamePrompt, views::NamesPrompt, views::draw_preview;

ClothPane::ClothPane(Editing& editing, Settings& settings, BackgroundTasks& tasks, Dialogs& dialogs, Messages& messages,
                     FrameSchedule& schedule)
    : editing_(editing),
      settings_(settings),
      tasks_(tasks),
      dialogs_(dialogs),
      messages_(messages),
      schedule_(schedule),
      draper_(Window::wake),
      preview_(Window::wake) {}

void ClothPane::submit() {
  if (!settings_.cloth) return;
  preview_.submit(shown_design(), {editing_.shown_id(), view().flat});
}

void ClothPane::follow() {
  if (!settings_.cloth) return;
  submit();
  draper_.follow(document().snapshot());
}

bool ClothPane::update() {
  if (std::exchange(shown_, settings_.cloth) != settings_.cloth) follow();
  const bool picture = preview_.poll();
  const Draper::Update drape = draper_.take_update();
  if (!drape.message.empty()) messages_.say(drape.message);
  if (drape.new_mesh) submit();
  return picture || drape.any;
}

void ClothPane::ask_picture(float pixel_ratio, const Screen& screen) {
  screen_ = screen;
  if (!settings_.cloth) return;
  if (view().flat && view().true_distance && size_.x >= 1 && size_.y >= 1)
    view().camera.distance = true_view_distance(settings_, screen_, size_.x, size_.y);
  preview_.ask({seen_scene(view(), document().now()), document().now().look, static_cast<int>(size_.x * pixel_ratio),
                static_cast<int>(size_.y * pixel_ratio), settings_.show_methods, settings_.compare,
                settings_.by_time ? settings_.picture_ms : 0},
               editing_.strokes().going_on());
}

void ClothPane::draw(PanelContext& c) {
  const ImVec2 before = size_;
  draw_preview(c, view(), preview_.picture(), size_);
  if (before.x != size_.x || before.y != size_.y) schedule_.draw(2);
}

std::shared_ptr<const Design> ClothPane::shown_design() {
  if (!view().flat) return document().snapshot();
  Design flat = document().now();
  flat.scene.mesh = kFlatMesh;
  return std::make_shared<const Design>(std::move(flat));
}

void ClothPane::show() {
  submit();
  schedule_.draw(3);
}

void ClothPane::reset_view() {
  const Design& d = document().now();
  view().camera = view().flat ? flat_orbit(d, size_.x, size_.y) : orbit_of(d.scene);
}

void ClothPane::toggle_flat() {
  ClothView& v = view();
  v.flat = !v.flat;
  if (v.flat) v.draped = v.camera;
  v.true_distance = false;
  v.camera = v.flat ? flat_orbit(document().now(), size_.x, size_.y) : v.draped;
  show();
}

void ClothPane::toggle_true_distance() {
  ClothView& v = view();
  const bool on = !(v.flat && v.true_distance);
  if (on && !v.flat) toggle_flat();
  v.true_distance = on;
  if (!on) return reset_view();
  v.camera = flat_orbit(document().now(), size_.x, size_.y);
  if (!is_calibrated(settings_, screen_)) measure_screen();
}

void ClothPane::measure_screen() {
  dialogs_.ask(CardPrompt{screen_.name, px_a_mm(settings_, screen_), settings_.eye_to_screen_cm}, [this](int) {
    const auto& card = dialogs_.prompt<CardPrompt>();
    settings_.screens[card.screen] = card.px_a_mm;
    settings_.eye_to_screen_cm = card.eye_to_screen_cm;
  });
}

void ClothPane::save_view() {
  if (view().flat)
    return messages_.refuse(tr("The flat swatch has one view. Press F for the drape, whose view can be saved."));
  editing_.commit({tr("Save view"), [camera = view().camera](Design d) {
                     d.scene = with_orbit(d.scene, camera);
                     return d;
                   }});
}

void ClothPane::go_to_view(const std::string& name) {
  const std::optional<NamedView> to = view_named(document().now(), name, size_.x, size_.y);
  if (!to) return messages_.refuse(tr("There is no view with that name."));
  const MaybeEdit edit = session::go_to_view(view(), document().now(), *to);
  if (edit) editing_.commit(*edit);
  show();
}

void ClothPane::save_view_as() {
  dialogs_.ask(NamePrompt{tr("Save this view"), tr("Drape, light and camera are saved with the draft."),
                          free_view_name(document().now()), mark("Save")},
               [this](int) {
                 editing_.commit(keep_view_edit(view(), dialogs_.prompt<NamePrompt>().name));
                 messages_.say(tr("Saved with the draft. Find it in View, Views of the cloth."));
               });
}

void ClothPane::change_views() {
  NamesPrompt prompt{tr("Views of the cloth"), {}, {}};
  for (const NamedView& v : document().now().views) prompt.names.push_back(v.name);
  prompt.before = prompt.names;
  dialogs_.ask(std::move(prompt),
               [this](int) { editing_.commit(rename_views_edit(dialogs_.prompt<NamesPrompt>().names)); });
}

void ClothPane::choose_environment() {
  const std::string now = document().now().scene.lights;
  dialogs_.ask_path(
      FileAsk::kOpen, tr("Environment map"), is_environment(now) ? now : "",
      [this](const std::string& path) {
        if (!is_environment(path)) return messages_.refuse(tr("An environment map is an .hdr or .exr file."));
        base::Task task =
            base::task_with_result([path](const base::RunningTask&) { return check_environment(path); },
                                   [this, path, id = editing_.shown_id()](const base::Result<void>& readable) {
                                     if (!readable) return messages_.refuse(message(readable.error()));
                                     editing_.commit_to(id, {tr("Environment map"), [path](Design d) {
                                                               d.scene = lit_by_environment(d.scene, path);
                                                               return d;
                                                             }});
                                   });
        task.kind = "environment";
        task.may_be_left = true;
        task.name = fill(tr("Opening {file}"), arg("file", std::filesystem::path(path).filename().string()));
        tasks_.reading().start(std::move(task));
      },
      ".hdr");
}

ClothActions ClothPane::actions() {
  return {.reset_view = [this] { reset_view(); },
          .save_view = [this] { save_view(); },
          .save_view_as = [this] { save_view_as(); },
          .change_views = [this] { change_views(); },
          .go_to_view = [this](const std::string& name) { go_to_view(name); },
          .toggle_flat = [this] { toggle_flat(); },
          .toggle_true_distance = [this] { toggle_true_distance(); },
          .measure_screen = [this] { measure_screen(); },
          .choose_environment = [this] { choose_environment(); },
          .drape = [this] { return draper_.state(); },
          .stop_drape = [this] { draper_.stop(); },
          .restart_drape = [this] { draper_.again(document().snapshot()); }};
}

}  // namespace weftlight::app
