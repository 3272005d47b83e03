#include "platform/line.h"

#include <array>
#include <asio.hpp>
#include <charconv>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "platform/keep_from_children.h"

namespace weftlight::platform {
namespace {

using std::chrono::milliseconds;
using Endpoints = std::vector<asio::ip::tcp::endpoint>;

constexpr milliseconds kSendTimeout{1000};
constexpr size_t kMaxLookups = 8;  // threads that wait for name servers at the same time

struct Step {
  bool ended = false;
  std::error_code error = {};
  size_t bytes = 0;
};

/// Runs one operation of `stream`, which `begin` starts with the handler that it is given, until it ends, the time is
/// over or a stop is requested. The operation is over afterwards: nothing refers to its buffers any more.
template <class Stream, class Begin>
Step run_step(asio::io_context& io, Stream& stream, milliseconds wait, const std::stop_token& stop, Begin begin) {
  Step step;
  begin([&step](const std::error_code& error, size_t bytes = 0) { step = {true, error, bytes}; });
  io.restart();
  {
    const std::stop_callback on_stop(stop, [&io] { io.stop(); });
    io.run_for(wait);
  }
  if (step.ended) return step;
  std::error_code ignored;
  stream.cancel(ignored);
  io.restart();
  io.run();
  return step;
}

bool timed_out(const Step& step) { return step.error == asio::error::operation_aborted; }

template <class Stream>
class StreamLine : public Line {
 public:
  StreamLine(std::unique_ptr<asio::io_context> io, Stream stream, std::stop_token stop)
      : io_(std::move(io)), stream_(std::move(stream)), stop_(std::move(stop)) {}

  std::string receive(milliseconds wait) override {
    if (broken_) return {};
    std::array<char, kMaxReceived> buffer;
    const Step step = run_step(*io_, stream_, wait, stop_,
                               [&](auto then) { stream_.async_read_some(asio::buffer(buffer), std::move(then)); });
    broken_ = step.error && !timed_out(step);
    return {buffer.data(), step.bytes};
  }

  bool send(std::string_view bytes) override {
    while (!bytes.empty() && !broken_) {
      const Step step = run_step(*io_, stream_, kSendTimeout, stop_, [&](auto then) {
        stream_.async_write_some(asio::buffer(bytes.data(), bytes.size()), std::move(then));
      });
      broken_ = static_cast<bool>(step.error);
      bytes.remove_prefix(step.bytes);
    }
    return !broken_;
  }

 private:
  std::unique_ptr<asio::io_context> io_;  // before the stream, which uses it to its end
  Stream stream_;
  std::stop_token stop_;
};

tl::unexpected<NoLine> none(LineProblem problem, std::string said = {}) {
  return tl::unexpected(NoLine{problem, std::move(said)});
}

LineConnected connected_to(const Endpoints& endpoints, milliseconds wait, const std::stop_token& stop) {
  std::error_code why = asio::error::host_not_found;
  for (const asio::ip::tcp::endpoint& endpoint : endpoints) {
    auto io = std::make_unique<asio::io_context>(1);
    asio::ip::tcp::socket socket(*io);
    socket.open(endpoint.protocol(), why);
    if (why) continue;
    keep_from_children(socket.native_handle());
    const Step step =
        run_step(*io, socket, wait, stop, [&](auto then) { socket.async_connect(endpoint, std::move(then)); });
    why = timed_out(step) ? std::make_error_code(std::errc::timed_out) : step.error;
    if (stop.stop_requested()) return none(LineProblem::kStopped);
    if (why) continue;
    return std::make_unique<StreamLine<asio::ip::tcp::socket>>(std::move(io), std::move(socket), stop);
  }
  return none(LineProblem::kOther, why.message());
}

LineProblem problem_of_port(const std::error_code& from_asio) {
  // asio's category of system errors does not know the names of most of them.
  const std::error_code error(from_asio.value(), std::system_category());
  const auto is = [&error](std::errc other) { return error == other; };
  const bool none = is(std::errc::no_such_file_or_directory) || is(std::errc::not_a_directory) ||
                    is(std::errc::is_a_directory) || is(std::errc::no_such_device) ||
                    is(std::errc::no_such_device_or_address) || is(std::errc::inappropriate_io_control_operation);
  return none ? LineProblem::kNoSuchPort : LineProblem::kClosedPort;
}

LineConnected connect_serial(const SerialAddress& to, const std::stop_token& stop) {
  auto io = std::make_unique<asio::io_context>(1);
  asio::serial_port port(*io);
  std::error_code error;
  port.open(to.port, error);
  if (error) return none(problem_of_port(error));
  keep_from_children(port.native_handle());
  using Set = asio::serial_port_base;
  port.set_option(Set::baud_rate(static_cast<unsigned>(to.baud)), error);
  if (!error) port.set_option(Set::character_size(8), error);
  if (!error) port.set_option(Set::parity(Set::parity::none), error);
  if (!error) port.set_option(Set::stop_bits(Set::stop_bits::one), error);
  if (!error) port.set_option(Set::flow_control(Set::flow_control::none), error);
  if (error) return none(LineProblem::kSpeed);
  return std::make_unique<StreamLine<asio::serial_port>>(std::move(io), std::move(port), stop);
}

/// Without a name server; nothing if host or port is a name.
std::optional<asio::ip::tcp::endpoint> numeric(const std::string& host, const std::string& port) {
  uint16_t number = 0;
  const char* end = port.data() + port.size();
  const auto read = std::from_chars(port.data(), end, number);
  std::error_code error;
  const asio::ip::address address = asio::ip::make_address(host, error);
  if (error || read.ec != std::errc{} || read.ptr != end) return {};
  return asio::ip::tcp::endpoint(address, number);
}

Endpoints endpoints_of(const HostEndpoints& found) {
  Endpoints out;
  for (const auto& [address, port] : found)
    if (const auto endpoint = numeric(address, std::to_string(port))) out.push_back(*endpoint);
  return out;
}

}  // namespace

HostFound look_up_host(const std::string& host, const std::string& port) {
  asio::io_context io(1);
  std::error_code error;
  const auto results = asio::ip::tcp::resolver(io).resolve(host, port, error);
  HostEndpoints found;
  if (error == asio::error::host_not_found || error == asio::error::no_data) return found;
  if (error) return tl::unexpected(error);
  for (const auto& result : results)
    found.emplace_back(result.endpoint().address().to_string(), result.endpoint().port());
  return found;
}

/// A question to a name server, shared by the thread that waits for the answer and the connector.
struct LineConnector::Lookup {
  std::mutex mutex;
  std::condition_variable_any changed;
  bool answered = false;  // guarded by the mutex, as is:
  HostFound found;

