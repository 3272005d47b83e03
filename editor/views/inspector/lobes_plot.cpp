// Based on: the formulas of shaders/lobes.glsl. Each curve is the contribution of one lobe to the whole.

#include "views/inspector/lobes_plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/text.h"
#include "light/yarn_lobes.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::tr;
using cloth::linear_from_srgb;
using light::yarn_lobes;
using session::Settings;
using ui::Colors, ui::blend, ui::fixed, ui::font_size, ui::hit_area, ui::with_alpha;

namespace {

using formulas::YarnLobes;

constexpr float kDegree = 0.017453293f;
constexpr float kPi = 3.14159265f;
constexpr float kMargin = 7, kMaxRadius = 128;  // pixels at 96 dpi
constexpr float kLowerHeight = 0.42f;           // of the transmitted half, in radii
// Closer to the horizon the formulas divide by almost zero.
constexpr float kLastDegree = 89.5f;

float luminance(glm::vec3 c) { return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

glm::vec3 direction(float degrees, bool across) {
  const float a = std::clamp(degrees, -kLastDegree, kLastDegree) * kDegree, s = std::sin(a), z = std::cos(a);
  return across ? glm::vec3(0, s, z) : glm::vec3(s, 0, z);
}

/// The curve for light from `light_deg`, in the plane along or across the fibre.
template <class Formula>
LobeCurves::Curve curve(float light_deg, bool across, Formula formula) {
  LobeCurves::Curve out;
  const glm::vec3 wi = direction(light_deg, across);
  for (int i = 0; i < LobeCurves::kCount; ++i)
    out[static_cast<size_t>(i)] =
        std::max(0.0f, luminance(formula(wi, direction(LobeCurves::angle_deg(i), across)))) * kPi * wi.z;
  return out;
}

struct Plot {
  ImVec2 middle;
  float radius, rim;
  ImVec2 at(float degrees, float fraction, bool below) const {
    const float a = degrees * kDegree, r = radius * fraction;
    return {middle.x + r * std::sin(a), middle.y + (below ? r : -r) * std::cos(a)};
  }
};

float radius_for(const PanelContext& c, float width) {
  return std::min(width / 2 - c.style.px(kMargin), c.style.px(kMaxRadius));
}

float legend_height(const PanelContext& c) { return font_size(c.style.font.small) + c.style.px(4); }

std::vector<ImVec2> points_of(const Plot& plot, const LobeCurves::Curve& curve, bool below) {
  std::vector<ImVec2> points;
  for (int i = 0; i < LobeCurves::kCount; ++i) {
    const float limit = below ? kLowerHeight : 1.0f;
    const float fraction = std::min(plotted_radius(curve[static_cast<size_t>(i)], plot.rim), limit);
    points.push_back(plot.at(LobeCurves::angle_deg(i), fraction, below));
  }
  return points;
}

void draw_filled(const std::vector<ImVec2>& points, ImVec2 middle, ImU32 color) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  for (size_t i = 1; i < points.size(); ++i) dl->AddTriangleFilled(middle, points[i - 1], points[i], color);
}

void draw_line(const std::vector<ImVec2>& points, ImU32 color, float width) {
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, width);
}

void draw_small(const PanelContext& c, ImVec2 at, ImU32 color, const char* text) {
  ImGui::GetWindowDrawList()->AddText(c.style.font.small, font_size(c.style.font.small), at, color, text);
}

/// Circles of equal brightness, and the surface of the thread.
void draw_axes(const PanelContext& c, const Plot& plot) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& color = c.style.color;
  for (float brightness : {0.01f, 0.1f, 1.0f, plot.rim}) {
    const float r = plotted_radius(brightness, plot.rim) * plot.radius;
    const bool white = brightness == 1.0f;
    dl->PathArcTo(plot.middle, r, kPi, 2 * kPi, 64);
    dl->PathStroke(white ? color.line_strong : color.line, 0, 1);
  }
  const float white = plotted_radius(1, plot.rim) * plot.radius, radius = plot.radius;
  dl->AddLine({plot.middle.x - radius, plot.middle.y}, {plot.middle.x + radius, plot.middle.y}, color.line_strong);
  const float line = font_size(c.style.font.small) + 1;
  if (plot.rim > 1)
    draw_small(c, {plot.middle.x - radius, plot.middle.y + c.style.px(2)}, color.muted, fixed(plot.rim, 0).c_str());
  draw_small(c, {plot.middle.x - white - c.style.px(3), plot.middle.y + c.style.px(2)}, color.muted, "1");
  draw_small(c, {plot.middle.x - radius, plot.middle.y + kLowerHeight * radius - line}, color.muted, tr("transmitted"));
}

/// The light on the rim, and its ray.
void draw_light(const PanelContext& c, const Plot& plot, bool highlighted) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const ImVec2 at = plot.at(c.settings.lobe_light_deg, 1, false),
               inner = plot.at(c.settings.lobe_light_deg, 0.06f, false);
  const ImU32 color = highlighted ? c.style.color.accent : c.style.color.text;
  dl->AddLine(at, inner, with_alpha(color, 0.45f), 1);
  dl->AddCircleFilled(at, c.style.px(highlighted ? 6 : 5), c.style.color.panel);
  dl->AddCircleFilled(at, c.style.px(highlighted ? 4.5f : 3.5f), color);
}

struct LegendRow {
  const char* word;
  ImU32 color;
  bool filled;
};

