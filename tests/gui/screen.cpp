#include "screen.h"

#include <poll.h>
#include <xcb/xcb.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace weftlight::gui {
namespace {

struct Free {
  void operator()(void* reply) const { std::free(reply); }
};

/// Of a screen of 24 bits in four bytes each: blue, green, red, nothing.
std::string as_ppm(const uint8_t* pixels, int width, int height) {
  std::string ppm = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  const size_t count = static_cast<size_t>(width) * static_cast<size_t>(height);
  ppm.reserve(ppm.size() + 3 * count);
  for (const uint8_t* p = pixels; p != pixels + 4 * count; p += 4)
    for (const int channel : {2, 1, 0}) ppm.push_back(static_cast<char>(p[channel]));
  return ppm;
}

/// Null if there is no such display.
using Server = std::unique_ptr<xcb_connection_t, void (*)(xcb_connection_t*)>;
Server connect(const std::string& display) {
  Server server(xcb_connect(display.c_str(), nullptr), xcb_disconnect);
  if (xcb_connection_has_error(server.get()) != 0) server.reset();
  return server;
}

const xcb_screen_t* screen_of(xcb_connection_t* server) { return xcb_setup_roots_iterator(xcb_get_setup(server)).data; }

xcb_atom_t atom(xcb_connection_t* server, std::string_view name) {
  const auto asked = xcb_intern_atom(server, 0, static_cast<uint16_t>(name.size()), name.data());
  const std::unique_ptr<xcb_intern_atom_reply_t, Free> reply(xcb_intern_atom_reply(server, asked, nullptr));
  return reply ? reply->atom : xcb_atom_t{XCB_ATOM_NONE};
}

/// The question of a window manager whether a window is alive (_NET_WM_PING of the Extended Window Manager Hints),
/// which it answers in the order of its events: each input sent before has then been taken.
class Pings {
 public:
  explicit Pings(xcb_connection_t* server)
      : server_(server),
        root_(screen_of(server)->root),
        protocols_(atom(server, "WM_PROTOCOLS")),
        ping_(atom(server, "_NET_WM_PING")) {
    const uint32_t events = XCB_EVENT_MASK_SUBSTRUCTURE_NOTIFY;
    xcb_change_window_attributes(server_, root_, XCB_CW_EVENT_MASK, &events);
  }

  /// The windows on the screen that answer.
  std::vector<xcb_window_t> windows() const {
    const std::unique_ptr<xcb_query_tree_reply_t, Free> tree(
        xcb_query_tree_reply(server_, xcb_query_tree(server_, root_), nullptr));
    if (!tree) return {};
    const xcb_window_t* const first = xcb_query_tree_children(tree.get());
    std::vector<xcb_window_t> found(first, first + xcb_query_tree_children_length(tree.get()));
    std::erase_if(found, [this](xcb_window_t w) { return !is_shown(w) || !answers(w); });
    return found;
  }

  /// False if the window did not answer until then; a window that went away counts as one that did.
  bool ask(xcb_window_t window, std::chrono::steady_clock::time_point until) {
    xcb_client_message_event_t question{};
    question.response_type = XCB_CLIENT_MESSAGE;
    question.format = 32;
    question.window = window;
    question.type = protocols_;
    question.data.data32[0] = ping_;
    question.data.data32[1] = ++asked_;
    question.data.data32[2] = window;
    xcb_send_event(server_, 0, window, XCB_EVENT_MASK_NO_EVENT, reinterpret_cast<const char*>(&question));
    xcb_flush(server_);
    while (xcb_connection_has_error(server_) == 0) {
      while (const auto event = next())
        if (settles(*event, window)) return true;
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
      if (left <= 0) return false;
      pollfd waiting{xcb_get_file_descriptor(server_), POLLIN, 0};
      poll(&waiting, 1, static_cast<int>(left));
    }
    return true;
  }

 private:
  std::unique_ptr<xcb_generic_event_t, Free> next() const {
    return std::unique_ptr<xcb_generic_event_t, Free>(xcb_poll_for_event(server_));
  }

