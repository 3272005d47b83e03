#pragma once
// A reproducible cost: the instructions that the processor executes for a pixel of the real draw in Mesa's software
// renderer, including texture fetches. They are counted in a separate process (platform/step_counter.h) that draws with
// one thread, also on a machine with a graphics card.

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "light/lod_table.h"
#include "platform/step_counter.h"

namespace weftlight::chart {

using design::Method;
using light::LodTable;

struct CountedDraw {
  size_t scene = 0;
  int view_deg = 0;
  double yarns_per_pixel = 1;
  Method method = Method::kAuto;
  int samples = 1;
};

class DrawCounter {
 public:
  /// Draws a patch of pixels x pixels and waits for it; false on failure.
  using Draw = std::function<bool(const CountedDraw&, const LodTable&, int pixels)>;
  /// Call it before this process makes an OpenGL context; `draw` runs in the other process. Null where instructions
  /// cannot be counted.
  static std::unique_ptr<DrawCounter> start(const Draw& draw);

  /// Instructions per pixel: the difference of two patches, which cancels the cost per draw.
  std::optional<double> per_pixel(const CountedDraw& what, const LodTable& lod_table);

 private:
  explicit DrawCounter(std::unique_ptr<platform::StepCounter> steps) : steps_(std::move(steps)) {}
  std::unique_ptr<platform::StepCounter> steps_;
};

}  // namespace weftlight::chart
