#include "views/analysis/yarn_need_panel.h"

#include <imgui.h>

#include <cstdio>
#include <set>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {
namespace {

using namespace analysis;

constexpr float kMaxPrice = 1000;  // of a kilogram, on the track

std::string text_of(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// "312 m", "4.1 km"; "24 g", "1.20 kg".
std::string length_text(double m) { return m < 5000 ? text_of("%.0f m", m) : text_of("%.1f km", m / 1000); }
std::string weight_text(double g) { return g < 1000 ? text_of("%.0f g", g) : text_of("%.2f kg", g / 1000); }

void draw_plan(PanelContext& c) {
  float length = c.view.cloth_length_cm, width = c.view.cloth_width_cm;
  const char* as_is = "Of the finished cloth; 0: as long and wide as the draft";
  const auto size_format = [](float cm) { return cm > 0 ? "%.0f cm" : "the draft"; };
  if (slider(c, {"plan.length", "Length", 0, 500, size_format(length), as_is, false, 0, 100000}, length))
    c.wanted.change_view([length](DocumentView& v) { v.cloth_length_cm = length; });
  if (slider(c, {"plan.width", "Width", 0, 200, size_format(width), as_is, false, 0, 1000}, width))
    c.wanted.change_view([width](DocumentView& v) { v.cloth_width_cm = width; });
  float waste = c.settings.loom_waste_cm, shrinkage = 100 * c.settings.shrinkage, spare = 100 * c.settings.spare_yarn;
  if (slider(c,
             {"plan.waste", "Loom waste", 0, 200, "%.0f cm", "Warp that stays on the loom", false, 0, kMaxLoomWasteCm},
             waste))
    c.wanted.change_settings([waste](Settings& s) { s.loom_waste_cm = waste; });
  if (slider(
          c,
          {"plan.shrinkage", "Shrinkage", 0, 40, "%.0f %%", "In the wash, of warp and weft; take-up is counted apart"},
          shrinkage))
    c.wanted.change_settings([shrinkage](Settings& s) { s.shrinkage = shrinkage / 100; });
  if (slider(c, {"plan.spare", "To spare", 0, 30, "%.0f %%", "Lost in winding and in shuttles"}, spare))
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
  const std::string name = std::string(warp ? "Warp: " : "Weft: ") + c.design.yarns[static_cast<size_t>(n.yarn)].name;
  ImGui::TextUnformatted(fitted(name, ImGui::GetContentRegionAvail().x).c_str());
  const std::string threads = std::to_string(n.threads) + (warp ? " end" : " pick") + (n.threads == 1 ? "" : "s");
  std::string figures = threads + ", " + length_text(n.length_m) + ", " + weight_text(n.weight_g);
  if (n.cost >= 0) figures += ", for " + text_of("%.2f", n.cost);
  muted_text(c, figures);
  ImGui::EndGroup();
  c.map.add_item("need:" + std::to_string(number));
}

/// Of each yarn that is used; what is not known costs nothing and says so.
void draw_prices(PanelContext& c, const YarnReport& r) {
  std::set<int> used;
  for (const YarnNeed& n : r.needs) used.insert(n.yarn);
  for (const int yarn : used) {
    const std::string& name = c.design.yarns[static_cast<size_t>(yarn)].name;
    const auto known = c.settings.yarn_prices.find(name);
    float price = known != c.settings.yarn_prices.end() ? known->second : 0;
    const std::string id = "price:" + std::to_string(yarn + 1);
    const std::string tip = "What a kilogram of " + name + " costs, in your own money; 0: not known";
    ImGui::PushID(yarn);
    if (slider(c,
               {id.c_str(), used.size() == 1 ? "Price" : fitted(name, c.style.px(92)).c_str(), 0, kMaxPrice / 10,
                price > 0 ? "%.2f /kg" : "not known", tip.c_str(), false, 0, kMaxPrice * 10},
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
  total(c, "On the loom",
        text_of("%.0f cm wide, ", r.loom_width_mm / 10) + text_of("%.1f m long", r.warp_length_mm / 1000),
        "The warp with waste, take-up and shrinkage");
  total(c, "All of it", length_text(r.warp_m + r.weft_m) + ", " + weight_text(r.weight_g));
  if (r.cost >= 0) {
    total(c, "Cost", text_of("%.2f", r.cost));
    c.map.add_item("need.cost");
  }
  const double all = r.warp_m + r.weft_m;
  if (all > 0)
    total(c, "Balance", text_of("%.0f %% warp, ", 100 * r.warp_m / all) + text_of("%.0f %% weft", 100 * r.weft_m / all),
          "Of the yarn's length");
}

}  // namespace

ClothPlan plan_of(const Design& design, const DocumentView& view, const Settings& settings) {
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

void draw_yarn_need(PanelContext& c) {
  if (!section(c, "section.need", "Yarn for a cloth", false)) return;
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
