#include "selection_owner.h"

#include <poll.h>
#include <xcb/xcb.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <stop_token>
#include <utility>

namespace weftlight::gui {
namespace {

constexpr size_t kPiece = 16;  // bytes

xcb_atom_t atom(xcb_connection_t* x, const std::string& name) {
  auto* reply =
      xcb_intern_atom_reply(x, xcb_intern_atom(x, 0, static_cast<uint16_t>(name.size()), name.c_str()), nullptr);
  const xcb_atom_t made = reply != nullptr ? reply->atom : 0;
  std::free(reply);
  return made;
}

}  // namespace

struct SelectionOwner::Client {
  xcb_connection_t* x = nullptr;
  Answers how = Answers::kNever;
  std::string text;
  xcb_window_t window = 0, asker = 0;
  xcb_atom_t utf8 = 0, incremental = 0, property = 0;
  size_t sent = 0;
  bool sending = false;
  std::atomic<bool> asked = false;

  void set(xcb_atom_t type, uint8_t format, size_t count, const void* data) const {
    xcb_change_property(x, XCB_PROP_MODE_REPLACE, asker, property, type, format, static_cast<uint32_t>(count), data);
  }
  void answer(const xcb_selection_request_event_t& request) {
    asked = true;
    if (how == Answers::kNever) return;
    asker = request.requestor;
    property = request.property;
    xcb_selection_notify_event_t done{};
    done.response_type = XCB_SELECTION_NOTIFY;
    done.requestor = asker;
    done.selection = request.selection;
    done.target = request.target;
    if (request.target == utf8) {
      done.property = property;
      if (how == Answers::kAtOnce) {
        set(utf8, 8, text.size(), text.data());
      } else {
        const uint32_t events = XCB_EVENT_MASK_PROPERTY_CHANGE, least = static_cast<uint32_t>(text.size());
        xcb_change_window_attributes(x, asker, XCB_CW_EVENT_MASK, &events);
        set(incremental, 32, 1, &least);
        sent = 0;
        sending = true;
      }
    }
    xcb_send_event(x, 0, asker, 0, reinterpret_cast<const char*>(&done));
    xcb_flush(x);
  }
  /// The next piece, once the one before was taken.
  void go_on(const xcb_property_notify_event_t& change) {
    if (!sending || change.window != asker || change.atom != property || change.state != XCB_PROPERTY_DELETE) return;
    const size_t n = std::min(kPiece, text.size() - sent);
    set(utf8, 8, n, text.data() + sent);
    xcb_flush(x);
    sent += n;
    sending = n > 0;
  }
  void serve(const std::stop_token& stop) {
    while (!stop.stop_requested() && xcb_connection_has_error(x) == 0) {
      while (xcb_generic_event_t* event = xcb_poll_for_event(x)) {
        const int type = event->response_type & 0x7f;
        if (type == XCB_SELECTION_REQUEST) answer(*reinterpret_cast<xcb_selection_request_event_t*>(event));
        if (type == XCB_PROPERTY_NOTIFY) go_on(*reinterpret_cast<xcb_property_notify_event_t*>(event));
        std::free(event);
      }
      pollfd ready{xcb_get_file_descriptor(x), POLLIN, 0};
      ::poll(&ready, 1, 20);
    }
  }
};

SelectionOwner::SelectionOwner(const std::string& display, const std::string& selection, Answers how,
                               std::string text) {
  client_ = std::make_shared<Client>();
  const std::shared_ptr<Client>& client = client_;
  client->x = xcb_connect(display.c_str(), nullptr);
  if (xcb_connection_has_error(client->x) != 0) return;
  client->how = how;
  client->text = std::move(text);
  xcb_connection_t* x = client->x;
  client->utf8 = atom(x, "UTF8_STRING");
  client->incremental = atom(x, "INCR");
  client->window = xcb_generate_id(x);
  xcb_create_window(x, 0, client->window, xcb_setup_roots_iterator(xcb_get_setup(x)).data->root, 0, 0, 1, 1, 0,
                    XCB_WINDOW_CLASS_INPUT_ONLY, XCB_COPY_FROM_PARENT, 0, nullptr);
  xcb_set_selection_owner(x, client->window, atom(x, selection), XCB_CURRENT_TIME);
  auto* owner = xcb_get_selection_owner_reply(x, xcb_get_selection_owner(x, atom(x, selection)), nullptr);
  owner_ = owner != nullptr && owner->owner == client->window;
  std::free(owner);
  thread_ = std::jthread([client = client_](const std::stop_token& stop) {
    client->serve(stop);
    xcb_disconnect(client->x);
  });
}

SelectionOwner::~SelectionOwner() = default;

bool SelectionOwner::was_asked() const { return client_->asked; }

}  // namespace weftlight::gui
