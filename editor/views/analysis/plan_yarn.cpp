// The group "Yarn to buy" of the plan's panel: what the cloth takes, how each yarn is sold, and what it costs.

#include <imgui.h>

#include <set>

#include "base/text.h"
#include "ui/widgets.h"
#include "views/analysis/plan_rows.h"

namespace weftlight::views {

using analysis::YarnToBuy, analysis::area_weight_text, analysis::bought_text, analysis::kOunce_g, analysis::kPound_g,
    analysis::kYard_m, analysis::weight_text, analysis::yarn_length_text;
using base::arg, base::fill, base::mark, base::tr;
using design::YarnPurchase, design::purchase_of, design::with_purchase;
using ui::draw_swatch, ui::fitted, ui::muted_text, ui::row_label, ui::segmented, ui::slider, ui::text_button;

namespace {

enum SoldBy { kLoose, kConeWeight, kConeLength };

SoldBy sold_by(const YarnPurchase& p) { return p.cone_m > 0 ? kConeLength : p.cone_g > 0 ? kConeWeight : kLoose; }

void draw_to_buy(PlanPanel& c, const YarnToBuy& one, int number) {
  const float side = ImGui::GetTextLineHeight(), gap = c.style.px(8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_swatch(c, at, {at.x + side, at.y + side}, to_u32(c.design.draft.palette[static_cast<size_t>(one.color)]));
  ImGui::SetCursorScreenPos({at.x + side + gap, at.y});
  ImGui::BeginGroup();
  const std::string what = fill(tr("{amount} of {yarn}"), arg("amount", bought_text(one, c.state.units)),
                                arg("yarn", c.design.yarns[static_cast<size_t>(one.yarn)].name));
  ImGui::TextUnformatted(fitted(what, ImGui::GetContentRegionAvail().x).c_str());
  const char* text = one.cost >= 0 ? tr("Uses {length}, {weight}; cost {cost:.2f}") : tr("Uses {length}, {weight}");
  muted_text(c, fill(text, arg("length", yarn_length_text(one.length_m, c.state.units)),
                     arg("weight", weight_text(one.weight_g, c.state.units)), arg("cost", one.cost)));
  ImGui::EndGroup();
  c.map.add_item("buy:" + std::to_string(number));
}

void change_purchase(PlanPanel& c, const YarnPurchase& purchase) {
  change_plan(c, tr("Yarn to buy"), [purchase](ClothPlan& p) { p = with_purchase(std::move(p), purchase); });
}

void draw_sold_by(PlanPanel& c, YarnPurchase p, const std::string& id) {
  constexpr const char* kMetric[] = {mark("by kg"), mark("cone, g"), mark("cone, m")};
  constexpr const char* kImperial[] = {mark("by lb"), mark("cone, oz"), mark("cone, yd")};
  constexpr float kUsualCone_g = 250, kUsualCone_m = 1000;
  row_label(c, tr("Sold by"), tr("By weight, or in cones or skeins of a weight or a length"));
  int by = sold_by(p);
  if (!segmented(c, ("sold:" + id).c_str(), c.state.units == Units::kImperial ? kImperial : kMetric, by)) return;
  p.cone_g = by == kConeWeight ? kUsualCone_g : 0;
  p.cone_m = by == kConeLength ? kUsualCone_m : 0;
  change_purchase(c, p);
}

void draw_cone(PlanPanel& c, const YarnPurchase& now, const std::string& id) {
  YarnPurchase p = now;
  const SoldBy by = sold_by(p);
  if (by == kLoose) return;
  const bool imperial = c.state.units == Units::kImperial, weight = by == kConeWeight;
  const double unit = !imperial ? 1 : weight ? kOunce_g : kYard_m;
  float YarnPurchase::*size = weight ? &YarnPurchase::cone_g : &YarnPurchase::cone_m;
  auto shown = static_cast<float>(static_cast<double>(p.*size) / unit);
  const char* format = weight ? (imperial ? tr("%.1f oz") : tr("%.0f g")) : (imperial ? tr("%.0f yd") : tr("%.0f m"));
  const float to = weight ? (imperial ? 40.0f : 1000.0f) : 5000.0f;
  if (!slider(
          c,
          {("cone:" + id).c_str(), tr("Cone"), 1, to, format, tr("Of one cone or skein"), false, 1, design::kMaxCone},
          shown))
    return;
  p.*size = static_cast<float>(static_cast<double>(shown) * unit);
  change_purchase(c, p);
}

void draw_price(PlanPanel& c, YarnPurchase p, const std::string& id) {
  const bool loose = sold_by(p) == kLoose, pounds = loose && c.state.units == Units::kImperial;
  const double unit = pounds ? kPound_g / 1000 : 1;  // of a kilogram
  auto shown = static_cast<float>(static_cast<double>(p.price) * unit);
  const char* format = shown <= 0 ? tr("not known")
                       : !loose   ? tr("%.2f each")
                       : pounds   ? tr("%.2f /lb")
                                  : tr("%.2f /kg");
  const char* tip = tr("In your currency; 0 if not known");
  if (slider(c, {("price:" + id).c_str(), tr("Price"), 0, 100, format, tip, false, 0, design::kMaxPrice}, shown)) {
    p.price = static_cast<float>(static_cast<double>(shown) / unit);
    return change_purchase(c, p);
  }
  const auto last = c.settings.yarn_prices.find(p.yarn);
  if (!loose || p.price > 0 || last == c.settings.yarn_prices.end() || last->second <= 0) return;
  row_label(c, "", "");
  const std::string offer = fill(pounds ? tr("Last price: {price:.2f} /lb") : tr("Last price: {price:.2f} /kg"),
                                 arg("price", static_cast<double>(last->second) * unit));
  if (text_button(c, ("price_again:" + id).c_str(), offer.c_str(), tr("The price of this yarn in your last plan"))) {
    p.price = last->second;
    change_purchase(c, p);
  }
}

/// How each yarn of the cloth is sold; yarns of one name together.
void draw_sellers(PlanPanel& c) {
  std::set<std::string> shown;
  for (const YarnToBuy& one : c.state.yarn.buy) {
    const std::string& name = c.design.yarns[static_cast<size_t>(one.yarn)].name;
    if (!shown.insert(name).second) continue;
    const std::string id = std::to_string(one.yarn + 1);
    const YarnPurchase p = purchase_of(c.design.plan, name);
    ImGui::PushID(one.yarn);
    draw_fact(c, ("sold.yarn:" + id).c_str(), tr("Yarn"), fitted(name, ImGui::GetContentRegionAvail().x * 0.6f));
    draw_sold_by(c, p, id);
    draw_cone(c, p, id);
    draw_price(c, p, id);
    ImGui::PopID();
    ImGui::Dummy({0, c.style.px(2)});
  }
}

void draw_totals(const PlanPanel& c) {
  const analysis::YarnReport& r = c.state.yarn;
  const Units units = c.state.units;
  draw_fact(c, "buy.warp", tr("Warp"), yarn_length_text(r.warp_m, units));
  draw_fact(c, "buy.weft", tr("Weft"), yarn_length_text(r.weft_m, units));
  draw_fact(c, "buy.weight", tr("Weight"),
            fill(tr("{weight}; finished {area}"), arg("weight", weight_text(r.weight_g, units)),
                 arg("area", area_weight_text(r.g_per_m2, units))),
            tr("Of all the yarn, and of the finished cloth without waste"));
  if (r.cost >= 0) draw_fact(c, "buy.cost", tr("Cost"), fill("{cost:.2f}", arg("cost", r.cost)));
}

}  // namespace

void draw_purchases(PlanPanel& c) {
  int number = 0;
  for (const YarnToBuy& one : c.state.yarn.buy) draw_to_buy(c, one, ++number);
  ImGui::Dummy({0, c.style.px(2)});
  draw_totals(c);
  ImGui::Dummy({0, c.style.px(4)});
  draw_sellers(c);
  draw_number(c,
              {"spare", tr("Spare"), tr("Extra yarn, for losses in winding and in shuttles"), "%.1f%%", 100, 30, 100},
              &ClothPlan::spare);
}

}  // namespace weftlight::views
