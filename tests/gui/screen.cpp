#include "screen.h"

#include <xcb/xcb.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>

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

}  // namespace

std::string screen_part(const std::string& display, int x, int y, int width, int height) {
  const std::unique_ptr<xcb_connection_t, void (*)(xcb_connection_t*)> server(xcb_connect(display.c_str(), nullptr),
                                                                              xcb_disconnect);
  if (xcb_connection_has_error(server.get()) != 0) return {};
  const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(server.get())).data;
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
