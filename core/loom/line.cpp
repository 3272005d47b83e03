#include "loom/line.h"

#include <fcntl.h>
#include <libserialport.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <iterator>
#include <utility>

#include "base/text.h"

namespace weftlight::loom {

using base::arg;
using base::fill;
using base::tr;

namespace {

constexpr size_t kReadBytes = 256;

/// A line over a file descriptor: a socket or a terminal.
class OpenFileLine : public Line {
 public:
  enum class Device { kSocket, kTerminal };
  OpenFileLine(int fd, Device device) : fd_(fd), device_(device) {}
  OpenFileLine(const OpenFileLine&) = delete;
  OpenFileLine& operator=(const OpenFileLine&) = delete;
  ~OpenFileLine() override { ::close(fd_); }

  std::string receive(int wait_ms) override {
    pollfd waits{fd_, POLLIN, 0};
    if (broken_ || ::poll(&waits, 1, wait_ms) <= 0) return {};
    char buffer[kReadBytes];
    const ssize_t got = ::read(fd_, buffer, sizeof buffer);
    if (got > 0) return {buffer, static_cast<size_t>(got)};
    broken_ = got == 0 || (errno != EAGAIN && errno != EINTR);
    return {};
  }

  bool send(std::string_view bytes) override {
    constexpr int kSendTimeoutMs = 1000;
    while (!bytes.empty() && !broken_) {
      const ssize_t sent = device_ == Device::kSocket ? ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                                      : ::write(fd_, bytes.data(), bytes.size());
      if (sent > 0) {
        bytes.remove_prefix(static_cast<size_t>(sent));
        continue;
      }
      pollfd waits{fd_, POLLOUT, 0};
      broken_ = (errno != EAGAIN && errno != EINTR) || ::poll(&waits, 1, kSendTimeoutMs) <= 0;
    }
    return !broken_;
  }

 private:
  int fd_;
  Device device_;
};

class SerialLine : public Line {
 public:
  explicit SerialLine(sp_port* port) : port_(port) {}
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;
  ~SerialLine() override {
    sp_close(port_);
    sp_free_port(port_);
  }

  std::string receive(int wait_ms) override {
    char buffer[kReadBytes];
    // libserialport takes a timeout of 0 as no timeout at all.
    const int got = static_cast<int>(
        wait_ms > 0 ? sp_blocking_read_next(port_, buffer, sizeof buffer, static_cast<unsigned>(wait_ms))
                    : sp_nonblocking_read(port_, buffer, sizeof buffer));
    broken_ = broken_ || got < 0;
    return got > 0 ? std::string(buffer, static_cast<size_t>(got)) : std::string();
  }

  bool send(std::string_view bytes) override {
    constexpr unsigned kSendTimeoutMs = 1000;
    const int sent = static_cast<int>(sp_blocking_write(port_, bytes.data(), bytes.size(), kSendTimeoutMs));
    broken_ = broken_ || sent != static_cast<int>(bytes.size());
    return !broken_;
  }

