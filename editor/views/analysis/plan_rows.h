#pragma once
// Internal to the plan's panel: rows that several of its groups use.

#include <functional>
#include <string>

#include "session/document/edit.h"
#include "views/analysis/plan_state.h"
#include "views/common/panel.h"

namespace weftlight::views {

using design::ClothPlan;
using session::MaybeEdit;

struct PlanPanel : PanelContext {
  const PlanState& state;
  MaybeEdit edit = {};  // of this frame
};

/// Makes the edit of this frame. `property`: in the user's language; it names the edit.
void change_plan(PlanPanel& c, const char* property, const std::function<void(ClothPlan&)>& change);

/// A slider for a number of the plan that is shown in another unit: shown = kept * scale.
struct PlanRow {
  const char* id;  // after "plan."
  const char* label;
  const char* tip;
  const char* format;
  double scale = 1;
  float to = 100, limit = 100;  // of the track, and of the figure; as shown
  const char* edit = nullptr;   // names the edit; null: the label does
};
void draw_number(PlanPanel& c, const PlanRow& row, float ClothPlan::*number);
/// Lengths across the loom and along it (cm or in), with the limits of the track in mm. `zero`: shown for 0, if given.
void draw_length(PlanPanel& c, const char* id, const char* label, const char* tip, float to_mm,
                 float ClothPlan::*length, const char* zero = nullptr);
void draw_percent(PlanPanel& c, const char* id, const char* label, const char* tip, float ClothPlan::*part);

/// A result beside its label.
void draw_fact(const PanelContext& c, const char* id, const char* label, const std::string& text, const char* tip = "");

void draw_reed(PlanPanel& c);
void draw_warping(PlanPanel& c);
void draw_purchases(PlanPanel& c);

}  // namespace weftlight::views
