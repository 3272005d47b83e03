// Any bytes from a loom, in any pieces: parsing never crashes and gives the same reports as in one piece.

#include <cstdint>
#include <string_view>
#include <vector>

#include "loom/protocol.h"
#include "require.h"

using weftlight::loom::LoomReader, weftlight::loom::LoomReport, weftlight::loom::Protocol;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 1) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  const auto protocol = static_cast<Protocol>(data[0] / 16 % 5);
  LoomReader at_once(protocol), in_pieces(protocol);
  const std::vector<LoomReport> whole = at_once.parse(bytes);
  std::vector<LoomReport> pieces;
  const size_t piece = 1 + data[0] % 16;
  for (size_t at = 0; at < bytes.size(); at += piece)
    for (LoomReport& report : in_pieces.parse(bytes.substr(at, piece))) pieces.push_back(std::move(report));
  require(whole.size() == pieces.size(), "the same number of reports");
  for (size_t i = 0; i < whole.size(); ++i) {
    require(whole[i].kind == pieces[i].kind && whole[i].shafts == pieces[i].shafts && whole[i].on == pieces[i].on &&
                whole[i].text == pieces[i].text,
            "the same reports");
    require(whole[i].text.size() <= LoomReader::kMaxLineBytes, "no message is longer than the limit");
  }
  return 0;
}