void draw_legend(const PanelContext& c, std::span<const LegendRow> rows) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float line = font_size(c.style.font.small), box = c.style.px(8), gap = c.style.px(5);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  float words = 0;
  for (const LegendRow& row : rows)
    words += c.style.font.small->CalcTextSizeA(line, FLT_MAX, 0, row.word).x + box + gap;
  const float between = (width - words) / static_cast<float>(rows.size() - 1);
  float x = at.x;
  for (const LegendRow& row : rows) {
    const float y = at.y + line / 2;
    if (row.filled) dl->AddRectFilled({x, y - box / 2}, {x + box, y + box / 2}, row.color, 2);
    else dl->AddRectFilled({x, y - 1}, {x + box, y + 1}, row.color);
    draw_small(c, {x + box + gap, at.y}, c.style.color.muted, row.word);
    x += box + gap + c.style.font.small->CalcTextSizeA(line, FLT_MAX, 0, row.word).x + between;
  }
  ImGui::Dummy({width, legend_height(c)});
}

}  // namespace

float rim_brightness(const LobeCurves& curves) {
  float peak = 0;
  for (const LobeCurves::Curve* curve : {&curves.along, &curves.across, &curves.body, &curves.fuzz})
    peak = std::max(peak, *std::max_element(curve->begin(), curve->end()));
  float rim = 1;
  for (bool three = true; rim < peak && rim < 1000; three = !three) rim *= three ? 3.0f : 10.0f / 3.0f;
  return std::round(rim);
}

float plotted_radius(float brightness, float rim) { return std::cbrt(std::clamp(brightness / rim, 0.0f, 1.0f)); }

LobeCurves lobe_curves(const Lobes& lobes, Linear colour, float light_deg) {
  const YarnLobes whole = yarn_lobes(lobes, colour);
  YarnLobes no_fuzz = whole, specular = whole, fuzz = whole;
  no_fuzz.fuzz = specular.fuzz = 0;
  specular.body = specular.through = glm::vec3(0);
  fuzz.f0 = fuzz.body = fuzz.through = glm::vec3(0);
  fuzz.f90 = 0;
  const auto reflect_specular = [&](glm::vec3 wi, glm::vec3 wo) { return formulas::yarn_reflect(specular, wi, wo); };
  LobeCurves out;
  out.along = curve(light_deg, false, reflect_specular);
  out.across = curve(light_deg, true, reflect_specular);
  out.body = curve(light_deg, false, [&](glm::vec3 wi, glm::vec3 wo) {
    return formulas::yarn_reflect(no_fuzz, wi, wo) - formulas::yarn_reflect(specular, wi, wo);
  });
  out.fuzz = curve(light_deg, false, [&](glm::vec3 wi, glm::vec3 wo) { return formulas::yarn_reflect(fuzz, wi, wo); });
  out.through = curve(light_deg, false, [&](glm::vec3 wi, glm::vec3 wo) {
    return formulas::yarn_transmit(whole, {wi.x, wi.y, -wi.z}, wo);
  });
  return out;
}

float lobes_plot_height(const PanelContext& c, float width) {
  return 2 * c.style.px(kMargin) + radius_for(c, width) * (1 + kLowerHeight) + legend_height(c);
}

void draw_lobes_plot(PanelContext& c, const Lobes& lobes, Rgb colour) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, margin = c.style.px(kMargin);
  Plot plot{{}, radius_for(c, width), 1};
  plot.middle = {at.x + width / 2, at.y + margin + plot.radius};
  hit_area("lobes", {width, 2 * margin + plot.radius * (1 + kLowerHeight)});
  c.map.add_item("yarn.lobes");
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsItemActive()) {
    const float degrees = std::atan2(mouse.x - plot.middle.x, std::max(plot.middle.y - mouse.y, 0.0f)) / kDegree;
    c.wanted.change_settings([light = std::clamp(degrees, -88.0f, 88.0f)](Settings& s) { s.lobe_light_deg = light; });
  }
  const bool highlighted = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (highlighted)
    c.frame.hint = tr("Drag: turn the light. The radius is the cube root of the brightness; 1 is white paper");

  const LobeCurves curves = lobe_curves(lobes, linear_from_srgb(colour), c.settings.lobe_light_deg);
  plot.rim = rim_brightness(curves);
  const Colors& color = c.style.color;
  const ImU32 body_color = blend(to_u32(colour), color.muted, 0.15f);
  draw_axes(c, plot);
  const auto body = points_of(plot, curves.body, false), through = points_of(plot, curves.through, true);
  draw_filled(body, plot.middle, with_alpha(body_color, 0.5f));
  draw_filled(through, plot.middle, with_alpha(body_color, 0.5f));
  draw_line(body, body_color, 1.5f);
  draw_line(through, body_color, 1.5f);
  draw_line(points_of(plot, curves.fuzz, false), color.muted, 1.5f);
  draw_line(points_of(plot, curves.across, false), color.warn, 1.8f);
  draw_line(points_of(plot, curves.along, false), color.accent, 1.8f);
  draw_light(c, plot, highlighted);
  const LegendRow rows[] = {{tr("specular along"), color.accent, false},
                            {tr("across"), color.warn, false},
                            {tr("fuzz"), color.muted, false},
                            {tr("body"), body_color, true}};
  draw_legend(c, rows);
}

}  // namespace weftlight::views