  bool settles(const xcb_generic_event_t& event, xcb_window_t window) const {
    switch (event.response_type & 0x7F) {
      case XCB_CLIENT_MESSAGE: {
        const auto& answer = reinterpret_cast<const xcb_client_message_event_t&>(event);
        return answer.data.data32[0] == ping_ && answer.data.data32[1] == asked_;
      }
      case XCB_UNMAP_NOTIFY:
        return reinterpret_cast<const xcb_unmap_notify_event_t&>(event).window == window;
      case XCB_DESTROY_NOTIFY:
        return reinterpret_cast<const xcb_destroy_notify_event_t&>(event).window == window;
      default:
        return false;
    }
  }

  bool is_shown(xcb_window_t window) const {
    const std::unique_ptr<xcb_get_window_attributes_reply_t, Free> reply(
        xcb_get_window_attributes_reply(server_, xcb_get_window_attributes(server_, window), nullptr));
    return reply && reply->map_state == XCB_MAP_STATE_VIEWABLE;
  }

  bool answers(xcb_window_t window) const {
    const std::unique_ptr<xcb_get_property_reply_t, Free> reply(xcb_get_property_reply(
        server_, xcb_get_property(server_, 0, window, protocols_, XCB_ATOM_ATOM, 0, 32), nullptr));
    if (!reply || reply->format != 32) return false;
    const auto* const atoms = static_cast<const xcb_atom_t*>(xcb_get_property_value(reply.get()));
    return std::find(atoms, atoms + reply->value_len, ping_) != atoms + reply->value_len;
  }

  xcb_connection_t* server_;
  xcb_window_t root_;
  xcb_atom_t protocols_, ping_;
  uint32_t asked_ = 0;
};

}  // namespace

void wait_for_windows(const std::string& display) {
  using namespace std::chrono_literals;
  // It draws four frames after an event (FrameSchedule) and looks for events before each.
  constexpr int kFrames = 5;
  const Server server = connect(display);
  if (!server) return;
  Pings pings(server.get());
  const auto until = std::chrono::steady_clock::now() + 10s;
  for (const xcb_window_t window : pings.windows())
    for (int i = 0; i < kFrames && pings.ask(window, until); ++i) {
    }
}

std::optional<std::pair<int, int>> corner_of_window(const std::string& display) {
  const Server server = connect(display);
  if (!server) return {};
  std::optional<std::pair<int, int>> corner;
  int largest = 0;
  for (const xcb_window_t window : Pings(server.get()).windows()) {
    const std::unique_ptr<xcb_get_geometry_reply_t, Free> place(
        xcb_get_geometry_reply(server.get(), xcb_get_geometry(server.get(), window), nullptr));
    if (!place || place->width * place->height <= largest) continue;
    largest = place->width * place->height;
    corner.emplace(place->x, place->y);
  }
  return corner;
}

std::string screen_part(const std::string& display, int x, int y, int width, int height) {
  const Server server = connect(display);
  if (!server) return {};
  const xcb_screen_t* screen = screen_of(server.get());
  const int x0 = std::max(x, 0), y0 = std::max(y, 0);
  width = std::min(x + width, int{screen->width_in_pixels}) - x0;
  height = std::min(y + height, int{screen->height_in_pixels}) - y0;
  if (width <= 0 || height <= 0) return {};
  const auto asked = xcb_get_image(server.get(), XCB_IMAGE_FORMAT_Z_PIXMAP, screen->root, static_cast<int16_t>(x0),
                                   static_cast<int16_t>(y0), static_cast<uint16_t>(width),
                                   static_cast<uint16_t>(height), ~uint32_t{0});
  const std::unique_ptr<xcb_get_image_reply_t, Free> image(xcb_get_image_reply(server.get(), asked, nullptr));
  const size_t wanted = 4 * static_cast<size_t>(width) * static_cast<size_t>(height);
  if (!image || static_cast<size_t>(xcb_get_image_data_length(image.get())) < wanted) return {};
  return as_ppm(xcb_get_image_data(image.get()), width, height);
}

}  // namespace weftlight::gui