  void answer(HostFound what) {
    {
      const std::lock_guard lock(mutex);
      found = std::move(what);
      answered = true;
    }
    changed.notify_all();
  }
};

LineConnector::LineConnector(LookUpHost look_up) : look_up_(std::move(look_up)) {}

/// The system's look-up of a host cannot be interrupted, so its thread is left to itself: nobody joins it. It owns all
/// that it touches and uses no object with a static life, so that it may still wait for the name server, or come back
/// from it, while the program ends.
std::shared_ptr<LineConnector::Lookup> LineConnector::lookup_of(const TcpAddress& to) {
  const std::pair key(to.host, to.port);
  if (const auto same = lookups_.find(key); same != lookups_.end()) return same->second;
  std::erase_if(lookups_, [](const auto& entry) {
    const std::lock_guard lock(entry.second->mutex);
    return entry.second->answered;
  });
  if (lookups_.size() >= kMaxLookups) return nullptr;
  const auto lookup = std::make_shared<Lookup>();
  std::thread([lookup, look_up = look_up_, to] {
    try {
      lookup->answer(look_up(to.host, to.port));
    } catch (...) {  // no memory
      lookup->answer(tl::unexpected(std::make_error_code(std::errc::not_enough_memory)));
    }
  }).detach();
  return lookups_[key] = lookup;
}

tl::expected<HostEndpoints, NoLine> LineConnector::find_host(const TcpAddress& to, milliseconds wait,
                                                             const std::stop_token& stop) {
  const std::shared_ptr<Lookup> lookup = lookup_of(to);
  if (!lookup) return none(LineProblem::kNoNameServer);
  std::unique_lock lock(lookup->mutex);
  const bool answered = lookup->changed.wait_for(lock, stop, wait, [&] { return lookup->answered; });
  if (stop.stop_requested()) return none(LineProblem::kStopped);
  if (!answered) return none(LineProblem::kNoNameServer);
  HostFound found = std::move(lookup->found);
  lookups_.erase({to.host, to.port});
  if (!found) return none(LineProblem::kOther, found.error().message());
  if (found->empty()) return none(LineProblem::kUnknownHost);
  return std::move(*found);
}

LineConnected LineConnector::connect_tcp(const TcpAddress& to, milliseconds wait, const std::stop_token& stop) {
  if (const auto endpoint = numeric(to.host, to.port)) return connected_to({*endpoint}, wait, stop);
  const auto found = find_host(to, wait, stop);
  if (!found) return tl::unexpected(found.error());
  return connected_to(endpoints_of(*found), wait, stop);
}

LineConnected LineConnector::connect(const LineAddress& address, milliseconds wait, const std::stop_token& stop) {
  if (const auto* to = std::get_if<TcpAddress>(&address)) return connect_tcp(*to, wait, stop);
  return connect_serial(std::get<SerialAddress>(address), stop);
}

}  // namespace weftlight::platform
