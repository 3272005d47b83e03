#pragma once
// Lines of bytes to a device: TCP and serial ports. No call waits longer than its timeout, and a requested stop ends
// every wait at once, that for a name server included.

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <system_error>
#include <tl/expected.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace weftlight::platform {

struct TcpAddress {
  std::string host, port;  // names or numbers
};
struct SerialAddress {
  std::string port;  // as the system names it: /dev/ttyUSB0, COM3
  int baud = 9600;   // 8 bits, no parity, 1 stop bit, no flow control
};
using LineAddress = std::variant<TcpAddress, SerialAddress>;

/// An open connection, used by one thread at a time.
class Line {
 public:
  static constexpr size_t kMaxReceived = 256;

  virtual ~Line() = default;
  /// Bytes received within `wait`, at most kMaxReceived; empty if there were none or a stop was requested.
  virtual std::string receive(std::chrono::milliseconds wait) = 0;
  /// False if not all bytes could be sent, or none for a second; the line is then broken.
  virtual bool send(std::string_view bytes) = 0;
  /// True once the connection is lost.
  bool broken() const { return broken_; }

 protected:
  bool broken_ = false;
};

enum class LineProblem {
  kStopped,
  kUnknownHost,
  kNoNameServer,  // none has answered yet
  kNoSuchPort,    // there is none of this name, or it is not a serial port
  kClosedPort,    // another program uses it, or the user may not
  kSpeed,         // the port has no such speed
  kOther,         // NoLine::said
};

/// Why there is no line.
struct NoLine {
  LineProblem problem = LineProblem::kOther;
  std::string said = {};  // kOther: the system's words
};
using LineConnected = tl::expected<std::unique_ptr<Line>, NoLine>;

/// What a name server answers: numeric addresses with ports; none if there is no such host.
using HostEndpoints = std::vector<std::pair<std::string, uint16_t>>;
using HostFound = tl::expected<HostEndpoints, std::error_code>;
using LookUpHost = std::function<HostFound(const std::string& host, const std::string& port)>;
/// Asks the system. Cannot be interrupted and may take minutes.
HostFound look_up_host(const std::string& host, const std::string& port);

/// Opens lines, one at a time.
class LineConnector {
 public:
  /// `look_up` runs on threads of its own, which may outlive the connector: it owns all that it uses.
  explicit LineConnector(LookUpHost look_up = look_up_host);

  /// `wait`: timeout for the name server, and for each of the host's addresses. A name that is not known by then is
  /// still looked up, and the next call for it takes the answer. `stop` also ends the waits of the line.
  LineConnected connect(const LineAddress& address, std::chrono::milliseconds wait, const std::stop_token& stop = {});

 private:
  struct Lookup;
  LineConnected connect_tcp(const TcpAddress& to, std::chrono::milliseconds wait, const std::stop_token& stop);
  /// At least one.
  tl::expected<HostEndpoints, NoLine> find_host(const TcpAddress& to, std::chrono::milliseconds wait,
                                                const std::stop_token& stop);
  std::shared_ptr<Lookup> lookup_of(const TcpAddress& to);

  LookUpHost look_up_;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<Lookup>> lookups_;  // not answered, or not yet used
};

}  // namespace weftlight::platform
