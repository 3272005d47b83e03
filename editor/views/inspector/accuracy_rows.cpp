#include "views/inspector/accuracy_rows.h"

#include "ui/widgets.h"

namespace weftlight::views {

MaybeEdit draw_accuracy(PanelContext& c) {
  if (c.design.look.method != Method::kAuto) return {};
  constexpr const char* kWays[] = {"By error", "By time"};
  int way = c.settings.by_time ? 1 : 0;
  row_label(c, "Picture", "What rules: how far the picture may be off, or how long it may take on this machine");
  if (segmented(c, "look.by", kWays, way)) c.wanted.add_action("by_time");
  if (c.settings.by_time) {
    constexpr SliderSpec kTime{
        "look.budget_ms",
        "Milliseconds",
        kMinPictureMs,
        1000,
        "%.0f ms",
        "What the cloth of a picture at rest may take; the error is the least that can be had for it",
        true,
        kMinPictureMs,
        kMaxPictureMs};
    float ms = c.settings.picture_ms;
    if (slider(c, kTime, ms)) c.wanted.change_settings([ms](Settings& s) { s.picture_ms = ms; });
    return {};
  }
  constexpr SliderSpec kTolerance{
      "look.tolerance",
      "Error allowed",
      0.05f,
      0.3f,
      "%.2f",
      "What the picture may be off by: the smaller, the finer its methods. 0.05 is 5% of the "
      "brightness",
      true,
      0.01f,
      0.5f};
  float tolerance = c.design.look.tolerance;
  if (!slider(c, kTolerance, tolerance)) return {};
  return Edit{"Error allowed", [tolerance](Design d) {
                d.look.tolerance = tolerance;
                return d;
              }};
}

}  // namespace weftlight::views
