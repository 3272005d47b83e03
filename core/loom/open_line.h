#pragma once
// The line to a loom: its address as the weaver writes it, and errors in words.

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

#include "base/result.h"
#include "platform/line.h"

namespace weftlight::loom {

/// "tcp:HOST:PORT" or "serial:/dev/ttyUSB0[:BAUD]" (default 9600). `wait` and `stop` as in LineConnector::connect;
/// after a stop the error is of kCancelled.
base::Result<std::unique_ptr<platform::Line>> open_line(
    platform::LineConnector& connector, const std::string& address,
    std::chrono::milliseconds wait = std::chrono::milliseconds(3000), const std::stop_token& stop = {});

}  // namespace weftlight::loom
