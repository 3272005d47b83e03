#include "session/report.h"

#include <utility>

#include "base/text.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr;
using design::design_repeat;
using draft::Face;

namespace {

constexpr int kListedFloats = 500;
constexpr size_t kListedPlaces = 500;

}  // namespace

Report report_on(const Design& design, const BitMatrix& cells, int limit,
                 const std::shared_ptr<const OtherDraft>& other) {
  Report r;
  r.limit = limit;
  r.longest = analysis::longest_floats(cells);
  r.floats = analysis::long_floats(cells, limit, kListedFloats);
  r.front = analysis::crossings_in_floats(cells, limit, Face::kFront);
  r.back = analysis::crossings_in_floats(cells, limit, Face::kBack);
  r.repeat = design_repeat(design, cells);
  r.loom = analysis::loom_use(design.draft);
  r.layers = 0;
  for (const analysis::WeaveLayer& layer : analysis::weave_layers(cells)) {
    if (!layer.loose()) ++r.layers;
    else
      (layer.picks.empty() ? r.loose_ends : r.loose_picks)
          .push_back(layer.picks.empty() ? layer.ends[0] : layer.picks[0]);
  }
  if (other) {
    r.other = other;
    r.comparison = analysis::compare(other->design, design);
    r.differing = analysis::differing_crossings(cells, other->cells);
    r.places = analysis::differing_regions(r.differing, kListedPlaces);
  }
  return r;
}

const Report* Reporter::on(const std::shared_ptr<const Design>& design, const BitMatrix& cells, uint64_t revision,
                           int limit, const std::shared_ptr<const OtherDraft>& other) {
  poll();
  const bool fits = report_ && report_->revision == revision && report_->limit == limit && report_->other == other;
  const Asked now{revision, limit, other};
  // A failed request is not retried until another is made.
  if (!fits && !busy() && failed_ != now) start(now, design, cells);
  return report_.get();
}

void Reporter::start(const Asked& now, const std::shared_ptr<const Design>& design, const BitMatrix& cells) {
  asked_ = now;
  failed_.reset();
  runner_.start(base::task_with_result(
      [now, design, cells](const base::RunningTask&) {
        auto made = std::make_unique<Report>(report_on(*design, cells, now.limit, now.other));
        made->revision = now.revision;
        return made;
      },
      [this](base::Result<std::unique_ptr<Report>> made) {
        const std::optional<Asked> asked = std::exchange(asked_, std::nullopt);
        if (made) {
          report_ = std::move(*made);
          return;
        }
        failed_ = asked;
        message_ = fill(tr("The draft was not analysed: {problem}"), arg("problem", message(made.error())));
      }));
}

}  // namespace weftlight::session
