// Based on: the example protocol of base_loom_server (Russell Owen, MIT licence) and its notes on other looms.

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
  constexpr char kDigits[] = "0123456789abcdef";
  std::string words(1, 'C');
  for (int shift = 28; shift >= 0; shift -= 4) words += kDigits[shafts >> shift & 15];
  return framed(protocol, std::move(words));
}

std::string direction_command(Protocol protocol, bool weave) {
  if (protocol == Protocol::kToikaEs) return {};
  return framed(protocol, weave ? "U0" : "U1");
}

std::vector<LoomReport> LoomReader::parse(std::string_view bytes) {
  std::vector<LoomReport> reports;
  for (const char c : bytes) {
    if (c == '\r') continue;
    if (c != '\n') {
      if (!too_long_ && line_.size() >= kMaxLineBytes) {
        too_long_ = true;
        reports.push_back({LoomReport::kUnknown, 0, false, shown(line_)});
      }
      if (!too_long_) line_ += c;
      continue;
    }
    if (!too_long_ && !line_.empty()) reports.push_back(report_of(line_));
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
