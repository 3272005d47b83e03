#pragma once
// The line to a loom: its address as the weaver writes it, and why there is none as a sentence.

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

#include "platform/line.h"

namespace weftlight::loom {

struct LineOpened {
  std::unique_ptr<platform::Line> line;
  std::string why;  // why there is no line
};
/// "tcp:HOST:PORT" or "serial:/dev/ttyUSB0[:BAUD]" (default 9600). `wait` and `stop` as in LineConnector::connect.
LineOpened open_line(platform::LineConnector& connector, const std::string& address,
                     std::chrono::milliseconds wait = std::chrono::milliseconds(3000),
                     const std::stop_token& stop = {});

}  // namespace weftlight::loom
