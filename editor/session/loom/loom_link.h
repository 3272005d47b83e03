#pragma once
// The connection to a loom, on its own thread: bytes to send and reports received are queued. A lost connection is
// retried every two seconds until disconnect().

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "loom/line.h"
#include "loom/protocol.h"
#include "session/files/names.h"

namespace weftlight::session {

class LoomLink {
 public:
  enum class State { kOff, kConnecting, kConnected };

  /// `wake` is called on the thread when there is an update.
  explicit LoomLink(std::function<void()> wake);
  ~LoomLink();
  LoomLink(const LoomLink&) = delete;
  LoomLink& operator=(const LoomLink&) = delete;

  /// "tcp:HOST:PORT" or "serial:PORT[:BAUD]".
  void connect(const std::string& address);
  void disconnect();
  /// Does nothing without a connection.
  void send(const std::string& bytes);

  struct News {
    bool connected = false;  // connected or reconnected since the last call
    std::vector<loom::LoomReport> reports;
  };
  News take();
  State state() const;
  /// Why the connection failed; empty while it stands or is being tried.
  std::string why() const;

 private:
  void work();
  /// Sends and receives until the connection breaks or is no longer wanted.
  void talk(loom::Line& line, const std::string& address);
  bool wanted(const std::string& address) const;

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::string address_, to_send_, why_;  // an empty address means disconnected
  State state_ = State::kOff;
  News news_;
  bool leaving_ = false;
  std::thread thread_;
};

}  // namespace weftlight::session
