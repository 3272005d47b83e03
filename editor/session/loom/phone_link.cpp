#include "session/loom/phone_link.h"

#include <utility>

#include "base/text.h"
#include "platform/random_bytes.h"

namespace weftlight::session {

using base::ErrorKind, base::arg, base::failure, base::fill, base::tr;
using platform::PageAnswer, platform::PageRequest, platform::PageServer;

PhoneLink::PhoneLink(std::function<void()> wake) : wake_(std::move(wake)) {}

PhoneLink::~PhoneLink() { close(); }

base::Result<void> PhoneLink::open(const std::string& address, platform::PageLimits limits) {
  close();
  const auto handler = [this](const PageRequest& request, const PageServer::Reply& reply) { take(request, reply); };
  auto server = PageServer::open(address, kPort, handler, wake_, limits);
  if (!server) server = PageServer::open(address, 0, handler, wake_, limits);
  if (!server)
    return failure(ErrorKind::kOutput, fill(tr("The phone page cannot be started at {address}: {why}"),
                                            arg("address", address), arg("why", server.error().message())));
  auto page = std::make_unique<loom::PhonePage>((*server)->host(), platform::fill_random);
  if (page->code().empty())
    return failure(ErrorKind::kOutput, tr("The system provides no random numbers, so no device can be paired."));
  server_ = std::move(*server);
  const std::lock_guard lock(mutex_);
  page_ = std::move(page);
  return {};
}

void PhoneLink::close() {
  server_.reset();  // its thread has ended then
  const std::lock_guard lock(mutex_);
  page_.reset();
  waiting_.clear();
  steps_.clear();
}

PhoneLink::Status PhoneLink::status() const {
  if (!server_) return {};
  const std::lock_guard lock(mutex_);
  return {true,
          "http://" + server_->host() + "/",
          page_->code(),
          page_->paired(),
          page_->wrong_tries(),
          server_->refusals()};
}

void PhoneLink::renew_code() {
  const std::lock_guard lock(mutex_);
  if (page_) page_->renew_code();
}

std::vector<PhoneStep> PhoneLink::take_steps() {
  const std::lock_guard lock(mutex_);
  taken_ = taken_ || !steps_.empty();
  return std::exchange(steps_, {});
}

void PhoneLink::show(PhoneShown shown) {
  std::vector<std::pair<PageServer::Reply, PageAnswer>> answers;
  {
    const std::lock_guard lock(mutex_);
    if (!page_) return;
    const uint64_t before = page_->revision();
    page_->show(std::move(shown));
    const bool other = page_->revision() != before, stepped = std::exchange(taken_, false);
    std::erase_if(waiting_, [&](const Waiting& one) {
      if (one.stepped ? !stepped : !other) return false;
      answers.emplace_back(one.reply, page_->answer_waiting(one.request));
      return true;
    });
  }
  for (auto& [reply, answer] : answers) reply(std::move(answer));
}

void PhoneLink::take(const PageRequest& request, const PageServer::Reply& reply) {
  std::optional<PageAnswer> answer;
  bool update = false;
  {
    const std::lock_guard lock(mutex_);
    if (!page_) return;
    const size_t paired = page_->paired();
    const int wrong = page_->wrong_tries();
    loom::PhonePage::Outcome outcome = page_->take(request);
    update = paired != page_->paired() || wrong != page_->wrong_tries();
    // A second step from the same place was asked for by another device, which then sees where the first one led.
    const bool stepping = outcome.step && steps_.empty() && !taken_;
    if (stepping) steps_.push_back(*outcome.step);
    update = update || stepping;
    answer = std::move(outcome.answer);
    if (!answer) {
      if (waiting_.size() >= kMaxWaiting) waiting_.erase(waiting_.begin());
      waiting_.push_back({request, reply, outcome.step.has_value()});
    }
  }
  if (answer) reply(std::move(*answer));
  if (update) wake_();
}

}  // namespace weftlight::session
