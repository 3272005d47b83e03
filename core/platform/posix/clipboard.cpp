// Based on: Inter-Client Communication Conventions Manual 2.0, section 2, "Peer-to-Peer Communication by Means of
// Selections". GLFW 3.3 waits for the owner's answer without an end.
#include "platform/clipboard.h"

#if __has_include(<xcb/xcb.h>)

#include <dlfcn.h>
#include <poll.h>
#include <xcb/xcb.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

namespace weftlight::platform {
namespace {

using Clock = std::chrono::steady_clock;
using State = ClipboardText::State;

constexpr std::chrono::milliseconds kPatience{1000};  // for one answer
constexpr std::chrono::milliseconds kLongest{3000};   // for all of them
constexpr size_t kMaxText = size_t{64} << 20;
constexpr uint32_t kPieceWords = 1u << 16;  // of four bytes, asked for at once

struct Free {
  void operator()(void* reply) const { std::free(reply); }
};
template <class Reply>
using Owned = std::unique_ptr<Reply, Free>;

class Connection {
 public:
  Connection() : x_(xcb_connect(nullptr, nullptr)) {
    if (!is_open()) return;
    clipboard = atom("CLIPBOARD");
    utf8 = atom("UTF8_STRING");
    incremental = atom("INCR");
    property_ = atom("WEFTLIGHT_PASTE");
    window_ = xcb_generate_id(x_);
    const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(x_)).data;
    const uint32_t events = XCB_EVENT_MASK_PROPERTY_CHANGE;
    xcb_create_window(x_, 0, window_, screen->root, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_ONLY, XCB_COPY_FROM_PARENT,
                      XCB_CW_EVENT_MASK, &events);
  }
  ~Connection() { xcb_disconnect(x_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool is_open() const { return xcb_connection_has_error(x_) == 0; }
  xcb_window_t owner() const {
    const Owned<xcb_get_selection_owner_reply_t> reply(
        xcb_get_selection_owner_reply(x_, xcb_get_selection_owner(x_, clipboard), nullptr));
    return reply ? reply->owner : 0;
  }
  /// Whether one client made both.
  bool of_one_client(xcb_window_t a, xcb_window_t b) const {
    const uint32_t mask = ~xcb_get_setup(x_)->resource_id_mask;
    return (a & mask) == (b & mask);
  }
  /// Has the owner put the clipboard into the property.
  void ask_for(xcb_atom_t type) {
    until_ = std::min(Clock::now() + kPatience, end_);
    xcb_convert_selection(x_, window_, clipboard, type, property_, XCB_CURRENT_TIME);
    xcb_flush(x_);
  }
  /// The next event of that type; null if none comes in time.
  Owned<xcb_generic_event_t> wait_for(uint8_t type) {
    for (;;) {
      Owned<xcb_generic_event_t> event(xcb_poll_for_event(x_));
      if (event && (event->response_type & 0x7f) == type) return event;
      if (event) continue;
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until_ - Clock::now()).count();
      if (left <= 0 || !is_open()) return {};
      pollfd ready{xcb_get_file_descriptor(x_), POLLIN, 0};
      ::poll(&ready, 1, static_cast<int>(left));
    }
  }
  /// Waits until the owner has set the property; false if it does not.
  bool wait_for_property() {
    until_ = std::min(Clock::now() + kPatience, end_);
    while (const auto event = wait_for(XCB_PROPERTY_NOTIFY)) {
      const auto& change = reinterpret_cast<const xcb_property_notify_event_t&>(*event);
      if (change.atom == property_ && change.state == XCB_PROPERTY_NEW_VALUE) return true;
    }
    return false;
  }
  struct Property {
    xcb_atom_t type = XCB_ATOM_NONE;
    std::string bytes;
    bool whole = true;  // else there is more than may be taken
  };
  /// Takes the property away, which tells the owner to go on.
  Property take_property(size_t most) {
    Property out;
    for (uint32_t at = 0;; at += kPieceWords) {
      const Owned<xcb_get_property_reply_t> piece(xcb_get_property_reply(
          x_, xcb_get_property(x_, 1, window_, property_, XCB_GET_PROPERTY_TYPE_ANY, at, kPieceWords), nullptr));
      if (!piece) return out;
      out.type = piece->type;
      const auto* bytes = static_cast<const char*>(xcb_get_property_value(piece.get()));
      out.bytes.append(bytes, static_cast<size_t>(xcb_get_property_value_length(piece.get())));
      out.whole = out.bytes.size() <= most;
      if (piece->bytes_after == 0 || !out.whole) return out;
    }
  }

  xcb_atom_t clipboard = 0, utf8 = 0, incremental = 0;

 private:
  xcb_atom_t atom(std::string_view name) const {
    const Owned<xcb_intern_atom_reply_t> reply(
        xcb_intern_atom_reply(x_, xcb_intern_atom(x_, 0, static_cast<uint16_t>(name.size()), name.data()), nullptr));
    return reply ? reply->atom : xcb_atom_t{XCB_ATOM_NONE};
  }

  xcb_connection_t* x_;
  xcb_window_t window_ = 0;
  xcb_atom_t property_ = 0;
  Clock::time_point end_ = Clock::now() + kLongest, until_ = end_;
};

/// What the owner sends in pieces, the last of which is empty.
ClipboardText in_pieces(Connection& x) {
  ClipboardText out{State::kText};
  while (x.wait_for_property()) {
    const Connection::Property piece = x.take_property(kMaxText - out.text.size());
    if (!piece.whole) return {State::kNone};
    if (piece.bytes.empty()) return out;
    out.text += piece.bytes;
  }
  return {State::kSilent};
}

std::string utf8_of_latin1(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80) out += static_cast<char>(0xc0 | (code >> 6));
    out += code < 0x80 ? c : static_cast<char>(0x80 | (code & 0x3f));
  }
  return out;
}

/// kNone if the owner has no such text.
ClipboardText text_as(Connection& x, xcb_atom_t type) {
  x.ask_for(type);
  const auto event = x.wait_for(XCB_SELECTION_NOTIFY);
  if (!event) return {State::kSilent};
  if (reinterpret_cast<const xcb_selection_notify_event_t&>(*event).property == XCB_ATOM_NONE) return {State::kNone};
  Connection::Property answer = x.take_property(kMaxText);
  if (answer.type == x.incremental) return in_pieces(x);
  if (!answer.whole) return {State::kNone};
  return {State::kText, std::move(answer.bytes)};
}

/// The window's name in X; 0 if the window system is another. The window library alone knows it.
xcb_window_t x_window_of(void* window) {
  static auto* const name_of = reinterpret_cast<unsigned long (*)(void*)>(dlsym(RTLD_DEFAULT, "glfwGetX11Window"));
  return name_of != nullptr && window != nullptr ? static_cast<xcb_window_t>(name_of(window)) : 0;
}

}  // namespace

ClipboardText clipboard_text(void* window) {
  const xcb_window_t own = x_window_of(window);
  if (own == 0) return {};
  Connection x;
  if (!x.is_open()) return {};
  const xcb_window_t owner = x.owner();
  if (owner == 0) return {State::kNone};
  if (x.of_one_client(owner, own)) return {State::kOwn};
  ClipboardText text = text_as(x, x.utf8);
  if (text.state != State::kNone) return text;
  text = text_as(x, XCB_ATOM_STRING);
  text.text = utf8_of_latin1(text.text);
  return text;
}

}  // namespace weftlight::platform

#else

namespace weftlight::platform {

ClipboardText clipboard_text(void*) { return {}; }

}  // namespace weftlight::platform

#endif
