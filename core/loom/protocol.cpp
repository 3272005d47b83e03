// Based on: the example protocol of base_loom_server (Russell Owen, MIT licence) and its notes on other looms; of the
// Compu-Dobby, what DrawBoy (John Horigan, MIT licence) sends and expects: tried on his looms, and by us on none.

#include "loom/protocol.h"

#include <charconv>

namespace weftlight::loom {
namespace {

/// A message as it may be shown: what is no printable ASCII becomes '?'.
std::string shown(std::string_view line) {
  std::string text(line);
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

LoomReport avl3_report(std::string_view message) {
  if (message == "\x7f") return {LoomReport::kReady};
  if (message == "\x61") return {LoomReport::kShedClosed};
  if (message == "\x62") return {LoomReport::kShedOpen};
  return {LoomReport::kUnknown, 0, false, shown(message)};
}

/// In small letters, without the brackets.
LoomReport avl4_report(std::string_view message) {
  if (message == "up") return {LoomReport::kShedClosed};
  if (message == "down") return {LoomReport::kShedOpen};
  if (message == "password:") return {LoomReport::kPasswordWanted};
  if (message == "ready" || message == "arm null") return {LoomReport::kMotion};
  if (!message.starts_with("compu-dobby iv")) return {LoomReport::kUnknown, 0, false, shown(message)};
  return {message.find("neg dobby") == std::string_view::npos ? LoomReport::kMotion : LoomReport::kNegativeDobby};
}

LoomReport report_of(std::string_view line) {
  LoomReport report{LoomReport::kUnknown, 0, false, shown(line)};
  if (line == "p") return {LoomReport::kPickWanted};
  if (line == "u0" || line == "u1") return {LoomReport::kDirection, 0, line == "u0"};
  if (line == "m0" || line == "m1") return {LoomReport::kMotion, 0, line == "m1"};
  if (line.size() != 9 || line[0] != 'c') return report;
  uint32_t shafts = 0;
  const char* end = line.data() + line.size();
  const auto read = std::from_chars(line.data() + 1, end, shafts, 16);
  if (read.ec != std::errc{} || read.ptr != end) return report;
  return {LoomReport::kShaftsRaised, shafts};
}

/// How a protocol ends its messages, and which bytes it means nothing by.
struct Framing {
  char end;
  const char* idle;
};
Framing framing_of(Protocol protocol) {
  if (protocol == Protocol::kAvl3) return {'\x03', ""};
  if (protocol == Protocol::kAvl4) return {'>', "\r\n<"};
  return {'\n', "\r"};
}

LoomReport report_of(Protocol protocol, std::string& message) {
  if (protocol == Protocol::kAvl3) return avl3_report(message);
  if (protocol != Protocol::kAvl4) return report_of(message);
  for (char& c : message)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return avl4_report(message);
}

/// A byte for every four shafts: the number of the four, from 1, and a bit for each.
std::string avl3_command(uint32_t shafts) {
  std::string bytes;
  for (int four = 0; four < kMaxLoomShafts / 4; ++four)
    bytes += static_cast<char>((four + 1) << 4 | static_cast<int>(shafts >> (4 * four) & 15));
  return bytes + '\x07';
}

std::string avl4_command(uint32_t shafts) {
  std::string words = "clear\r";
  for (int s = 0; s < kMaxLoomShafts; ++s)
    if (shafts >> s & 1) words += (words.ends_with('\r') ? "pick " : ",") + std::to_string(s + 1);
  return shafts == 0 ? words : words + '\r';
}

std::string framed(Protocol protocol, std::string words) {
  if (protocol == Protocol::kSeguin) words.insert(words.begin(), '=');
  words += '\n';
  return words;
}

}  // namespace

std::string raise_command(Protocol protocol, uint32_t shafts) {
  if (protocol == Protocol::kToikaEs) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(shafts >> shift & 255);
    return bytes;
  }
  if (protocol == Protocol::kAvl3) return avl3_command(shafts);
  if (protocol == Protocol::kAvl4) return avl4_command(shafts);
  constexpr char kDigits[] = "0123456789abcdef";
  std::string words(1, 'C');
  for (int shift = 28; shift >= 0; shift -= 4) words += kDigits[shafts >> shift & 15];
  return framed(protocol, std::move(words));
}

std::string direction_command(Protocol protocol, bool weave) {
  if (protocol == Protocol::kToikaEs || takes_picks_ahead(protocol)) return {};
  return framed(protocol, weave ? "U0" : "U1");
}

std::string greeting(Protocol protocol) {
  if (protocol == Protocol::kAvl3) return "\x0f\x03";
  return protocol == Protocol::kAvl4 ? "\r" : "";
}

std::string password_command() { return "chico\r"; }

std::vector<LoomReport> LoomReader::parse(std::string_view bytes) {
  const Framing framing = framing_of(protocol_);
  const std::string_view idle(framing.idle);
  std::vector<LoomReport> reports;
  for (const char c : bytes) {
    if (idle.find(c) != std::string_view::npos) continue;
    if (c != framing.end) {
      if (!too_long_ && line_.size() >= kMaxLineBytes) {
        too_long_ = true;
        reports.push_back({LoomReport::kUnknown, 0, false, shown(line_)});
      }
      if (!too_long_) line_ += c;
      continue;
    }
    if (!too_long_ && !line_.empty()) reports.push_back(report_of(protocol_, line_));
    line_.clear();
    too_long_ = false;
  }
  return reports;
}

std::optional<uint32_t> raised_shafts(const Draft& draft, const BitMatrix& lifts, int pick) {
  if (draft.shafts > kMaxLoomShafts || pick < 0 || pick >= lifts.rows()) return {};
  uint32_t named = 0;
  for (int s = 0; s < draft.shafts; ++s)
    if (lifts.get(pick, s)) named |= uint32_t{1} << s;
  const uint32_t all = draft.shafts == kMaxLoomShafts ? ~uint32_t{0} : (uint32_t{1} << draft.shafts) - 1;
  return draft.rising ? named : all & ~named;
}

}  // namespace weftlight::loom
