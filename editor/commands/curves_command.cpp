// `weftlight curves`: the threads of a patch of cloth as geometry, for close-ups in other renderers.

#include <utility>

#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "commands/status_line.h"
#include "draft/drawdown.h"
#include "files/files.h"
#include "reference/cloth_curves.h"
#include "render_data/face_cloth.h"

namespace weftlight::commands {

using base::arg, base::fill, base::message, base::tr;
using cloth::CurveGroup, cloth::Curves, cloth::lay_out;
using design::Design;
using draft::BitMatrix, draft::Face, draft::drawdown;
using reference::CurveDetail, reference::CurveOptions, reference::cloth_curves;
using render_data::choose_period;

namespace {

base::Result<Curves> make(Design design, const CurvesOptions& o) {
  CurveOptions curves;
  curves.low_mm = {o.left_mm, o.lower_mm};
  curves.high_mm = curves.low_mm + glm::vec2(o.width_mm, o.height_mm);
  curves.detail = o.detail == "threads" ? CurveDetail::kThreads
                  : o.detail == "plies" ? CurveDetail::kPlies
                                        : CurveDetail::kFibres;
  curves.seed = static_cast<uint32_t>(o.seed);
  // A nap is hair that stands off the threads; the threads themselves stay as they are woven.
  if (curves.detail == CurveDetail::kFibres) curves.raised = std::exchange(design.finish.raised, 0.0f);
  const BitMatrix cells = drawdown(design.draft);
  return cloth_curves(lay_out(design, cells, Face::kFront, choose_period(design, cells)), curves);
}

}  // namespace

int curves_command(const CurvesOptions& o) {
  const OpenedDesign opened = open_design(o.file);
  if (!opened.ok) return kBadInput;
  StatusLine status;
  status.show(tr("making the curves"));
  const base::Result<Curves> curves = make(opened.design, o);
  status.clear();
  if (!curves) return fail({curves.error().kind, message(curves.error()), o.file});
  if (const auto written = files::write_curves(o.out, *curves); !written) return fail(written.error());
  size_t count = 0, points = 0;
  for (const CurveGroup& group : curves->groups) count += group.points_in.size(), points += group.points.size();
  print_row(o.out, fill(tr("{count} curves, {points} points"), arg("count", count), arg("points", points)));
  return kDone;
}

}  // namespace weftlight::commands
