#pragma once
// Colours along threads: painted warps, ikat, space-dyed yarns (yarn.h, Dye).

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "design/design.h"

namespace weftlight::design {

inline constexpr size_t kMaxDyedStretches = 64;
inline constexpr int kMaxDyedThreads = 10'000;  // of one stretch; also of shift and scatter

/// Threads crossed by one sequence; 0 without stretches.
int length_of(const Dye& dye);

/// The colours of one sequence, one for each thread that it crosses. A stretch that fades goes evenly, in OKLab, from
/// its colour to that of the next, the last one to the first. own: the thread's own colour.
std::vector<Rgb> dye_colors(const Dye& dye, Rgb own);

/// Where in the sequence a thread starts, 0..length_of(dye) - 1; always the same for the same thread.
int dye_phase(const Dye& dye, System system, int thread);

/// Within the limits above.
Dye clamped(Dye dye);

/// The stretches as files hold them: "12 #1F3B73, 6 #1F3B73 fades, 20 own".
std::string dye_text(const std::vector<DyedStretch>& stretches);
/// Nothing if the text is not as dye_text() writes it; letters may be of either case.
std::optional<std::vector<DyedStretch>> dye_from_text(std::string_view text);

/// The threads of a design whose colours change along them; empty for most designs.
class DyedThreads {
 public:
  DyedThreads() = default;
  explicit DyedThreads(const Design& design);

  bool empty() const { return tables_.empty(); }
  /// The colour of a thread where it crosses another one, or null for a thread of one colour.
  const Rgb* color(System system, int thread, int crossing) const;

  /// The thread's sequence among tables(), or -1, and its phase.
  int table(System system, int thread) const { return empty() ? -1 : at(system, thread).table; }
  int phase(System system, int thread) const { return empty() ? 0 : at(system, thread).phase; }
  const std::vector<std::vector<Rgb>>& tables() const { return tables_; }
  /// Whether every thread of the system has the same colours again after so many crossings.
  bool repeat_after(System system, int crossings) const;

  bool operator==(const DyedThreads&) const = default;

 private:
  struct Place {
    int table = -1, phase = 0;
    bool operator==(const Place&) const = default;
  };
  const Place& at(System system, int thread) const {
    return threads_[system == System::kWarp ? 0 : 1][static_cast<size_t>(thread)];
  }
  std::array<std::vector<Place>, 2> threads_;
  std::array<std::vector<int>, 2> lengths_;  // of the sequences of each system, each once
  std::vector<std::vector<Rgb>> tables_;
};

/// The colour of a thread where it crosses another one. dyed: of that draft's design.
const Rgb& color_at(const Draft& draft, const DyedThreads& dyed, System system, int thread, int crossing);
/// The same of the thread on top at a crossing.
const Rgb& color_on_top(const Draft& draft, const DyedThreads& dyed, bool warp_up, int end, int pick);

}  // namespace weftlight::design
