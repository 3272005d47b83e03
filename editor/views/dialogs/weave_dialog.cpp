// The weave of a new draft: the list of weaves, the parameters, yarn and sett, and a preview of the drawdown.

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "base/text.h"
#include "design/yarn_presets.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

using analysis::firm_sett, analysis::kInch_mm, analysis::with_loom_sett;
using base::arg, base::fill, base::mark, base::tr;
using design::Yarn, design::ready_yarns;
using draft::kMaxThreads;
using ui::begin_combo, ui::begin_list, ui::end_combo, ui::muted_text, ui::row_label;
using weaves::ClothSize, weaves::WeaveKind, weaves::allowed_values, weaves::new_draft, weaves::repeat_of,
    weaves::weave_kinds, weaves::whole_repeats, weaves::with_ground_yarn;

namespace {

constexpr float kListWidth = 176, kHeight = 460, kColumn = 320, kPicture = 192, kLeastPicture = 64;  // pixels at 96 dpi

constexpr int kMostThreads = 256;  // from which the firm sett of a weave with a long repeat, or none, is computed

const WeaveKind& kind_of(const WeavePrompt& p) { return weave_kinds()[static_cast<size_t>(p.kind)]; }

/// After a change of the weave: rounds the size to whole repeats, unless it was typed.
void update_size(WeavePrompt& p) {
  if (!check_values(kind_of(p), p.values)) return;
  p.repeat = repeat_of(kind_of(p), p.values);
  if (p.own_size) return;
  const ClothSize whole = whole_repeats(p.repeat, {p.ends, p.picks});
  p.ends = whole.ends, p.picks = whole.picks;
}

Design woven_in_yarn(const WeavePrompt& p, ClothSize size) {
  return with_ground_yarn(new_draft(kind_of(p), p.values, size).design, ready_yarns()[static_cast<size_t>(p.yarn)]);
}

/// The picks keep their proportion to the ends.
int picks_beside(const LoomSett& firm, int ends) {
  return std::max(1, static_cast<int>(std::lround(static_cast<double>(firm.picks) * ends / firm.ends)));
}

/// After a change of the weave or the yarn: the firm sett, unless one was typed.
void update_sett(WeavePrompt& p) {
  if (!check_values(kind_of(p), p.values)) return;
  const auto some = [](int repeat) { return repeat > 0 ? std::min(repeat, kMostThreads) : kMostThreads; };
  p.firm = firm_sett(woven_in_yarn(p, {some(p.repeat.ends), some(p.repeat.picks)}), p.units);
  if (!p.own_sett) p.sett.ends = p.firm.ends;
  p.sett.picks = picks_beside(p.firm, p.sett.ends);
}

void update(WeavePrompt& p) {
  update_size(p);
  update_sett(p);
}

void draw_yarn(PanelContext& c, WeavePrompt& p) {
  const auto yarns = ready_yarns();
  row_label(c, tr("Yarn"), tr("For warp and weft. You can change it later on the Yarns page"));
  ImGui::SetNextItemWidth(c.style.px(190));
  if (!begin_combo(c, "weave.yarn", tr(yarns[static_cast<size_t>(p.yarn)].name.c_str()))) return;
  const int before = p.yarn;
  for (int i = 0; i < static_cast<int>(yarns.size()); ++i) {
    const Yarn& yarn = yarns[static_cast<size_t>(i)];
    if (ImGui::Selectable(tr(yarn.name.c_str()), i == p.yarn)) p.yarn = i;
    c.map.add_item("weave.yarn:" + yarn.name);
  }
  end_combo();
  if (p.yarn != before) update_sett(p);
}

/// Of the loom, in whole ends.
void draw_sett(PanelContext& c, WeavePrompt& p) {
  const bool inches = p.units == Units::kImperial;
  const int before = p.sett.ends;
  number(c, "weave.sett", inches ? tr("Ends per inch") : tr("Ends per cm"), p.sett.ends, 1,
         static_cast<int>(static_cast<double>(design::kMaxSettPerCm) * (inches ? kInch_mm / 10 : 1)),
         tr("Sett on the loom. Firm for this weave and yarn, until you set another; the picks follow"));
  if (p.sett.ends == before) return;
  p.own_sett = true;
  p.sett.picks = picks_beside(p.firm, p.sett.ends);
}

/// Of the repeat and the loom. Also tells if the size cuts off the last repeat.
void draw_needs(PanelContext& c, const WeavePrompt& p) {
  muted_text(c, fill(tr("Shafts: {shafts}, treadles: {treadles}"), arg("shafts", p.preview->shafts()),
                     arg("treadles", p.preview->treadles())));
  if (p.repeat.ends <= 0 || p.repeat.picks <= 0) return;
  const bool cut = p.ends % p.repeat.ends != 0 || p.picks % p.repeat.picks != 0;
  const char* text =
      cut ? tr("Repeat: {ends} \xC3\x97 {picks}; the last one is cut off") : tr("Repeat: {ends} \xC3\x97 {picks}");
  muted_text(c, fill(text, arg("ends", p.repeat.ends), arg("picks", p.repeat.picks)));
  c.map.add_item("weave.repeat");
}

/// What the weave is; or what is wrong with its values.
void draw_description(PanelContext& c, const WeaveKind& kind, const std::string& refused, const std::string& why) {
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  if (refused.empty()) {
    muted_text(c, why.empty() ? tr(kind.description) : why);
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
    ImGui::TextUnformatted(refused.c_str());
    ImGui::PopStyleColor();
    c.map.add_item("weave.refused");
  }
  ImGui::PopTextWrapPos();
}

}  // namespace

