#include "views/analysis/analysis_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "analysis/difference.h"
#include "ui/widgets.h"

namespace weftlight::views {
namespace {

using namespace analysis;

void find(const PanelContext& c, AnalysisState& s) {
  s.revision = c.revision;
  s.layers = layers(c.cells);
  s.loom = loom_use(c.design.draft);
  s.fewest = fewest_for(c.cells);
  s.interlacings = interlacing(c.cells);
  s.yarn = yarn_report(c.design, {});
}

void fact(const PanelContext& c, const char* label, const std::string& value, const char* tip = "") {
  row_label(c, label, tip);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
}

void draw_layers(const PanelContext& c, const AnalysisState& s) {
  if (s.layers.size() <= 1) return fact(c, "Hangs together", "yes", "No thread can be lifted off the others");
  int loose = 0;
  for (const Layer& layer : s.layers) loose += layer.loose();
  fact(c, "Comes apart", "into " + std::to_string(s.layers.size()) + " layers",
       "Layers and loose threads that nothing binds to the rest, front to back");
  constexpr int kMax = 6;
  int shown = 0;
  for (const Layer& layer : s.layers) {
    if (++shown > kMax) return fact(c, "", "and more");
    std::string text;
    if (!layer.ends.empty()) text += "ends " + listed(layer.ends);
    if (!layer.picks.empty()) text.append(text.empty() ? "" : "; ").append("picks ").append(listed(layer.picks));
    fact(c, layer.loose() ? "Loose" : "Layer", fitted(text, ImGui::GetContentRegionAvail().x * 2));
  }
}

void draw_loom(const PanelContext& c, const AnalysisState& s) {
  fact(c, "Fewest", std::to_string(s.fewest.shafts) + " shafts, " + std::to_string(s.fewest.treadles) + " treadles",
       "That this drawdown can be woven with, one treadle a pick");
  if (s.loom.unthreaded_ends > 0) fact(c, "On no shaft", std::to_string(s.loom.unthreaded_ends) + " ends");
  if (s.loom.empty_picks > 0) fact(c, "Lift nothing", std::to_string(s.loom.empty_picks) + " picks");
}

void draw_yarn_use(const PanelContext& c, const AnalysisState& s) {
  char text[96];
  std::snprintf(text, sizeof text, "%.1f ends, %.1f picks a cm", s.yarn.ends_per_cm, s.yarn.picks_per_cm);
  fact(c, "Sett", text);
  const double wraps = wraps_per_cm(c.design.yarns.front().diameter_mm);
  std::snprintf(text, sizeof text, "%.1f a cm (%.1f wraps)", sett_per_cm(wraps, s.interlacings.weft), wraps);
  fact(c, "From wraps", text, "Ends a cm on the loom for a firm cloth of the first yarn in this weave (Ashenhurst)");
}

}  // namespace

void draw_analysis(PanelContext& c, AnalysisState& s) {
  if (!section(c, "section.analysis", "Loom and yarn")) return;
  const Draft& d = c.design.draft;
  if (s.revision != c.revision) {
    const bool live = int64_t{d.ends()} * d.picks() <= kLiveCrossings;
    if (live || text_button(c, "analysis.find", "Analyse", "Layers, loom and yarn of this large draft")) find(c, s);
  }
  if (s.revision == 0) return;
  draw_layers(c, s);
  draw_loom(c, s);
  draw_yarn_use(c, s);
}

}  // namespace weftlight::views
