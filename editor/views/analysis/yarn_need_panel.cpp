#include "views/analysis/yarn_need_panel.h"

#include <imgui.h>

#include <cstdio>
#include <set>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using analysis::ClothPlan, analysis::YarnNeed, analysis::YarnReport, analysis::yarn_report;
using base::arg, base::fill, base::tr, base::tr_n;
using design::Yarn;
using draft::Draft, draft::System;
using session::DocumentView, session::kMaxLoomWasteCm;
using ui::draw_swatch, ui::fitted, ui::muted_text, ui::row_label, ui::section, ui::slider;

namespace {

using Panel = ViewContext<AnalysisView>;

constexpr float kMaxPrice = 1000;  // per kilogram

/// "312 m", "4.1 km"; "24 g", "1.20 kg".
std::string length_text(double m) {
  return m < 5000 ? fill(tr("{length:.0f} m"), arg("length", m)) : fill(tr("{length:.1f} km"), arg("length", m / 1000));
}
std::string weight_text(double g) {
  return g < 1000 ? fill(tr("{weight:.0f} g"), arg("weight", g)) : fill(tr("{weight:.2f} kg"), arg("weight", g / 1000));
}

void draw_plan(Panel& c) {
  float length = c.view.cloth_length_cm, width = c.view.cloth_width_cm;
  const char* size_tip = tr("Of the finished cloth; 0 takes the size of the draft");
  const auto size_format = [](float cm) { return cm > 0 ? tr("%.0f cm") : tr("as draft"); };
  if (slider(c, {"plan.length", tr("Length"), 0, 500, size_format(length), size_tip, false, 0, 100000}, length))
    c.wanted.change_view([length](DocumentView& v) { v.analysis.cloth_length_cm = length; });
  if (slider(c, {"plan.width", tr("Width"), 0, 200, size_format(width), size_tip, false, 0, 1000}, width))
    c.wanted.change_view([width](DocumentView& v) { v.analysis.cloth_width_cm = width; });
  float waste = c.settings.loom_waste_cm, shrinkage = 100 * c.settings.shrinkage, spare = 100 * c.settings.spare_yarn;
  if (slider(c,
             {"plan.waste", tr("Loom waste"), 0, 200, tr("%.0f cm"), tr("Length of warp that cannot be woven"), false,
              0, kMaxLoomWasteCm},
             waste))
    c.wanted.change_settings([waste](Settings& s) { s.loom_waste_cm = waste; });
  if (slider(c,
             {"plan.shrinkage", tr("Shrinkage"), 0, 40, "%.0f%%",
              tr("Of warp and weft in finishing; take-up is added separately")},
             shrinkage))
    c.wanted.change_settings([shrinkage](Settings& s) { s.shrinkage = shrinkage / 100; });
  if (slider(c,
             {"plan.spare", tr("Allowance"), 0, 30, "%.0f%%", tr("Extra yarn, for losses in winding and in shuttles")},
             spare))
    c.wanted.change_settings([spare](Settings& s) { s.spare_yarn = spare / 100; });
}

void draw_need(PanelContext& c, const YarnNeed& n, int number) {
  const Draft& d = c.design.draft;
  const float side = ImGui::GetTextLineHeight(), gap = c.style.px(8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_swatch(c, at, {at.x + side, at.y + side}, to_u32(d.palette[static_cast<size_t>(n.color)]));
  ImGui::SetCursorScreenPos({at.x + side + gap, at.y});
  ImGui::BeginGroup();
  const bool warp = n.system == System::kWarp;
  const std::string name = fill(warp ? tr("Warp: {yarn}") : tr("Weft: {yarn}"),
                                arg("yarn", c.design.yarns[static_cast<size_t>(n.yarn)].name));
  ImGui::TextUnformatted(fitted(name, ImGui::GetContentRegionAvail().x).c_str());
  const std::string threads =
      fill(warp ? tr_n("{count} end", "{count} ends", n.threads) : tr_n("{count} pick", "{count} picks", n.threads),
           arg("count", n.threads));
  const char* text =
      n.cost >= 0 ? tr("{threads}, {length}, {weight}, cost {cost:.2f}") : tr("{threads}, {length}, {weight}");
  muted_text(c, fill(text, arg("threads", threads), arg("length", length_text(n.length_m)),
                     arg("weight", weight_text(n.weight_g)), arg("cost", n.cost)));
  ImGui::EndGroup();
  c.map.add_item("need:" + std::to_string(number));
}

/// A price for each yarn in use; 0 is shown as not known.
void draw_prices(PanelContext& c, const YarnReport& r) {
  std::set<int> used;
  for (const YarnNeed& n : r.needs) used.insert(n.yarn);
  for (const int yarn : used) {
    const std::string& name = c.design.yarns[static_cast<size_t>(yarn)].name;
    const auto known = c.settings.yarn_prices.find(name);
    float price = known != c.settings.yarn_prices.end() ? known->second : 0;
    const std::string id = "price:" + std::to_string(yarn + 1);
    const std::string tip =
        fill(tr("Price of a kilogram of {yarn}, in your currency; 0 if not known"), arg("yarn", name));
    ImGui::PushID(yarn);
    if (slider(c,
               {id.c_str(), used.size() == 1 ? tr("Price") : fitted(name, c.style.px(100)).c_str(), 0, kMaxPrice / 10,
                price > 0 ? tr("%.2f /kg") : tr("not known"), tip.c_str(), false, 0, kMaxPrice * 10},
               price))
      c.wanted.change_settings([name, price](Settings& s) {
        if (price > 0) s.yarn_prices[name] = price;
        else s.yarn_prices.erase(name);
      });
    ImGui::PopID();
  }
}

void total(const PanelContext& c, const char* label, const std::string& text, const char* tip = "") {
  row_label(c, label, tip);
  ImGui::TextUnformatted(text.c_str());
}

void draw_totals(PanelContext& c, const YarnReport& r) {
  total(c, tr("On the loom"),
        fill(tr("{width:.0f} cm wide, {length:.1f} m long"), arg("width", r.loom_width_mm / 10),
             arg("length", r.warp_length_mm / 1000)),
        tr("Width and length of the warp, with waste, take-up and shrinkage"));
  total(c, tr("Total"),
        fill(tr("{length}, {weight}"), arg("length", length_text(r.warp_m + r.weft_m)),
             arg("weight", weight_text(r.weight_g))));
  if (r.cost >= 0) {
    total(c, tr("Cost"), fill("{cost:.2f}", arg("cost", r.cost)));
    c.map.add_item("need.cost");
  }
  const double all = r.warp_m + r.weft_m;
  if (all > 0)
    total(c, tr("Balance"),
          fill(tr("{warp:.0f}% warp, {weft:.0f}% weft"), arg("warp", 100 * r.warp_m / all),
               arg("weft", 100 * r.weft_m / all)),
          tr("By length of yarn"));
}

}  // namespace

ClothPlan plan_of(const Design& design, const AnalysisView& view, const Settings& settings) {
  ClothPlan plan;
  plan.length_mm = 10.0 * static_cast<double>(view.cloth_length_cm);
  plan.width_mm = 10.0 * static_cast<double>(view.cloth_width_cm);
  plan.loom_waste_mm = 10.0 * static_cast<double>(settings.loom_waste_cm);
  plan.warp_shrinkage = plan.weft_shrinkage = static_cast<double>(settings.shrinkage);
  plan.spare = static_cast<double>(settings.spare_yarn);
  for (const Yarn& yarn : design.yarns) {
    const auto price = settings.yarn_prices.find(yarn.name);
    plan.price_per_kg.push_back(price != settings.yarn_prices.end() ? static_cast<double>(price->second) : -1);
  }
  return plan;
}

void draw_yarn_need(const PanelContext& panel, const AnalysisView& view) {
  Panel c{panel, view};
  if (!section(c, "section.need", tr("Yarn requirements"), false)) return;
  draw_plan(c);
  const YarnReport r = yarn_report(c.design, plan_of(c.design, c.view, c.settings));
  ImGui::Dummy({0, c.style.px(2)});
  for (size_t i = 0; i < r.needs.size(); ++i) draw_need(c, r.needs[i], static_cast<int>(i) + 1);
  ImGui::Dummy({0, c.style.px(2)});
  draw_totals(c, r);
  ImGui::Dummy({0, c.style.px(2)});
  draw_prices(c, r);
}

}  // namespace weftlight::views
