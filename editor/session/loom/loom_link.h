#pragma once
// The connection to a loom, on its own thread: bytes to send and reports received are queued. A lost connection is
// retried every two seconds until disconnect().

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "base/result.h"
#include "loom/open_line.h"
#include "loom/protocol.h"
#include "platform/line.h"

namespace weftlight::session {

class LoomLink {
 public:
  enum class State { kOff, kConnecting, kConnected };

  /// `wake` is called on the thread, without any lock, when there is an update. `look_up` finds hosts by their names.
  explicit LoomLink(std::function<void()> wake, platform::LookUpHost look_up = platform::look_up_host);
  /// Waits for nothing but the thread's last step, whatever the connection is doing.
  ~LoomLink();
  LoomLink(const LoomLink&) = delete;
  LoomLink& operator=(const LoomLink&) = delete;

  /// "tcp:HOST:PORT" or "serial:PORT[:BAUD]"; `protocol`: how the loom speaks.
  void connect(const std::string& address, loom::Protocol protocol = loom::Protocol::kPlain);
  void disconnect();
  /// Does nothing without a connection.
  void send(const std::string& bytes);

  /// While this many reports are not yet taken, nothing more is read from the loom.
  static constexpr size_t kMaxReports = 256;
  struct Received {
    bool connected = false;  // connected or reconnected since the last call
    std::vector<loom::LoomReport> reports;
  };
  Received take();
  State state() const;
  /// Why the connection failed; empty while it stands or is being tried.
  std::string why() const;

 private:
  void work();
  /// One attempt, until the connection ends; never without an error. `stop`: the connection is no longer wanted.
  base::Failure connect_once(const std::string& address, const std::stop_token& stop);
  /// Sends and receives until the connection breaks or is no longer wanted.
  void talk(platform::Line& line, const std::stop_token& stop);
  /// Sends what waits and hears what came. False if the line takes no more.
  bool exchange_once(platform::Line& line, loom::LoomReader& reader, const std::stop_token& stop);

  std::function<void()> wake_;
  platform::LineConnector connector_;  // of the thread alone
  mutable std::mutex mutex_;           // guards all below
  std::condition_variable_any changed_;
  std::string address_, to_send_, why_;  // an empty address means disconnected
  loom::Protocol protocol_ = loom::Protocol::kPlain;
  std::stop_source wanted_;  // stopped when the address changes
  State state_ = State::kOff;
  Received received_;
  bool leaving_ = false;
  std::thread thread_;
};

}  // namespace weftlight::session
