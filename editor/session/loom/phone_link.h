#pragma once
// The page for a phone at the loom, served while it is asked for. Its requests are answered on the server's thread from
// what was shown last; steps are queued for the window's.

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/result.h"
#include "loom/phone_page.h"
#include "platform/page_server.h"

namespace weftlight::session {

using loom::PhoneShown, loom::PhoneStep;

class PhoneLink {
 public:
  /// `wake` is called on the server's thread, without any lock, when there is an update.
  explicit PhoneLink(std::function<void()> wake);
  ~PhoneLink();
  PhoneLink(const PhoneLink&) = delete;
  PhoneLink& operator=(const PhoneLink&) = delete;

  /// The port that is tried first; if another program has it, any that is free.
  static constexpr uint16_t kPort = 7389;
  /// Serves the page at this address of the machine. A new code; nobody is paired.
  base::Result<void> open(const std::string& address, platform::PageLimits limits = {});
  /// Also forgets who was paired.
  void close();

  /// While the page is served. For the window to show.
  struct Status {
    bool open = false;
    std::string url, code;  // no code: pairing is closed
    size_t paired = 0;
    int wrong_tries = 0;
    platform::PageRefusals refusals;
    bool operator==(const Status&) const = default;
  };
  Status status() const;
  void renew_code();

  /// At most one: a second is not asked for from the same place.
  std::vector<PhoneStep> take_steps();
  /// What the page shows from now on. Call it after the steps that were taken: it answers those who wait.
  void show(PhoneShown shown);

 private:
  /// A request that waits for its step, or for something new.
  struct Waiting {
    platform::PageRequest request;
    platform::PageServer::Reply reply;
    bool stepped = false;
  };
  static constexpr size_t kMaxWaiting =
      64;  // more than connections; the oldest is forgotten, and the server answers it

  void take(const platform::PageRequest& request, const platform::PageServer::Reply& reply);

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards all below but the server
  std::unique_ptr<loom::PhonePage> page_;
  std::vector<Waiting> waiting_;
  std::vector<PhoneStep> steps_;
  bool taken_ = false;                            // steps, since the last show()
  std::unique_ptr<platform::PageServer> server_;  // of the window's thread
};

}  // namespace weftlight::session
