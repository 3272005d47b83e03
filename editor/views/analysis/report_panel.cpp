#include "views/analysis/report_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "analysis/warping.h"
#include "base/text.h"
#include "session/editing/selection_state.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using analysis::cloth_measures, analysis::heddles_for;
using base::arg, base::fill, base::tr, base::tr_in, base::tr_n;
using design::Design;
using draft::BitGrid, draft::Draft, draft::Face, draft::System, draft::clipped;
using session::Cell, session::DocumentView, session::MaybeEdit, session::scroll_to, session::select_cells,
    session::selection_between;
using ui::begin_rows, ui::blend, ui::end_rows, ui::muted_text, ui::row_label, ui::section, ui::slider;

namespace {

using Panel = ViewContext<AnalysisView>;

constexpr float kListHeight = 168;  // pixels at 96 dpi
constexpr size_t kShownHeddles = 64;

void fact(const PanelContext& c, const char* label, const std::string& text, const char* tip) {
  row_label(c, label, tip);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

/// Scrolls to a float and selects its crossings.
void show_float(PanelContext& c, const analysis::Float& f) {
  const Draft& d = c.design.draft;
  const bool warp = f.system == System::kWarp;
  const int across = warp ? d.picks() : d.ends(), last = std::min(f.first + f.length, across) - 1;
  const Cell from = warp ? Cell{f.thread, f.first} : Cell{f.first, f.thread};
  const Cell to = warp ? Cell{f.thread, last} : Cell{last, f.thread};
  c.wanted.gesture(
      [=, system = f.system, thread = f.thread, middle = (f.first + last) / 2](DocumentView& v, const Design& now) {
        scroll_to(v.draft, system, thread);
        scroll_to(v.draft, warp ? System::kWeft : System::kWarp, middle);
        select_cells(v.select, clipped(selection_between(BitGrid::kDrawdown, from, to), now.draft));
        return MaybeEdit();
      });
}

void draw_float_list(PanelContext& c, const Report& r) {
  if (r.floats.listed.empty()) return;
  ImGui::BeginChild("floats", {0, c.style.px(kListHeight)});
  begin_rows(c);
  ImGuiListClipper rows;
  rows.Begin(static_cast<int>(r.floats.listed.size()));
  while (rows.Step()) {
    for (int i = rows.DisplayStart; i < rows.DisplayEnd; ++i) {
      const analysis::Float& f = r.floats.listed[static_cast<size_t>(i)];
      const int threads = f.system == System::kWarp ? c.design.draft.picks() : c.design.draft.ends();
      ImGui::PushID(i);
      if (ImGui::Selectable(float_text(f, threads).c_str())) show_float(c, f);
      ImGui::PopID();
      c.map.add_item("float:" + std::to_string(i + 1));
    }
  }
  end_rows();
  ImGui::EndChild();
}

void draw_floats(Panel& c, const Report* r) {
  float limit = static_cast<float>(c.view.float_limit);
  if (slider(c, {"floats.limit", tr("Maximum"), 1, 30, "%.0f", tr("Longest float allowed, in threads crossed")}, limit))
    c.wanted.change_view([max = std::clamp(static_cast<int>(std::lround(limit)), 1, 30)](DocumentView& v) {
      v.analysis.float_limit = max;
    });
  row_label(c, tr("Highlight"), tr("Tint floats over the maximum in the drawdown"));
  bool show = c.view.show_floats;
  if (ImGui::Checkbox("##show", &show))
    c.wanted.change_view([show](DocumentView& v) { v.analysis.show_floats = show; });
  c.map.add_item("floats.show");
  if (r == nullptr) return muted_text(c, tr("Counting\xE2\x80\xA6"));
  const auto& l = r->longest;
  fact(c, tr("Longest"),
       fill(tr("warp {front} front, {back} back"), arg("front", l.warp_front), arg("back", l.warp_back)),
       tr("Threads crossed. The cloth repeats, so floats run on over its edges"));
  fact(c, "", fill(tr("weft {front} front, {back} back"), arg("front", l.weft_front), arg("back", l.weft_back)),
       nullptr);
  const int64_t count = r->floats.count;
  fact(c, tr("Too long"),
       count == 0 ? std::string(tr("none")) : fill(tr_n("{count} float", "{count} floats", count), arg("count", count)),
       tr("Floats over the maximum, longest first. Click one to show it"));
  c.map.add_item("floats.count");
  draw_float_list(c, *r);
}

/// Those of the planned cloth.
void draw_heddles(PanelContext& c, const analysis::LoomUse& use) {
  const int64_t planned = cloth_measures(c.design).ends;
  const std::vector<int64_t> heddles = heddles_for(c.design.draft, planned).on_shaft;
  const int64_t max_heddles = heddles.empty() ? 1 : std::max<int64_t>(1, std::ranges::max(heddles));
  muted_text(c, fill(tr_n("For the {count} end of the plan", "For the {count} ends of the plan", planned),
                     arg("count", planned)));
  const float height = ImGui::GetTextLineHeight();
  for (size_t shaft = 0; shaft < std::min(kShownHeddles, heddles.size()); ++shaft) {
    row_label(c, fill(tr("Shaft {number}"), arg("number", shaft + 1)).c_str(), nullptr);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float figure = c.style.px(52), room = std::max(1.0f, ImGui::GetContentRegionAvail().x - figure);
    const float length = room * static_cast<float>(heddles[shaft]) / static_cast<float>(max_heddles);
    const float top = at.y + ImGui::GetStyle().FramePadding.y;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top + 2}, {at.x + std::max(1.0f, length), top + height - 2},
                                              blend(c.style.color.panel, c.style.color.accent, 0.6f), c.style.px(3));
    ImGui::SetCursorScreenPos({at.x + room + c.style.px(8), at.y});
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(std::to_string(heddles[shaft]).c_str());
  }
  const int ends = use.unthreaded_ends, picks = use.empty_picks;
  if (ends > 0)
    muted_text(c, fill(tr_n("{count} end is not threaded", "{count} ends are not threaded", ends), arg("count", ends)));
  if (picks > 0)
    muted_text(c, fill(tr_n("{count} pick lifts no shaft", "{count} picks lift no shaft", picks), arg("count", picks)));
}

}  // namespace

