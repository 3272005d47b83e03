// Any bytes as a journal, and journals truncated or changed anywhere: parsing never crashes, and returns an entry that
// was written or none.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "require.h"
#include "session/recovery/journal_format.h"

using weftlight::session::DocumentNote, weftlight::session::journal_entry, weftlight::session::journal_start,
    weftlight::session::read_journal;

namespace {

/// The lines of the input as successive states of the document.
std::vector<std::string> states_of(std::string_view input) {
  std::vector<std::string> states(1);
  for (const char c : input) {
    if (c == '\n') states.push_back(states.back());
    else states.back() += c;
  }
  return states;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  (void)read_journal(input);
  const std::vector<std::string> states = states_of(input.substr(0, 400));
  const DocumentNote note{states.front(), states.back(), {}};
  std::string journal = journal_start({note, states.front()});
  for (size_t i = 1; i < states.size(); ++i) journal += journal_entry(states[i - 1], states[i]);
  const auto whole = read_journal(journal);
  require(whole && whole->text == states.back() && whole->note == note, "the last state is read back");
  // Truncated, then one byte changed, at positions from the input.
  const size_t dice = size > 1 ? static_cast<size_t>(data[0]) << 8 | data[1] : 0;
  std::string torn = journal.substr(0, journal.size() - dice % journal.size());
  torn[dice % torn.size()] = static_cast<char>(torn[dice % torn.size()] ^ (1 + dice % 255));
  if (const auto read = read_journal(torn)) {
    bool written = false;
    for (const std::string& state : states) written |= state == read->text;
    require(written, "only written states are read");
  }
  return 0;
}
