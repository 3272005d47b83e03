#pragma once
// A line to a loom: TCP, or a serial port where the system has libserialport. Never waits longer than it is told.

#include <memory>
#include <string>
#include <string_view>

#include "loom/names.h"

namespace weftlight::loom {

class Line {
 public:
  virtual ~Line() = default;
  /// What has come, waiting `wait_ms` at the most; empty when nothing has. `broken` once the line is gone.
  virtual std::string receive(int wait_ms) = 0;
  /// False when not all could be sent: then the line is broken.
  virtual bool send(std::string_view bytes) = 0;
  bool broken() const { return broken_; }

 protected:
  bool broken_ = false;
};

struct LineOpened {
  std::unique_ptr<Line> line;
  std::string why;  // why there is none
};
/// "tcp:HOST:PORT" or "serial:/dev/ttyUSB0[:BAUD]" (9600 unless said). Waits at most `wait_ms` for a connection.
LineOpened open_line(const std::string& address, int wait_ms = 3000);

}  // namespace weftlight::loom