std::string float_text(const analysis::Float& f, int threads) {
  const bool warp = f.system == System::kWarp;
  const int last = (f.first + f.length - 1) % std::max(1, threads);
  const bool over = f.face == Face::kFront;
  const char* text = warp   ? over ? tr("End {thread} over picks {first}\xE2\x80\x93{last}: {length}")
                                   : tr("End {thread} under picks {first}\xE2\x80\x93{last}: {length}")
                       : over ? tr("Pick {thread} over ends {first}\xE2\x80\x93{last}: {length}")
                            : tr("Pick {thread} under ends {first}\xE2\x80\x93{last}: {length}");
  return fill(text, arg("thread", f.thread + 1), arg("first", f.first + 1), arg("last", last + 1),
              arg("length", f.length));
}

void draw_report(const PanelContext& panel, const AnalysisView& view, const Report* r) {
  Panel c{panel, view};
  if (section(c, "section.floats", tr("Floats"))) draw_floats(c, r);
  if (r == nullptr) return;
  if (section(c, "section.weave", tr("Weave"))) {
    const int ends = r->repeat.ends, picks = r->repeat.picks;
    fact(c, tr_in("of the weave", "Repeat"),
         fill(tr("{ends} \xC3\x97 {picks}"),
              arg("ends", fill(tr_n("{count} end", "{count} ends", ends), arg("count", ends))),
              arg("picks", fill(tr_n("{count} pick", "{count} picks", picks), arg("count", picks)))),
         tr("The smallest repeat of weave and colours"));
  }
  if (section(c, "section.heddles", tr("Heddles"))) draw_heddles(c, r->loom);
}

}  // namespace weftlight::views
