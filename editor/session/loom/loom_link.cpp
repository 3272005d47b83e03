#include "session/loom/loom_link.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "base/caught.h"
#include "base/text.h"

namespace weftlight::session {

using base::caught, base::tr;

namespace {

constexpr std::chrono::seconds kAgain{2};
constexpr std::chrono::milliseconds kConnect{1500}, kListen{20};

}  // namespace

LoomLink::LoomLink(std::function<void()> wake, platform::LookUpHost look_up)
    : wake_(std::move(wake)), connector_(std::move(look_up)), thread_([this] { work(); }) {}

LoomLink::~LoomLink() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
    wanted_.request_stop();
  }
  changed_.notify_all();
  thread_.join();
}

void LoomLink::connect(const std::string& address, loom::Protocol protocol) {
  {
    const std::lock_guard lock(mutex_);
    wanted_.request_stop();
    wanted_ = {};
    address_ = address;
    protocol_ = protocol;
    to_send_.clear();
    why_.clear();
    received_ = {};
    state_ = address.empty() ? State::kOff : State::kConnecting;
  }
  changed_.notify_all();
}

void LoomLink::disconnect() { connect({}); }

void LoomLink::send(const std::string& bytes) {
  {
    const std::lock_guard lock(mutex_);
    if (state_ == State::kConnected) to_send_ += bytes;
  }
  changed_.notify_all();
}

LoomLink::Received LoomLink::take() {
  Received received;
  {
    const std::lock_guard lock(mutex_);
    std::swap(received, received_);
  }
  changed_.notify_all();
  return received;
}

LoomLink::State LoomLink::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::string LoomLink::why() const {
  const std::lock_guard lock(mutex_);
  return why_;
}

void LoomLink::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return leaving_ || !address_.empty(); });
    if (leaving_) return;
    const std::stop_token stop = wanted_.get_token();
    std::string address;
    base::Result<void> ended = caught([&] { address = address_; });
    lock.unlock();
    if (ended) ended = caught([&]() -> base::Result<void> { return connect_once(address, stop); });
    lock.lock();
    if (stop.stop_requested()) continue;
    // Without memory for the words the next attempt tells.
    caught([&] { why_ = problem_of(ended); });
    state_ = State::kConnecting;
    lock.unlock();
    wake_();
    lock.lock();
    changed_.wait_for(lock, stop, kAgain, [] { return false; });
  }
}

base::Failure LoomLink::connect_once(const std::string& address, const std::stop_token& stop) {
  const auto line = loom::open_line(connector_, address, kConnect, stop);
  if (!line) return failed(line);
  talk(**line, stop);
  return base::failure(base::ErrorKind::kOutput, tr("the connection was lost"));
}

void LoomLink::talk(platform::Line& line, const std::stop_token& stop) {
  loom::Protocol protocol{};
  {
    const std::lock_guard lock(mutex_);
    if (stop.stop_requested()) return;
    state_ = State::kConnected;
    protocol = protocol_;
    why_.clear();
    to_send_.clear();
    received_.connected = true;
  }
  wake_();
  loom::LoomReader reader(protocol);
  while (!line.broken() && !stop.stop_requested() && exchange_once(line, reader, stop)) {
  }
}

bool LoomLink::exchange_once(platform::Line& line, loom::LoomReader& reader, const std::stop_token& stop) {
  std::string out;
  bool room = false;
  {
    std::unique_lock lock(mutex_);
    const auto has_room = [this] { return received_.reports.size() < kMaxReports; };
    changed_.wait(lock, stop, [&] { return has_room() || !to_send_.empty(); });
    out = std::exchange(to_send_, {});
    room = has_room();
  }
  if (!out.empty() && !line.send(out)) return false;
  if (!room) return true;
  std::vector<loom::LoomReport> said = reader.parse(line.receive(kListen));
  if (said.empty()) return true;
  {
    const std::lock_guard lock(mutex_);
    if (stop.stop_requested()) return false;
    std::move(said.begin(), said.end(), std::back_inserter(received_.reports));
  }
  wake_();
  return true;
}

}  // namespace weftlight::session
