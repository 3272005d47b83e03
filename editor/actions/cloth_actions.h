#pragma once
// The cloth: its drape, its light, and the views of it.

#include <functional>
#include <string>

#include "session/jobs/draper.h"

namespace weftlight::actions {

using session::DrapeState;

struct ClothActions {
  std::function<void()> reset_view;
  /// The draft opens with the present view.
  std::function<void()> save_view;
  std::function<void()> save_view_as, change_views;
  /// Goes to a view of the cloth by name (render_data/named_views.h).
  std::function<void(const std::string& name)> go_to_view;
  /// Switches between drape and flat swatch.
  std::function<void()> toggle_flat;
  /// Shows the flat swatch as large as it looks from a distance, or no longer.
  std::function<void()> toggle_true_distance;
  /// Asks for a card to be held to the screen.
  std::function<void()> measure_screen;
  /// Asks for an environment picture.
  std::function<void()> choose_environment;
  /// State of the simulated drape.
  std::function<DrapeState()> drape;
  std::function<void()> stop_drape;
  /// Restarts the simulation after a stop or an error.
  std::function<void()> restart_drape;
};

}  // namespace weftlight::actions
