#pragma once
// Pages for browsers in the local network, on a thread of its own: one request a connection, plain HTTP. Whatever peers
// send, and however slowly, the memory that they take is bounded, and nobody waits for them.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <tl/expected.hpp>

#include "platform/page_request.h"

namespace weftlight::platform {

struct PageLimits {
  int connections = 32, of_one_peer = 12;              // at once; further ones are closed as they come
  std::chrono::milliseconds request{5000};             // for the whole of a request, from the connection on
  std::chrono::milliseconds held{20000};               // until it is answered; then the answer is 204
  std::chrono::milliseconds sent{10000}, ending{500};  // for sending the answer, and for the peer to hang up after it
};

/// What was turned away.
struct PageRefusals {
  uint64_t connections = 0;  // above the limits, or too slow
  uint64_t requests = 0;     // that were none
  std::string peer = {};     // the last of them
  bool operator==(const PageRefusals&) const = default;
};

class PageServer {
 public:
  /// Answers the request, once: further calls do nothing, nor do calls after the connection or the server has gone. May
  /// be called on any thread.
  using Reply = std::function<void(PageAnswer)>;
  /// Called on the server's thread. What it throws ends that connection alone.
  using Handler = std::function<void(const PageRequest&, Reply)>;

  /// Listens at one address of this machine, in numbers; port 0 is one that is free. `refused` is called on the
  /// server's thread when something was turned away, at most once in a second.
  static tl::expected<std::unique_ptr<PageServer>, std::error_code> open(
      const std::string& address, uint16_t port, Handler handler, std::function<void()> refused = [] {},
      PageLimits limits = {});
  /// Closes all connections.
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// As browsers name it: "192.168.1.5:7389", "[2001:db8::5]:7389".
  const std::string& host() const { return host_; }
  PageRefusals refusals() const;

 private:
  struct Body;
  class Connection;
  PageServer() = default;

  std::shared_ptr<Body> body_;
  std::string host_;
  std::thread thread_;
};

}  // namespace weftlight::platform
