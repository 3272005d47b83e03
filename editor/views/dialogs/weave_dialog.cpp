// The weave of a new draft: the list of weaves, the parameters, and a preview of the drawdown.

#include <imgui.h>

#include <algorithm>
#include <memory>
#include <string>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr;
using draft::kMaxThreads;
using ui::begin_list, ui::muted_text;
using weaves::ClothSize, weaves::WeaveKind, weaves::allowed_values, weaves::repeat_of, weaves::weave_kinds,
    weaves::whole_repeats;

namespace {

constexpr float kListWidth = 176, kHeight = 428, kColumn = 320, kPicture = 192, kLeastPicture = 96;  // pixels at 96 dpi

const WeaveKind& kind_of(const WeavePrompt& p) { return weave_kinds()[static_cast<size_t>(p.kind)]; }

/// After a change of the weave: rounds the size to whole repeats, unless it was typed.
void update_size(WeavePrompt& p) {
  if (!check_values(kind_of(p), p.values)) return;
  p.repeat = repeat_of(kind_of(p), p.values);
  if (p.own_size) return;
  const ClothSize whole = whole_repeats(p.repeat, {p.ends, p.picks});
  p.ends = whole.ends, p.picks = whole.picks;
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

WeavePrompt prompt_for(int kind, ClothSize about) {
  WeavePrompt p;
  p.kind = kind, p.ends = about.ends, p.picks = about.picks;
  p.values = allowed_values(kind_of(p), {});
  update_size(p);
  return p;
}

DialogResult draw_prompt(PanelContext& c, WeavePrompt& p) {
  heading(c, tr("New draft"));
  if (draw_weave_list(c, p.kind, p.typed, kListWidth, kHeight)) {
    p.values = allowed_values(kind_of(p), {});
    update_size(p);
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
  if (draw_weave_numbers(c, kind, p.values)) update_size(p);
  const int ends = p.ends, picks = p.picks;
  number(c, "weave.ends", tr("Ends"), p.ends, 1, kMaxThreads);
  number(c, "weave.picks", tr("Picks"), p.picks, 1, kMaxThreads);
  p.own_size = p.own_size || ends != p.ends || picks != p.picks;
  draw_needs(c, p);
  if (refused.empty()) p.below = ImGui::GetCursorPosY() - top;  // else the kept picture would be stretched
  ImGui::EndChild();
  return dialog_result(
      draw_buttons(c, {mark("Create"), mark("Cancel")}, true, refused.empty() && !found_weaves(p.typed).empty()));
}

}  // namespace weftlight::views
