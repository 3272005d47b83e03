#include "session/loom_link.h"

#include <chrono>
#include <utility>

#include "base/caught.h"
#include "base/text.h"

namespace weftlight::session {

using base::tr;

namespace {

constexpr std::chrono::seconds kAgain{2};
constexpr int kConnectMs = 1500, kListenMs = 20;

}  // namespace

LoomLink::LoomLink(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { work(); }) {}

LoomLink::~LoomLink() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
    address_.clear();
  }
  changed_.notify_all();
  thread_.join();
}

void LoomLink::connect(const std::string& address) {
  const std::lock_guard lock(mutex_);
  address_ = address;
  to_send_.clear();
  why_.clear();
  news_ = {};
  state_ = address.empty() ? State::kOff : State::kConnecting;
  changed_.notify_all();
}

void LoomLink::disconnect() { connect({}); }

void LoomLink::send(const std::string& bytes) {
  const std::lock_guard lock(mutex_);
  if (state_ == State::kConnected) to_send_ += bytes;
}

LoomLink::News LoomLink::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

LoomLink::State LoomLink::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::string LoomLink::why() const {
  const std::lock_guard lock(mutex_);
  return why_;
}

bool LoomLink::wanted(const std::string& address) const {
  const std::lock_guard lock(mutex_);
  return address == address_;
}

void LoomLink::work() {
  std::unique_lock lock(mutex_);
  while (!leaving_) {
    if (address_.empty()) {
      changed_.wait(lock);
      continue;
    }
    const std::string address = address_;
    lock.unlock();
    std::string why;
    const std::string thrown = caught([&] {
      const loom::LineOpened opened = loom::open_line(address, kConnectMs);
      if (opened.line) talk(*opened.line, address);
      why = opened.line ? tr("the connection was lost") : opened.why;
    });
    lock.lock();
    if (address != address_) continue;
    why_ = thrown.empty() ? why : thrown;
    state_ = State::kConnecting;
    lock.unlock();
    wake_();
    lock.lock();
    changed_.wait_for(lock, kAgain, [&] { return address != address_; });
  }
}

void LoomLink::talk(loom::Line& line, const std::string& address) {
  loom::LoomReader reader;
  {
    const std::lock_guard lock(mutex_);
    if (address != address_) return;
    state_ = State::kConnected;
    why_.clear();
    to_send_.clear();
    news_.connected = true;
  }
  wake_();
  while (!line.broken() && wanted(address)) {
    std::string out;
    {
      const std::lock_guard lock(mutex_);
      out = std::exchange(to_send_, {});
    }
    if (!out.empty() && !line.send(out)) return;
    std::vector<loom::LoomReport> said = reader.parse(line.receive(kListenMs));
    if (said.empty()) continue;
    {
      const std::lock_guard lock(mutex_);
      if (address != address_) return;
      for (loom::LoomReport& one : said) news_.reports.push_back(std::move(one));
    }
    wake_();
  }
}

}  // namespace weftlight::session
