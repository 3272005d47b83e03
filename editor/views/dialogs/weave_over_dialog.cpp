// A weave over the chosen threads of the draft: the list, its numbers, and the draft itself, which follows while they
// change. Cancel gives back what was there.

#include <imgui.h>

#include <memory>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {
namespace {

constexpr float kListWidth = 190, kHeight = 360, kColumn = 300;  // pixels at 96 dpi

const WeaveKind& kind_of(const WeaveOverPrompt& p) { return weave_kinds()[static_cast<size_t>(p.kind)]; }

/// All steps of the dialog are one step of undo, each made anew from the draft that it found.
MaybeEdit follow(WeaveOverPrompt& p) {
  p.use.weave = kind_of(p).id;
  Made made = with_weave(*p.base, p.use);
  p.why = std::move(made.why);
  return Edit{std::string("Weave ").append(kind_of(p).name),
              [next = std::make_shared<const Design>(std::move(made.design))](const Design&) { return *next; },
              p.stroke};
}

}  // namespace

DialogResult draw_weave_over(PanelContext& c, WeaveOverPrompt& p) {
  DialogResult result;
  heading(c, p.whole ? "Weave over the draft" : "Weave over the selected threads");
  bool other = draw_weave_list(c, p.kind, kListWidth, kHeight);
  if (other || p.use.values.empty()) {
    p.use.values = allowed_values(kind_of(p), {});
    other = true;
  }
  ImGui::SameLine(0, c.style.px(16));
  ImGui::BeginChild("numbers", {c.style.px(kColumn), c.style.px(kHeight)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, kind_of(p).words);
  ImGui::PopTextWrapPos();
  other |= draw_weave_numbers(c, kind_of(p), p.use.values);
  if (other) result.edit = follow(p);
  ImGui::Dummy({0, c.style.px(4)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, p.why);
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  const DialogResult button = dialog_result(draw_buttons(c, {"Keep", "Cancel"}, true));
  result.outcome = button.outcome, result.button = button.button;
  return result;
}

MaybeEdit restored(const WeaveOverPrompt& p) {
  return Edit{"Weave", [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
