#include "loom/open_line.h"

#include <charconv>
#include <optional>
#include <utility>
#include <variant>

#include "base/text.h"

namespace weftlight::loom {

using base::arg, base::ErrorKind, base::failure, base::fill, base::tr;
using platform::LineAddress, platform::LineProblem, platform::SerialAddress, platform::TcpAddress;

namespace {

std::optional<LineAddress> parsed(const std::string& address) {
  const size_t last = address.rfind(':');
  if (address.starts_with("tcp:") && last > 4) {
    std::string host = address.substr(4, last - 4);
    if (host.size() > 1 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    return TcpAddress{host, address.substr(last + 1)};
  }
  if (!address.starts_with("serial:")) return {};
  int baud = 0;
  const char* end = address.data() + address.size();
  const bool has_baud = last > 6 && std::from_chars(address.data() + last + 1, end, baud).ptr == end && baud > 0;
  if (!has_baud) return SerialAddress{address.substr(7)};
  return SerialAddress{address.substr(7, last - 7), baud};
}

std::string sentence(LineProblem problem, const TcpAddress& to, const std::string& said) {
  switch (problem) {
    case LineProblem::kUnknownHost:
      return fill(tr("{host}: there is no such host"), arg("host", to.host));
    case LineProblem::kNoNameServer:
      return fill(tr("{host}: waiting for the name server"), arg("host", to.host));
    default:
      return fill(tr("{host}:{port}: {why}"), arg("host", to.host), arg("port", to.port), arg("why", said));
  }
}

std::string sentence(LineProblem problem, const SerialAddress& to) {
  switch (problem) {
    case LineProblem::kNoSuchPort:
      return fill(tr("{port}: there is no such serial port"), arg("port", to.port));
    case LineProblem::kSpeed:
      return fill(tr("{port}: {baud} baud is not supported"), arg("port", to.port), arg("baud", to.baud));
    default:
      return fill(tr("{port}: it cannot be opened; another program may be using it, or you may not be in its group"),
                  arg("port", to.port));
  }
}

}  // namespace

base::Result<std::unique_ptr<platform::Line>> open_line(platform::LineConnector& connector, const std::string& address,
                                                        std::chrono::milliseconds wait, const std::stop_token& stop) {
  const std::optional<LineAddress> to = parsed(address);
  if (!to)
    return failure(
        ErrorKind::kUsage,
        fill(tr("{address} is not a loom address; give tcp:HOST:PORT or serial:PORT[:BAUD]"), arg("address", address)));
  platform::LineConnected connected = connector.connect(*to, wait, stop);
  if (connected) return std::move(*connected);
  const platform::NoLine& none = connected.error();
  if (none.problem == LineProblem::kStopped) return failure(ErrorKind::kCancelled, tr("connecting was stopped"));
  if (const auto* tcp = std::get_if<TcpAddress>(&*to))
    return failure(ErrorKind::kOutput, sentence(none.problem, *tcp, none.said));
  return failure(ErrorKind::kOutput, sentence(none.problem, std::get<SerialAddress>(*to)));
}

}  // namespace weftlight::loom
