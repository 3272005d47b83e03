#include "chart/counter.h"

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "platform/environment_variables.h"

namespace weftlight::chart {

using light::LodPoint;

namespace {

constexpr int kSmall = 4, kLarge = 12;  // pixels along the sides of the two patches

/// What the other process is asked: this, and the points of the LOD table.
struct Request {
  CountedDraw what;
  int pixels = 0;
};
static_assert(std::is_trivially_copyable_v<Request> && std::is_trivially_copyable_v<LodPoint>);

std::string request_for(const CountedDraw& what, const LodTable& lod_table, int pixels) {
  const Request request{what, pixels};
  std::string bytes(reinterpret_cast<const char*>(&request), sizeof request);
  bytes.append(reinterpret_cast<const char*>(lod_table.data()), lod_table.size() * sizeof(LodPoint));
  return bytes;
}

bool draw_requested(const DrawCounter::Draw& draw, std::string_view bytes) {
  Request request;
  std::memcpy(&request, bytes.data(), sizeof request);
  bytes.remove_prefix(sizeof request);
  LodTable lod_table(bytes.size() / sizeof(LodPoint));
  if (!bytes.empty()) std::memcpy(lod_table.data(), bytes.data(), bytes.size());
  return draw(request.what, lod_table, request.pixels);
}

}  // namespace

std::unique_ptr<DrawCounter> DrawCounter::start(const Draw& draw) {
  auto steps = platform::StepCounter::start([draw, begun = false](std::string_view request) mutable {
    if (!std::exchange(begun, true)) {  // Mesa's software renderer, on one thread
      platform::set_variable("LP_NUM_THREADS", "0");
      platform::set_variable("LIBGL_ALWAYS_SOFTWARE", "1");
    }
    return draw_requested(draw, request);
  });
  return steps ? std::unique_ptr<DrawCounter>(new DrawCounter(std::move(steps))) : nullptr;
}

std::optional<double> DrawCounter::per_pixel(const CountedDraw& what, const LodTable& lod_table) {
  const auto small = steps_->count(request_for(what, lod_table, kSmall));
  const auto large = small ? steps_->count(request_for(what, lod_table, kLarge)) : std::nullopt;
  if (!large) return std::nullopt;
  return static_cast<double>(*large - *small) / (kLarge * kLarge - kSmall * kSmall);
}

}  // namespace weftlight::chart
