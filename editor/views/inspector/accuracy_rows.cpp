#include "views/inspector/accuracy_rows.h"

#include "base/text.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::mark, base::tr;
using design::Design, design::Method;
using session::Edit, session::Settings, session::kMaxPictureMs, session::kMinPictureMs;
using ui::SliderSpec, ui::row_label, ui::segmented, ui::slider;

MaybeEdit draw_accuracy(PanelContext& c) {
  if (c.design.look.method != Method::kAuto) return {};
  constexpr const char* kWays[] = {mark("By error"), mark("By time")};
  int way = c.settings.by_time ? 1 : 0;
  row_label(c, tr("Accuracy"), tr("What limits the picture: its error, or the time it takes on this machine"));
  if (segmented(c, "look.by", kWays, way)) c.wanted.add_action("by_time");
  if (c.settings.by_time) {
    const SliderSpec time{"look.budget_ms",
                          tr("Time limit"),
                          kMinPictureMs,
                          1000,
                          tr("%.0f ms"),
                          tr("For a still picture of the cloth; the error is the smallest possible in that time"),
                          true,
                          kMinPictureMs,
                          kMaxPictureMs};
    float ms = c.settings.picture_ms;
    if (slider(c, time, ms)) c.wanted.change_settings([ms](Settings& s) { s.picture_ms = ms; });
    return {};
  }
  const SliderSpec limit{
      "look.tolerance",
      tr("Error limit"),
      0.05f,
      0.3f,
      "%.2f",
      tr("Largest error of the picture; smaller values use finer methods. 0.05 is 5% of the brightness"),
      true,
      0.01f,
      0.5f};
  float tolerance = c.design.look.tolerance;
  if (!slider(c, limit, tolerance)) return {};
  return Edit{tr("Change error limit"), [tolerance](Design d) {
                d.look.tolerance = tolerance;
                return d;
              }};
}

}  // namespace weftlight::views
