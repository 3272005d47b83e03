#pragma once
// A browser's request for a page (HTTP/1.1, RFC 9112), and what is answered. The grammar is Boost.Beast's.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace weftlight::platform {

struct PageRequest {
  std::string method, target;                         // "GET", "/state?after=3"
  std::string host, origin, referer, cookie, accept;  // fields of its head; empty if there are none
  std::string body;
  std::string peer = {};  // the address that it comes from, in numbers; the reader does not know it
};

struct PageAnswer {
  int status = 200;
  std::string type = {}, body = {};                              // of the body: "text/html; charset=utf-8"
  std::vector<std::pair<std::string, std::string>> fields = {};  // more of its head; no line ends in them
};
/// As it is sent. The connection closes after it.
std::string answer_bytes(const PageAnswer& answer);

/// Reads one request from bytes in any pieces. Takes no more than the limits below, whatever comes.
class PageRequestReader {
 public:
  static constexpr size_t kMaxHead = 8192, kMaxBody = 1024;
  enum class State { kMore, kDone, kRefused };

  PageRequestReader();
  ~PageRequestReader();
  PageRequestReader(const PageRequestReader&) = delete;
  PageRequestReader& operator=(const PageRequestReader&) = delete;

  /// After kDone or kRefused further bytes are ignored.
  State read(std::string_view bytes);
  /// After kDone.
  const PageRequest& request() const { return request_; }
  /// After kRefused: 400, 411, 413 or 431.
  int status() const { return status_; }

 private:
  struct Parser;
  State refused(int status);
  State done();

  std::unique_ptr<Parser> parser_;
  std::string waiting_;  // not yet parsed, at most kMaxHead
  State state_ = State::kMore;
  PageRequest request_;
  int status_ = 0;
};

}  // namespace weftlight::platform
