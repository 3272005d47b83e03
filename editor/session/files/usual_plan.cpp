// What the plans of cloths leave behind in the settings, for the next one.

#include "session/files/user_files.h"

namespace weftlight::session {

using design::ClothPlan, design::Design, design::YarnPurchase;

void remember_plan(Settings& settings, const ClothPlan& plan) {
  settings.loom_waste_cm = plan.loom_waste_mm / 10;
  settings.spare_yarn = plan.spare;
  for (const YarnPurchase& p : plan.purchases)
    if (p.price > 0 && p.cone_g <= 0 && p.cone_m <= 0) settings.yarn_prices[p.yarn] = p.price;
}

Design with_usual_plan(Design draft, const Settings& settings) {
  draft.plan.loom_waste_mm = settings.loom_waste_cm * 10;
  draft.plan.spare = settings.spare_yarn;
  return draft;
}

}  // namespace weftlight::session
