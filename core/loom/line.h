#pragma once
// A connection to a loom: TCP or a serial port (libserialport). No call waits longer than its timeout.

#include <memory>
#include <string>
#include <string_view>

#include "loom/names.h"

namespace weftlight::loom {

class Line {
 public:
  virtual ~Line() = default;
  /// Bytes received within `wait_ms`; empty if there were none. broken() is true once the connection is lost.
  virtual std::string receive(int wait_ms) = 0;
  /// False if not all bytes could be sent; the line is then broken.
  virtual bool send(std::string_view bytes) = 0;
  bool broken() const { return broken_; }

 protected:
  bool broken_ = false;
};

struct LineOpened {
  std::unique_ptr<Line> line;
  std::string why;  // why there is no line
};
/// "tcp:HOST:PORT" or "serial:/dev/ttyUSB0[:BAUD]" (default 9600). `wait_ms`: timeout of the connection.
LineOpened open_line(const std::string& address, int wait_ms = 3000);

}  // namespace weftlight::loom
