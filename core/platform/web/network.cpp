// A page can neither listen nor open a line to a device: no serial line, no TCP, no page for a phone.

#include <system_error>

#include "platform/line.h"
#include "platform/page_request.h"
#include "platform/page_server.h"

namespace weftlight::platform {
namespace {

std::error_code refused() { return std::make_error_code(std::errc::operation_not_supported); }

}  // namespace

HostFound look_up_host(const std::string& /*host*/, const std::string& /*port*/) { return tl::unexpected(refused()); }

struct LineConnector::Lookup {};
LineConnector::LineConnector(LookUpHost look_up) : look_up_(std::move(look_up)) {}
LineConnected LineConnector::connect(const LineAddress& /*address*/, std::chrono::milliseconds /*wait*/,
                                     const std::stop_token& /*stop*/) {
  return tl::unexpected(
      NoLine{LineProblem::kOther, "a page in a browser cannot reach a loom; use the desktop program"});
}

std::string answer_bytes(const PageAnswer& answer) { return answer.body; }

struct PageServer::Body {};
tl::expected<std::unique_ptr<PageServer>, std::error_code> PageServer::open(const std::string& /*address*/,
                                                                            uint16_t /*port*/, Handler /*handler*/,
                                                                            std::function<void()> /*refused*/,
                                                                            PageLimits /*limits*/) {
  return tl::unexpected(refused());
}
PageServer::~PageServer() = default;
PageRefusals PageServer::refusals() const { return {}; }

}  // namespace weftlight::platform
