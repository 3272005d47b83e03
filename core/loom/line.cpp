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

namespace weftlight::loom {
namespace {

constexpr size_t kAtOnce = 256;

/// A socket, or a terminal.
class OpenFileLine : public Line {
 public:
  enum class Kind { kSocket, kTerminal };
  OpenFileLine(int fd, Kind kind) : fd_(fd), kind_(kind) {}
  OpenFileLine(const OpenFileLine&) = delete;
  OpenFileLine& operator=(const OpenFileLine&) = delete;
  ~OpenFileLine() override { ::close(fd_); }

  std::string receive(int wait_ms) override {
    pollfd waits{fd_, POLLIN, 0};
    if (broken_ || ::poll(&waits, 1, wait_ms) <= 0) return {};
    char buffer[kAtOnce];
    const ssize_t got = ::read(fd_, buffer, sizeof buffer);
    if (got > 0) return {buffer, static_cast<size_t>(got)};
    broken_ = got == 0 || (errno != EAGAIN && errno != EINTR);
    return {};
  }

  bool send(std::string_view bytes) override {
    constexpr int kPatienceMs = 1000;
    while (!bytes.empty() && !broken_) {
      const ssize_t sent = kind_ == Kind::kSocket ? ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                                  : ::write(fd_, bytes.data(), bytes.size());
      if (sent > 0) {
        bytes.remove_prefix(static_cast<size_t>(sent));
        continue;
      }
      pollfd waits{fd_, POLLOUT, 0};
      broken_ = (errno != EAGAIN && errno != EINTR) || ::poll(&waits, 1, kPatienceMs) <= 0;
    }
    return !broken_;
  }

 private:
  int fd_;
  Kind kind_;
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
    char buffer[kAtOnce];
    // A wait of 0 would be for ever.
    const int got = static_cast<int>(
        wait_ms > 0 ? sp_blocking_read_next(port_, buffer, sizeof buffer, static_cast<unsigned>(wait_ms))
                    : sp_nonblocking_read(port_, buffer, sizeof buffer));
    broken_ = broken_ || got < 0;
    return got > 0 ? std::string(buffer, static_cast<size_t>(got)) : std::string();
  }

  bool send(std::string_view bytes) override {
    constexpr unsigned kPatienceMs = 1000;
    const int sent = static_cast<int>(sp_blocking_write(port_, bytes.data(), bytes.size(), kPatienceMs));
    broken_ = broken_ || sent != static_cast<int>(bytes.size());
    return !broken_;
  }

 private:
  sp_port* port_;
};

/// A socket that is connected, or -1 with errno.
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
  return {std::make_unique<OpenFileLine>(fd, OpenFileLine::Kind::kSocket), {}};
}

/// Bytes as they are, at that speed; false where it takes none of it.
bool made_raw(int terminal, int baud) {
  constexpr std::pair<int, speed_t> kSpeeds[] = {{1200, B1200},   {2400, B2400},   {4800, B4800},   {9600, B9600},
                                                 {19200, B19200}, {38400, B38400}, {57600, B57600}, {115200, B115200}};
  const auto* speed = std::ranges::find(kSpeeds, baud, &std::pair<int, speed_t>::first);
  termios how{};
  if (speed == std::end(kSpeeds) || ::tcgetattr(terminal, &how) != 0) return false;
  ::cfmakeraw(&how);
  ::cfsetspeed(&how, speed->second);
  return ::tcsetattr(terminal, TCSANOW, &how) == 0;
}

/// A serial port that a program makes (socat, a bridge to a loom far away): a terminal, but none of the system's
/// devices, which are all that libserialport knows.
LineOpened open_terminal(const std::string& name, int baud) {
  const int fd = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0 || ::isatty(fd) == 0) {
    if (fd >= 0) ::close(fd);
    return {nullptr, name + ": there is no such serial port"};
  }
  auto line = std::make_unique<OpenFileLine>(fd, OpenFileLine::Kind::kTerminal);
  if (!made_raw(fd, baud)) return {nullptr, name + ": it does not take " + std::to_string(baud) + " baud"};
  return {std::move(line), {}};
}

LineOpened open_serial(const std::string& name, int baud) {
  sp_port* port = nullptr;
  if (sp_get_port_by_name(name.c_str(), &port) != SP_OK) return open_terminal(name, baud);
  if (sp_open(port, SP_MODE_READ_WRITE) != SP_OK) {
    sp_free_port(port);
    return {nullptr, name + ": it cannot be opened; another program may hold it, or you may not be in its group"};
  }
  auto line = std::make_unique<SerialLine>(port);
  const bool set = sp_set_baudrate(port, baud) == SP_OK && sp_set_bits(port, 8) == SP_OK &&
                   sp_set_parity(port, SP_PARITY_NONE) == SP_OK && sp_set_stopbits(port, 1) == SP_OK &&
                   sp_set_flowcontrol(port, SP_FLOWCONTROL_NONE) == SP_OK;
  if (!set) return {nullptr, name + ": it does not take " + std::to_string(baud) + " baud"};
  return {std::move(line), {}};
}

}  // namespace

LineOpened open_line(const std::string& address, int wait_ms) {
  constexpr int kUsualBaud = 9600;
  const size_t last = address.rfind(':');
  if (address.starts_with("tcp:") && last > 4) {
    std::string host = address.substr(4, last - 4);
    if (host.size() > 1 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    return open_tcp(host, address.substr(last + 1), wait_ms);
  }
  if (address.starts_with("serial:")) {
    int baud = kUsualBaud;
    const char* end = address.data() + address.size();
    const bool says = last > 6 && std::from_chars(address.data() + last + 1, end, baud).ptr == end && baud > 0;
    return open_serial(address.substr(7, says ? last - 7 : std::string::npos), says ? baud : kUsualBaud);
  }
  return {nullptr, "a loom is reached by tcp:HOST:PORT or serial:PORT[:BAUD]"};
}

}  // namespace weftlight::loom
