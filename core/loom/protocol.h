#pragma once
// What a loom and a program say to one another on a line: text in, text out, without any line. The looms' makers
// each have their own words for: raise these shafts, which pick next, weave or unweave.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draft/draft.h"
#include "loom/names.h"

namespace weftlight::loom {

/// kPlain: "C0000000f". kSeguin: the same after "=". kToikaEs: four bytes, big-endian, and nothing comes back.
enum class Protocol { kPlain, kSeguin, kToikaEs };

inline constexpr int kMaxLoomShafts = 32;  // that a line of eight digits can name

/// Shafts to raise, bit 0 is shaft 1.
std::string raise_command(Protocol protocol, uint32_t shafts);
/// Which way the loom goes.
std::string direction_command(Protocol protocol, bool weave);

/// Something that a loom said.
struct LoomReport {
  enum Kind { kPickWanted, kShaftsRaised, kDirection, kMotion, kUnknown } kind = kUnknown;
  uint32_t shafts = 0;    // kShaftsRaised
  bool on = false;        // kDirection: weaving; kMotion: moving
  std::string text = {};  // kUnknown: the line
};

/// Bytes as they come, cut into reports at line ends; a line longer than kLongestLine is dropped whole.
class LoomReader {
 public:
  static constexpr size_t kLongestLine = 64;
  std::vector<LoomReport> take(std::string_view bytes);

 private:
  std::string line_;
  bool too_long_ = false;
};

/// Shafts that rise in a pick, as the loom raises them (of a sinking shed: those that are not named). Nothing where
/// the draft has more shafts than the line can name.
std::optional<uint32_t> raised_shafts(const Draft& draft, const BitMatrix& lifts, int pick);

}  // namespace weftlight::loom