WeavePrompt prompt_for(int kind, ClothSize about, Units units) {
  WeavePrompt p;
  p.kind = kind, p.ends = about.ends, p.picks = about.picks, p.units = units;
  p.values = allowed_values(kind_of(p), {});
  update(p);
  return p;
}

Design new_design(const WeavePrompt& p) { return with_loom_sett(woven_in_yarn(p, {p.ends, p.picks}), p.sett, p.units); }

DialogResult draw_prompt(PanelContext& c, WeavePrompt& p) {
  heading(c, tr("New draft"));
  if (draw_weave_list(c, p.kind, p.typed, kListWidth, kHeight)) {
    p.values = allowed_values(kind_of(p), {});
    update(p);
  }
  ImGui::SameLine(0, c.style.px(16));
  begin_list("weave", {c.style.px(kColumn) + ImGui::GetStyle().ScrollbarSize, c.style.px(kHeight)});
  const WeaveKind& kind = kind_of(p);
  if (!p.preview) p.preview = std::make_shared<WeavePreview>();
  // Lower beside a weave with many parameters, so that nothing below is cut.
  const float room = c.style.px(kHeight) - p.below;
  p.preview->draw(c, kind, p.values, p.repeat, c.style.px(kColumn),
                  std::clamp(room, c.style.px(kLeastPicture), c.style.px(kPicture)));
  c.map.add_item("weave.drawdown");
  const float top = ImGui::GetCursorPosY();
  const std::string refused = problem_of(check_values(kind, p.values));
  ImGui::Dummy({0, c.style.px(2)});
  draw_description(c, kind, refused, p.preview->note());
  if (draw_weave_numbers(c, kind, p.values)) update(p);
  const int ends = p.ends, picks = p.picks;
  number(c, "weave.ends", tr("Ends"), p.ends, 1, kMaxThreads);
  number(c, "weave.picks", tr("Picks"), p.picks, 1, kMaxThreads);
  p.own_size = p.own_size || ends != p.ends || picks != p.picks;
  draw_yarn(c, p);
  draw_sett(c, p);
  draw_needs(c, p);
  if (refused.empty()) p.below = ImGui::GetCursorPosY() - top;  // else the kept picture would be stretched
  ImGui::EndChild();
  return dialog_result(
      draw_buttons(c, {mark("Create"), mark("Cancel")}, true, refused.empty() && !found_weaves(p.typed).empty()));
}

}  // namespace weftlight::views
