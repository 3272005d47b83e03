#include "analysis/threads.h"

#include <algorithm>

#include "draft/drawdown.h"

namespace weftlight::analysis {

using draft::ShedControl, draft::differences, draft::for_each_bit, draft::lifts, draft::transposed;

namespace {

std::vector<int> marks_of_columns(const BitMatrix& m) {
  std::vector<int> marks(static_cast<size_t>(m.cols()), 0);
  for (int r = 0; r < m.rows(); ++r) for_each_bit(m.row(r), [&](int c) { ++marks[static_cast<size_t>(c)]; });
  return marks;
}

// Changes of face between each row and the next (cyclic), per crossing.
double interlacings_down(const BitMatrix& m) {
  int64_t changes = 0;
  for (int r = 0; r < m.rows(); ++r) changes += differences(m.row(r), m.row((r + 1) % m.rows()));
  const double crossings = static_cast<double>(m.rows()) * m.cols();
  return crossings > 0 ? static_cast<double>(changes) / crossings : 0;
}

}  // namespace

LoomUse loom_use(const Draft& draft) {
  LoomUse use;
  const BitMatrix named = lifts(draft);
  use.heddles = marks_of_columns(draft.threading);
  use.lifts = marks_of_columns(named);
  for (int e = 0; e < draft.ends(); ++e) {
    const int heddles = draft.threading.count(e);
    use.unthreaded_ends += heddles == 0;
    use.ends_in_several += heddles > 1;
  }
  for (int p = 0; p < draft.picks(); ++p) use.empty_picks += named.first(p) < 0;
  if (draft.shed_control != ShedControl::kTreadling) return use;
  use.treadle_uses = marks_of_columns(draft.treadling);
  for (int p = 0; p < draft.picks(); ++p)
    use.most_treadles_per_pick = std::max(use.most_treadles_per_pick, draft.treadling.count(p));
  return use;
}

Interlacing interlacing(const BitMatrix& cells) {
  return {interlacings_down(cells), interlacings_down(transposed(cells))};
}

double wraps_per_cm(float diameter_mm) { return diameter_mm > 0 ? 10.0 / static_cast<double>(diameter_mm) : 0; }

double sett_per_cm(double wraps, double interlacings) { return wraps / (1 + std::max(interlacings, 0.0)); }

double firm_sett_per_cm(const BitMatrix& cells, const std::vector<WeaveLayer>& layers, double wraps) {
  double sett = 0;
  for (const WeaveLayer& layer : layers) {
    if (layer.loose()) continue;
    BitMatrix own(static_cast<int>(layer.picks.size()), static_cast<int>(layer.ends.size()));
    for (int p = 0; p < own.rows(); ++p)
      for (int e = 0; e < own.cols(); ++e)
        own.set(p, e, cells.get(layer.picks[static_cast<size_t>(p)], layer.ends[static_cast<size_t>(e)]));
    sett += sett_per_cm(wraps, interlacing(own).weft);
  }
  return sett;
}

}  // namespace weftlight::analysis
