#include "platform/page_server.h"

#include <array>
#include <asio.hpp>
#include <atomic>
#include <map>
#include <mutex>
#include <utility>

#include "platform/keep_from_children.h"

namespace weftlight::platform {

using asio::ip::tcp;
using std::chrono::milliseconds;

/// What the server's thread and its connections share. Only `refusals` is read by other threads.
struct PageServer::Body : std::enable_shared_from_this<PageServer::Body> {
  Handler handler;
  std::function<void()> refused;
  PageLimits limits;
  std::mutex mutex;
  PageRefusals refusals;  // guarded by the mutex
  int open = 0;
  std::map<std::string, int> of_peer;  // of those that are open
  std::chrono::steady_clock::time_point told{};
  // Last, so that connections that end with it still find the counts.
  asio::io_context io{1};
  tcp::acceptor acceptor{io};
  asio::steady_timer pause{io};

  void accept();
  void welcome(tcp::socket socket, const std::string& peer);
  void turn_away(const std::string& peer, bool of_connection);
};

/// Lives as long as one of its operations does.
class PageServer::Connection : public std::enable_shared_from_this<PageServer::Connection> {
 public:
  Connection(Body& body, tcp::socket socket, std::string peer)
      : body_(body), socket_(std::move(socket)), timer_(body.io), peer_(std::move(peer)) {
    ++body_.open;
    ++body_.of_peer[peer_];
  }
  ~Connection() {
    --body_.open;
    if (const auto count = body_.of_peer.find(peer_); --count->second == 0) body_.of_peer.erase(count);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void begin() {
    after(body_.limits.request, [this] {
      body_.turn_away(peer_, true);
      close();
    });
    receive();
  }
  /// Sends the answer, if none is on its way.
  void answer(const PageAnswer& answer) {
    if (std::exchange(answered_, true) || !socket_.is_open()) return;
    bytes_ = answer_bytes(answer);
    after(body_.limits.sent, [this] { close(); });
    asio::async_write(socket_, asio::buffer(bytes_), [self = shared_from_this()](std::error_code error, size_t) {
      if (error) self->close();
      else self->end();
    });
  }

 private:
  /// Runs `what` then, unless another call comes first.
  template <class What>
  void after(milliseconds wait, What what) {
    timer_.expires_after(wait);
    timer_.async_wait([self = shared_from_this(), what](std::error_code error) {
      if (!error) what();
    });
  }
  void close() {
    timer_.cancel();
    std::error_code ignored;
    socket_.close(ignored);
  }
  /// Hears the peer to the end of its request, and then whether it hangs up.
  void receive() {
    socket_.async_read_some(asio::buffer(part_), [self = shared_from_this()](std::error_code error, size_t size) {
      if (error) self->close();
      else self->received(size);
    });
  }
  void received(size_t size) {
    if (reader_.read({part_.data(), 0}) == PageRequestReader::State::kMore) {
      switch (reader_.read({part_.data(), size})) {
        case PageRequestReader::State::kMore:
          break;
        case PageRequestReader::State::kRefused:
          body_.turn_away(peer_, false);
          answer({reader_.status()});
          break;
        case PageRequestReader::State::kDone:
          handle();
          break;
      }
    } else if ((after_ += size) > kMaxAfter) {
      return close();
    }
    if (socket_.is_open()) receive();
  }
  void handle() {
    after(body_.limits.held, [this] { answer({204}); });
    PageRequest request = reader_.request();
    request.peer = peer_;
    body_.handler(request, [to = weak_from_this(), server = body_.weak_from_this()](PageAnswer reply) {
      const std::shared_ptr<Body> body = server.lock();
      if (!body) return;
      asio::post(body->io, [to, reply = std::move(reply)] {
        if (const std::shared_ptr<Connection> connection = to.lock()) connection->answer(reply);
      });
    });
  }
  /// Without this pause the answer could be lost, where the peer has sent more than was read.
  void end() {
    std::error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    after(body_.limits.ending, [this] { close(); });
  }

  static constexpr size_t kMaxAfter = 65536;  // bytes that are heard, and forgotten, after a request

  Body& body_;
  tcp::socket socket_;
  asio::steady_timer timer_;
  std::string peer_, bytes_;
  std::array<char, 2048> part_;
  PageRequestReader reader_;
  size_t after_ = 0;
  bool answered_ = false;
};

void PageServer::Body::turn_away(const std::string& peer, bool of_connection) {
  {
    const std::lock_guard lock(mutex);
    ++(of_connection ? refusals.connections : refusals.requests);
    refusals.peer = peer;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - told < std::chrono::seconds(1)) return;
  told = now;
  refused();
}

void PageServer::Body::welcome(tcp::socket socket, const std::string& peer) {
  const auto same = of_peer.find(peer);
  if (open >= limits.connections || (same != of_peer.end() && same->second >= limits.of_one_peer))
    return turn_away(peer, true);
  std::make_shared<Connection>(*this, std::move(socket), peer)->begin();
}

void PageServer::Body::accept() {
  acceptor.async_accept([this](std::error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (error) {
      // No file handles are left, say: they may come back.
      pause.expires_after(milliseconds(100));
      return pause.async_wait([this](std::error_code ended) {
        if (!ended) accept();
      });
    }
    // Another is awaited first, so that what this one throws ends this one alone.
    accept();
    keep_from_children(socket.native_handle());
    std::error_code gone;
    const tcp::endpoint peer = socket.remote_endpoint(gone);
    if (!gone) welcome(std::move(socket), peer.address().to_string());
  });
}

tl::expected<std::unique_ptr<PageServer>, std::error_code> PageServer::open(const std::string& address, uint16_t port,
                                                                            Handler handler,
                                                                            std::function<void()> refused,
                                                                            PageLimits limits) {
  std::error_code error;
  const asio::ip::address at = asio::ip::make_address(address, error);
  if (error) return tl::unexpected(error);
  std::unique_ptr<PageServer> server(new PageServer);
  server->body_ = std::make_shared<Body>();
  Body& body = *server->body_;
  body.handler = std::move(handler);
  body.refused = std::move(refused);
  body.limits = limits;
  const tcp::endpoint endpoint(at, port);
  body.acceptor.open(endpoint.protocol(), error);
  if (!error) keep_from_children(body.acceptor.native_handle());
#ifndef _WIN32  // where it would let two programs listen at one port, and is not needed after an end
  if (!error) body.acceptor.set_option(tcp::acceptor::reuse_address(true), error);
#endif
  if (!error) body.acceptor.bind(endpoint, error);
  if (!error) body.acceptor.listen(limits.connections, error);
  if (error) return tl::unexpected(std::error_code(error.value(), std::system_category()));
  const std::string number = std::to_string(body.acceptor.local_endpoint().port());
  server->host_ = (at.is_v6() ? "[" + at.to_string() + "]:" : at.to_string() + ":") + number;
  body.accept();
  server->thread_ = std::thread([&body] {
    for (bool ended = false; !ended;) {
      try {
        body.io.run();
        ended = true;
      } catch (...) {  // no memory for one connection, which has closed
      }
    }
  });
  return server;
}

PageServer::~PageServer() {
  if (!body_) return;
  body_->io.stop();
  if (thread_.joinable()) thread_.join();
}

PageRefusals PageServer::refusals() const {
  const std::lock_guard lock(body_->mutex);
  return body_->refusals;
}

}  // namespace weftlight::platform
