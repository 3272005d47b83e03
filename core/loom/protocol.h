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

/// kPlain: "C0000000f". kSeguin: the same after "=". kToikaEs: four bytes, big-endian, without any reply. kAvl3: the
/// Compu-Dobby II and III of AVL, four shafts to a byte. kAvl4: the Compu-Dobby IV, in words: "pick 1,3".
enum class Protocol { kPlain, kSeguin, kToikaEs, kAvl3, kAvl4 };

/// Whether the loom takes the shafts of the next pick while the shed is open, and fixes them when it closes.
inline bool takes_picks_ahead(Protocol protocol) { return protocol == Protocol::kAvl3 || protocol == Protocol::kAvl4; }

inline constexpr int kMaxLoomShafts = 32;  // eight hexadecimal digits

/// Shafts to raise, bit 0 is shaft 1.
std::string raise_command(Protocol protocol, uint32_t shafts);
/// Tells the loom to weave or to unweave; empty if the protocol has no such command.
std::string direction_command(Protocol protocol, bool weave);

/// What begins a connection; empty if the protocol has no such message.
std::string greeting(Protocol protocol);
/// What a loom of kAvl4 wants to hear before it takes picks: the same word on all of them.
std::string password_command();

/// One message from the loom.
struct LoomReport {
  enum Kind {
    kPickWanted,
    kShaftsRaised,
    kDirection,
    kMotion,
    kReady,  // it has heard the greeting
    kPasswordWanted,
    kShedClosed,     // the shafts that were sent last are fixed: the next shed
    kShedOpen,       // it takes the shafts of the pick after this
    kNegativeDobby,  // what is sent would stay down
    kUnknown
  } kind = kUnknown;
  uint32_t shafts = 0;    // kShaftsRaised
  bool on = false;        // kDirection: weaving; kMotion: moving
  std::string text = {};  // kUnknown: the message, in printable ASCII
};

/// Splits the received bytes into reports, at line ends or at what ends a message of the protocol. Of a line longer
/// than kMaxLineBytes the start is reported at once, as unknown, and the rest dropped.
class LoomReader {
 public:
  static constexpr size_t kMaxLineBytes = 64;
  explicit LoomReader(Protocol protocol = Protocol::kPlain) : protocol_(protocol) {}
  std::vector<LoomReport> parse(std::string_view bytes);

 private:
  Protocol protocol_;
  std::string line_;
  bool too_long_ = false;
};

/// Shafts that rise in a pick (for a sinking shed: those that the draft does not name). Empty if the draft has more
/// shafts than the protocol can address.
std::optional<uint32_t> raised_shafts(const Draft& draft, const BitMatrix& lifts, int pick);

}  // namespace weftlight::loom
