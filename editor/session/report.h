#pragma once
// What the weaver wants to know of the draft while it is painted: floats, repeat, heddles, whether the cloth hangs
// together. Worked out on a thread of its own; the window shows the last that is done.

#include <cstdint>
#include <future>
#include <memory>
#include <vector>

#include "analysis/difference.h"
#include "analysis/floats.h"
#include "analysis/threads.h"
#include "analysis/weave_layers.h"
#include "draft/repeat.h"
#include "session/names.h"
#include "session/other_draft.h"

namespace weftlight::session {

struct Report {
  uint64_t revision = 0;  // of the design
  int limit = 0;          // threads that a float may cross
  analysis::LongestFloats longest;
  analysis::LongFloats floats;  // beyond the limit
  BitMatrix front, back;        // picks x ends: crossings that lie in them
  Repeat repeat;
  analysis::LoomUse loom;
  size_t layers = 1;  // that the cloth comes apart into, loose threads not counted
  std::vector<int> loose_ends, loose_picks;

  // Where it is held against another draft, which is `a` where they differ.
  std::shared_ptr<const OtherDraft> other;
  analysis::Comparison comparison;
  BitMatrix differing;  // picks x ends: crossings that are others there
  std::vector<CellRect> places;
};
/// Of `cells`, the design's drawdown. `other`: null: none.
Report report_on(const Design& design, const BitMatrix& cells, int limit,
                 const std::shared_ptr<const OtherDraft>& other = nullptr);

class Reporter {
 public:
  /// The newest report, perhaps of an earlier design; null: none yet. Starts on what it is not about.
  const Report* on(const std::shared_ptr<const Design>& design, const BitMatrix& cells, uint64_t revision, int limit,
                   const std::shared_ptr<const OtherDraft>& other = nullptr);
  /// The same without starting anything.
  const Report* last() const { return report_.get(); }
  bool busy() const { return work_.valid(); }
  /// True when a report has come.
  bool poll();

 private:
  std::unique_ptr<Report> report_;
  std::future<std::unique_ptr<Report>> work_;
};

}  // namespace weftlight::session
