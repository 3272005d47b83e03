#pragma once
// A browser, or something worse, that calls a server of this machine.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <utility>

namespace weftlight {

class Caller {
 public:
  /// `host`: "127.0.0.1:7389".
  explicit Caller(const std::string& host) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    at.sin_port = htons(static_cast<uint16_t>(std::stoi(host.substr(host.rfind(':') + 1))));
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&at), sizeof at) == 0;
  }
  ~Caller() { hang_up(); }
  Caller(Caller&& other) noexcept : socket_(std::exchange(other.socket_, -1)), connected_(other.connected_) {}
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  bool connected() const { return connected_; }
  /// False once the server has hung up.
  bool say(const std::string& words) const {
    return ::send(socket_, words.data(), words.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(words.size());
  }
  /// All that comes until the server hangs up; what came of it in 30 seconds if it does not.
  std::string heard() const {
    std::string all;
    char part[4096];
    pollfd waits{socket_, POLLIN, 0};
    for (ssize_t got; ::poll(&waits, 1, 30000) > 0 && (got = ::recv(socket_, part, sizeof part, 0)) > 0;)
      all.append(part, static_cast<size_t>(got));
    return all;
  }
  void hang_up() {
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }

 private:
  int socket_;
  bool connected_ = false;
};

/// What a browser on a page of `host` hears: "GET /", or "POST /pair" with a form; empty if nobody serves it.
class Browser {
 public:
  explicit Browser(std::string host) : host_(std::move(host)) {}
  std::string get(const std::string& target) const { return asked("GET " + target, {}, {}); }
  std::string post(const std::string& target, const std::string& form) const {
    return asked("POST " + target, form, "Origin: http://" + host_ + "\r\n");
  }
  /// Sends the cookie of that answer from now on; false if it has none.
  bool keep_cookie(const std::string& answer) {
    constexpr const char* kField = "Set-Cookie: ";
    const size_t at = answer.find(kField);
    if (at == std::string::npos) return false;
    const size_t begin = at + std::char_traits<char>::length(kField);
    cookie_ = answer.substr(begin, answer.find(';', begin) - begin);
    return true;
  }
  /// Its script asks, and not the page.
  void ask_for_json() { accept_ = "application/json"; }

 private:
  std::string asked(const std::string& what, const std::string& body, const std::string& more) const {
    const Caller caller(host_);
    if (!caller.connected()) return {};
    std::string words = what;
    words.append(" HTTP/1.1\r\nHost: ").append(host_).append("\r\nCookie: ").append(cookie_).append("\r\n");
    words.append(more).append("Accept: ").append(accept_).append("\r\nContent-Length: ");
    words.append(std::to_string(body.size())).append("\r\n\r\n").append(body);
    return caller.say(words) ? caller.heard() : std::string();
  }

  std::string host_, cookie_ = "none=1", accept_ = "text/html";
};

}  // namespace weftlight
