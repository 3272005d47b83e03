#pragma once
// A port of this machine that a loom can be found at.

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace weftlight {

class LoomPort {
 public:
  LoomPort() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    if (::bind(socket_, reinterpret_cast<sockaddr*>(&at), size) != 0 || ::listen(socket_, 1) != 0) return;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&at), &size);
    number_ = ntohs(at.sin_port);
  }
  ~LoomPort() { ::close(socket_); }
  LoomPort(const LoomPort&) = delete;
  LoomPort& operator=(const LoomPort&) = delete;
  /// 0: the machine gave none.
  int number() const { return number_; }
  std::string address() const { return "tcp:127.0.0.1:" + std::to_string(number_); }
  /// Waits for one who calls; its end of the line.
  int accepted() const { return ::accept(socket_, nullptr, nullptr); }

 private:
  int socket_, number_ = 0;
};

}  // namespace weftlight
