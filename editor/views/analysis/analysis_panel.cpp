#include "views/analysis/analysis_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "analysis/difference.h"
#include "analysis/plan_texts.h"
#include "base/text.h"
#include "ui/widgets.h"

namespace weftlight::views {

using analysis::Units, analysis::WeaveLayer, analysis::cloth_measures, analysis::deviation_text, analysis::kInch_mm,
    analysis::sett_text, analysis::loom_use, analysis::firm_sett_per_cm, analysis::mean_thread, analysis::thread_list,
    analysis::weave_layers, analysis::wraps_per_cm;
using base::arg, base::fill, base::tr, base::tr_n;
using draft::Draft, draft::System, draft::fewest_for;
using ui::fitted, ui::row_label, ui::section, ui::text_button;

namespace {

void analyse(const PanelContext& c, AnalysisState& s) {
  s.revision = c.revision;
  s.layers = weave_layers(c.cells);
  s.loom = loom_use(c.design.draft);
  s.fewest = fewest_for(c.cells);
  s.firm_sett = firm_sett_per_cm(c.cells, s.layers, 1);
  s.wraps = wraps_per_cm(static_cast<float>(mean_thread(c.design, System::kWarp).spun_mm));
  s.measures = cloth_measures(c.design);
}

void fact(const PanelContext& c, const char* label, const std::string& value, const char* tip = "") {
  row_label(c, label, tip);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
}

/// "one connected cloth", "2 separate layers", "1 layer, 3 loose threads".
std::string layers_text(const std::vector<WeaveLayer>& layers) {
  if (layers.size() <= 1) return tr("one connected cloth");
  const auto loose =
      static_cast<int>(std::count_if(layers.begin(), layers.end(), [](const WeaveLayer& l) { return l.loose(); }));
  const int bound = static_cast<int>(layers.size()) - loose;
  std::string threads = fill(tr_n("{count} loose thread", "{count} loose threads", loose), arg("count", loose));
  if (bound == 0) return threads;
  std::string text = fill(tr_n("{count} layer", "{count} separate layers", bound), arg("count", bound));
  return loose == 0 ? text : fill(tr("{layers}, {threads}"), arg("layers", text), arg("threads", threads));
}

/// "ends 1-4; picks 2, 3".
std::string threads_text(const WeaveLayer& layer) {
  if (layer.picks.empty()) return fill(tr("ends {ends}"), arg("ends", thread_list(layer.ends)));
  if (layer.ends.empty()) return fill(tr("picks {picks}"), arg("picks", thread_list(layer.picks)));
  return fill(tr("ends {ends}; picks {picks}"), arg("ends", thread_list(layer.ends)),
              arg("picks", thread_list(layer.picks)));
}

void draw_layers(const PanelContext& c, const AnalysisState& s) {
  if (s.layers.size() <= 1)
    return fact(c, tr("Layers"), layers_text(s.layers), tr("No thread can be lifted off the others"));
  fact(c, tr("Layers"), layers_text(s.layers),
       tr("Layers and loose threads that nothing binds to the rest, front to back"));
  constexpr int kMax = 6;
  int shown = 0;
  for (const WeaveLayer& layer : s.layers) {
    if (++shown > kMax) return fact(c, "", tr("and more"));
    fact(c, layer.loose() ? tr("Loose") : tr("Layer"),
         fitted(threads_text(layer), ImGui::GetContentRegionAvail().x * 2));
  }
}

void draw_loom(const PanelContext& c, const AnalysisState& s) {
  const int shafts = s.fewest.shafts, treadles = s.fewest.treadles, ends = s.loom.unthreaded_ends,
            picks = s.loom.empty_picks;
  fact(c, tr("Minimum"),
       fill(tr("{shafts}, {treadles}"),
            arg("shafts", fill(tr_n("{count} shaft", "{count} shafts", shafts), arg("count", shafts))),
            arg("treadles", fill(tr_n("{count} treadle", "{count} treadles", treadles), arg("count", treadles)))),
       tr("The smallest loom that weaves this drawdown with one treadle per pick"));
  if (ends > 0) fact(c, tr("Unthreaded"), fill(tr_n("{count} end", "{count} ends", ends), arg("count", ends)));
  if (picks > 0) fact(c, tr("Empty sheds"), fill(tr_n("{count} pick", "{count} picks", picks), arg("count", picks)));
}

/// The sett on the loom beside the firm one, which is also meant for the loom.
void draw_loom_sett(const PanelContext& c, const AnalysisState& s) {
  const double firm = s.wraps * s.firm_sett, own = s.measures.loom_ends_per_cm;
  if (firm <= 0 || own <= 0) return;
  fact(
      c, tr("On the loom"),
      fill(tr("{sett}, {deviation}"), arg("sett", sett_text(own, System::kWarp, units_of(c.settings))),
           arg("deviation", deviation_text(own / firm - 1))),
      tr("The sett on the loom, by the plan, and how far it is from the firm one. The further above, the more the warp "
         "hides the weft, and the harder the weft is to beat in"));
  c.map.add_item("analysis.loom_sett");
}

void draw_setts(const PanelContext& c, const AnalysisState& s) {
  const Units units = units_of(c.settings);
  fact(c, tr("Sett"),
       fill(tr("{ends}, {picks}"), arg("ends", sett_text(s.measures.draft_ends_per_cm, System::kWarp, units)),
            arg("picks", sett_text(s.measures.draft_picks_per_cm, System::kWeft, units))),
       tr("As drawn. The Plan page has the setts on the loom and in the finished cloth"));
  fact(c, tr("Firm sett"),
       fill(units == Units::kImperial ? tr("{sett}, from {wraps:.1f} wraps per inch")
                                      : tr("{sett}, from {wraps:.1f} wraps per cm"),
            arg("sett", sett_text(s.wraps * s.firm_sett, System::kWarp, units)),
            arg("wraps", units == Units::kImperial ? s.wraps * kInch_mm / 10 : s.wraps)),
       tr("On the loom, for a firm cloth of these ends in this weave (Ashenhurst); in all layers together"));
  draw_loom_sett(c, s);
}

}  // namespace

void draw_analysis(PanelContext& c, AnalysisState& s) {
  if (!section(c, "section.analysis", tr("Loom and sett"))) return;
  const Draft& d = c.design.draft;
  if (s.revision != c.revision) {
    const bool live = int64_t{d.ends()} * d.picks() <= kLiveCrossings;
    if (live || text_button(c, "analysis.find", tr("Analyse"), tr("Large drafts are analysed on request")))
      analyse(c, s);
  }
  if (s.revision == 0) return;
  draw_layers(c, s);
  draw_loom(c, s);
  draw_setts(c, s);
}

}  // namespace weftlight::views
