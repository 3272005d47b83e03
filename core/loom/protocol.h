#pragma once
// Messages between a loom and a program, as text and without any connection: raise these shafts, next pick wanted,
// weave or unweave. Each maker of looms has its own form of them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draft/draft.h"

namespace weftlight::loom {

using draft::BitMatrix, draft::Draft;

/// kPlain: "C0000000f". kSeguin: the same after "=". kToikaEs: four bytes, big-endian, without any reply.
enum class Protocol { kPlain, kSeguin, kToikaEs };

inline constexpr int kMaxLoomShafts = 32;  // eight hexadecimal digits

/// Shafts to raise, bit 0 is shaft 1.
std::string raise_command(Protocol protocol, uint32_t shafts);
/// Tells the loom to weave or to unweave; empty if the protocol has no such command.
std::string direction_command(Protocol protocol, bool weave);

/// One message from the loom.
struct LoomReport {
  enum Kind { kPickWanted, kShaftsRaised, kDirection, kMotion, kUnknown } kind = kUnknown;
  uint32_t shafts = 0;    // kShaftsRaised
  bool on = false;        // kDirection: weaving; kMotion: moving
  std::string text = {};  // kUnknown: the message
};

/// Splits the received bytes into reports at line ends. A line longer than kMaxLineBytes is dropped.
class LoomReader {
 public:
  static constexpr size_t kMaxLineBytes = 64;
  std::vector<LoomReport> parse(std::string_view bytes);

 private:
  std::string line_;
  bool too_long_ = false;
};

/// Shafts that rise in a pick (for a sinking shed: those that the draft does not name). Empty if the draft has more
/// shafts than the protocol can address.
std::optional<uint32_t> raised_shafts(const Draft& draft, const BitMatrix& lifts, int pick);

}  // namespace weftlight::loom
