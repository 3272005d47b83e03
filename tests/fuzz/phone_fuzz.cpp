// Any bytes from a browser, in any pieces: the same request as in one piece, or none, and the page never moves a step
// for one that is not paired, nor answers without its security fields. A line that is wrong is refused at its end or
// before, depending on the pieces.

#include <cstdint>
#include <string>
#include <string_view>

#include "loom/phone_page.h"
#include "platform/page_request.h"
#include "require.h"

using weftlight::loom::PhonePage;
using weftlight::platform::PageRequestReader;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 1) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  PageRequestReader at_once, in_pieces;
  const PageRequestReader::State state = at_once.read(bytes);
  const size_t piece = 1 + data[0] % 16;
  PageRequestReader::State last = PageRequestReader::State::kMore;
  for (size_t at = 0; at < bytes.size(); at += piece) last = in_pieces.read(bytes.substr(at, piece));
  require((state == PageRequestReader::State::kDone) == (last == PageRequestReader::State::kDone), "the same end");
  if (state != PageRequestReader::State::kDone) return 0;
  require(at_once.request().target == in_pieces.request().target && at_once.request().body == in_pieces.request().body,
          "the same request");
  require(at_once.request().body.size() <= PageRequestReader::kMaxBody, "no body is longer than the limit");
  uint8_t next = 1;
  PhonePage page("a:1", [&next](std::span<uint8_t> filled) {
    for (uint8_t& byte : filled) byte = next = static_cast<uint8_t>(next * 5 + 17);
    return true;
  });
  const PhonePage::Outcome outcome = page.take(at_once.request());
  require(outcome.answer.has_value() && !outcome.step, "nobody is paired");
  bool checked = false;
  for (const auto& [name, value] : outcome.answer->fields) {
    checked |= name == "X-Content-Type-Options";
    require(value.find_first_of("\r\n") == std::string::npos, "no line ends in a field");
  }
  require(checked, "the security fields");
  return 0;
}
