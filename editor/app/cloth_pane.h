#pragma once
// The cloth beside the draft: its picture, its simulated drape, and the views of it.

#include <imgui.h>

#include <memory>
#include <string>
#include <type_traits>

#include "actions/cloth_actions.h"
#include "app/background_tasks.h"
#include "app/dialogs.h"
#include "app/editing.h"
#include "app/frame_schedule.h"
#include "app/messages.h"
#include "app/preview_pane.h"
#include "app/preview_slices.h"
#include "opengl/opengl.h"
#include "session/editing/true_distance.h"
#include "session/files/user_files.h"
#include "session/jobs/draper.h"

namespace weftlight::app {

using actions::ClothActions;
using design::Design;
using session::ClothView, session::Document, session::DrapeState, session::Draper, session::Screen, session::Settings;
using views::PanelContext;

/// A browser has one GL context, of the page's thread.
using Preview = std::conditional_t<opengl::kGles, PreviewSlices, PreviewPane>;

class ClothPane {
 public:
  ClothPane(Editing& editing, Settings& settings, BackgroundTasks& tasks, Dialogs& dialogs, Messages& messages,
            FrameSchedule& schedule);

  /// Called after every change of the shown design. Nothing is computed while the cloth is not shown.
  void follow();
  /// Handles updates of the simulated drape and of the picture; true if there are any.
  bool update();
  /// Requests the picture of this frame. `pixel_ratio`: framebuffer pixels per window unit.
  void ask_picture(float pixel_ratio, const Screen& screen);
  /// True while a finer picture of the same design is being drawn.
  bool refining() const { return preview_.picture().refining; }
  DrapeState drape() const { return draper_.state(); }
  /// Fills the rest of the current window.
  void draw(PanelContext& c);

  void reset_view();
  void toggle_flat();
  void show_flat() {
    if (!view().flat) toggle_flat();
  }
  void save_view();
  void save_view_as();
  void go_to_view(const std::string& name);
  void change_views();
  void choose_environment();
  /// The flat swatch as large as it looks from a distance, or no longer; a screen that was never measured is, first.
  void toggle_true_distance();
  /// Asks for a card to be held to the screen.
  void measure_screen();

  ClothActions actions();

 private:
  const Document& document() const { return editing_.document(); }
  ClothView& view() { return editing_.view().cloth; }
  void submit();
  /// The shown design with its drape, or as a flat swatch.
  std::shared_ptr<const Design> shown_design();
  /// Draws the design anew, as another view shows it.
  void show();

  Editing& editing_;
  Settings& settings_;
  BackgroundTasks& tasks_;
  Dialogs& dialogs_;
  Messages& messages_;
  FrameSchedule& schedule_;
  Draper draper_;
  Preview preview_;
  Screen screen_;
  ImVec2 size_{0, 0};  // of the picture, in window pixels
  bool shown_ = true;  // whether the settings last said so
};

}  // namespace weftlight::app
