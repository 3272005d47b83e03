#pragma once
// The line to a loom, held by a thread of its own: what is to be said waits for it, what the loom says waits for the
// window. A line that breaks off is made again, every two seconds, until nobody wants it any more.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "loom/line.h"
#include "loom/protocol.h"
#include "session/names.h"

namespace weftlight::session {

class LoomLink {
 public:
  enum class State { kOff, kConnecting, kConnected };

  /// `wake`: called from the thread when there is news.
  explicit LoomLink(std::function<void()> wake);
  ~LoomLink();
  LoomLink(const LoomLink&) = delete;
  LoomLink& operator=(const LoomLink&) = delete;

  /// "tcp:HOST:PORT" or "serial:PORT[:BAUD]".
  void connect(const std::string& address);
  void disconnect();
  /// Lost where no line stands.
  void send(const std::string& bytes);

  struct News {
    bool connected = false;  // the line was made, perhaps again, since the last call
    std::vector<loom::LoomReport> reports;
  };
  News take();
  State state() const;
  /// Why there is no line although one is wanted; empty: there is, or nobody knows yet.
  std::string why() const;

 private:
  void work();
  /// Until the line breaks or is no longer wanted.
  void talk(loom::Line& line, const std::string& address);
  bool wanted(const std::string& address) const;

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // of all below
  std::condition_variable changed_;
  std::string address_, to_send_, why_;  // no address: nobody wants a line
  State state_ = State::kOff;
  News news_;
  bool leaving_ = false;
  std::thread thread_;
};

}  // namespace weftlight::session
