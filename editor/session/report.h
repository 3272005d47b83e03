#pragma once
// Analysis of the draft while it is edited: floats, repeat, heddles, separate layers. Computed on its own thread; the
// window shows the last finished report.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/difference.h"
#include "analysis/floats.h"
#include "analysis/threads.h"
#include "analysis/weave_layers.h"
#include "base/tasks.h"
#include "design/repeat.h"
#include "session/document/other_draft.h"

namespace weftlight::session {

using design::Design, design::Repeat;
using draft::BitMatrix, draft::CellRect;

struct Report {
  uint64_t revision = 0;  // of the design
  int limit = 0;          // longest float allowed, in threads
  analysis::LongestFloats longest;
  analysis::LongFloats floats;  // longer than the limit
  BitMatrix front, back;        // picks x ends: crossings in those floats
  Repeat repeat;
  analysis::LoomUse loom;
  size_t layers = 1;  // separate layers, without loose threads
  std::vector<int> loose_ends, loose_picks;

  // Comparison with another draft, which is `a` in `comparison`. Unset without one.
  std::shared_ptr<const OtherDraft> other;
  analysis::Comparison comparison;
  BitMatrix differing;  // picks x ends: crossings that differ
  std::vector<CellRect> places;
};
/// `cells` is the drawdown of the design; `other` may be null.
Report report_on(const Design& design, const BitMatrix& cells, int limit,
                 const std::shared_ptr<const OtherDraft>& other = nullptr);

class Reporter {
 public:
  /// `wake` is called on the other thread when poll() has a result.
  explicit Reporter(std::function<void()> wake = {}) : runner_(std::move(wake)) {}
  /// The newest report, perhaps of an earlier design; null if there is none yet. Starts a new one if it is outdated.
  const Report* on(const std::shared_ptr<const Design>& design, const BitMatrix& cells, uint64_t revision, int limit,
                   const std::shared_ptr<const OtherDraft>& other = nullptr);
  /// The newest report, without starting one.
  const Report* last() const { return report_.get(); }
  /// What the user is told of a request that failed since the last call; empty if none did.
  std::string take_message() { return std::exchange(message_, {}); }
  bool busy() const { return asked_.has_value(); }
  /// True if a report was finished or has failed.
  bool poll() { return runner_.take(); }

 private:
  std::unique_ptr<Report> report_;
  /// The inputs of a requested report.
  struct Asked {
    uint64_t revision = 0;
    int limit = 0;
    std::shared_ptr<const OtherDraft> other;
    bool operator==(const Asked&) const = default;
  };
  void start(const Asked& now, const std::shared_ptr<const Design>& design, const BitMatrix& cells);

  std::optional<Asked> asked_, failed_;  // the request in progress; the last one, if it failed
  std::string message_;
  base::TaskRunner runner_;
};

}  // namespace weftlight::session