 private:
  sp_port* port_;
};

/// A connected socket, or -1 with errno set.
int connected(const addrinfo& to, int wait_ms) {
  const int fd = ::socket(to.ai_family, to.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, to.ai_protocol);
  if (fd < 0) return -1;
  int error = ::connect(fd, to.ai_addr, to.ai_addrlen) == 0 ? 0 : errno;
  if (error == EINPROGRESS) {
    pollfd waits{fd, POLLOUT, 0};
    socklen_t size = sizeof error;
    if (::poll(&waits, 1, wait_ms) <= 0) error = ETIMEDOUT;
    else if (::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) != 0) error = errno;
  }
  if (error == 0) return fd;
  ::close(fd);
  errno = error;
  return -1;
}

LineOpened open_tcp(const std::string& host, const std::string& port, int wait_ms) {
  addrinfo hints{}, *found = nullptr;
  hints.ai_socktype = SOCK_STREAM;
  if (const int error = ::getaddrinfo(host.c_str(), port.c_str(), &hints, &found); error != 0)
    return {nullptr, host + ": " + ::gai_strerror(error)};
  int fd = -1;
  for (const addrinfo* at = found; at && fd < 0; at = at->ai_next) fd = connected(*at, wait_ms);
  const std::string why = fd < 0 ? host + ":" + port + ": " + std::strerror(errno) : std::string();
  ::freeaddrinfo(found);
  if (fd < 0) return {nullptr, why};
  return {std::make_unique<OpenFileLine>(fd, OpenFileLine::Device::kSocket), {}};
}

/// Raw mode (bytes pass unchanged) at that speed; false if the terminal does not support it.
bool set_raw_mode(int terminal, int baud) {
  constexpr std::pair<int, speed_t> kSpeeds[] = {{1200, B1200},   {2400, B2400},   {4800, B4800},   {9600, B9600},
                                                 {19200, B19200}, {38400, B38400}, {57600, B57600}, {115200, B115200}};
  const auto* speed = std::ranges::find(kSpeeds, baud, &std::pair<int, speed_t>::first);
  termios how{};
  if (speed == std::end(kSpeeds) || ::tcgetattr(terminal, &how) != 0) return false;
  ::cfmakeraw(&how);
  ::cfsetspeed(&how, speed->second);
  return ::tcsetattr(terminal, TCSANOW, &how) == 0;
}

std::string unsupported_speed(const std::string& port, int baud) {
  return fill(tr("{port}: {baud} baud is not supported"), arg("port", port), arg("baud", baud));
}

/// A pseudo-terminal made by a program (socat, a bridge to a remote loom). libserialport knows only the system's
/// devices.
LineOpened open_terminal(const std::string& name, int baud) {
  const int fd = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0 || ::isatty(fd) == 0) {
    if (fd >= 0) ::close(fd);
    return {nullptr, fill(tr("{port}: there is no such serial port"), arg("port", name))};
  }
  auto line = std::make_unique<OpenFileLine>(fd, OpenFileLine::Device::kTerminal);
  if (!set_raw_mode(fd, baud)) return {nullptr, unsupported_speed(name, baud)};
  return {std::move(line), {}};
}

LineOpened open_serial(const std::string& name, int baud) {
  sp_port* port = nullptr;
  if (sp_get_port_by_name(name.c_str(), &port) != SP_OK) return open_terminal(name, baud);
  if (sp_open(port, SP_MODE_READ_WRITE) != SP_OK) {
    sp_free_port(port);
    return {nullptr,
            fill(tr("{port}: it cannot be opened; another program may be using it, or you may not be in its group"),
                 arg("port", name))};
  }
  auto line = std::make_unique<SerialLine>(port);
  const bool set = sp_set_baudrate(port, baud) == SP_OK && sp_set_bits(port, 8) == SP_OK &&
                   sp_set_parity(port, SP_PARITY_NONE) == SP_OK && sp_set_stopbits(port, 1) == SP_OK &&
                   sp_set_flowcontrol(port, SP_FLOWCONTROL_NONE) == SP_OK;
  if (!set) return {nullptr, unsupported_speed(name, baud)};
  return {std::move(line), {}};
}

}  // namespace

LineOpened open_line(const std::string& address, int wait_ms) {
  constexpr int kDefaultBaud = 9600;
  const size_t last = address.rfind(':');
  if (address.starts_with("tcp:") && last > 4) {
    std::string host = address.substr(4, last - 4);
    if (host.size() > 1 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    return open_tcp(host, address.substr(last + 1), wait_ms);
  }
  if (address.starts_with("serial:")) {
    int baud = kDefaultBaud;
    const char* end = address.data() + address.size();
    const bool has_baud = last > 6 && std::from_chars(address.data() + last + 1, end, baud).ptr == end && baud > 0;
    return open_serial(address.substr(7, has_baud ? last - 7 : std::string::npos), has_baud ? baud : kDefaultBaud);
  }
  return {nullptr, fill(tr("{address} is no address of a loom; give tcp:HOST:PORT or serial:PORT[:BAUD]"),
                        arg("address", address))};
}

}  // namespace weftlight::loom
