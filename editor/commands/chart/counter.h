#pragma once
// Cost that repeats: the instructions that this processor executes for a pixel of the real draw, by Mesa's software
// renderer and the program that draws the row, fetches and all. Counted by the trap flag in a process of its own that
// draws with one thread; the same on a machine with a graphics card.

#include <sys/types.h>

#include <functional>
#include <memory>
#include <optional>

#include "commands/chart/names.h"
#include "light/lod_table.h"

namespace weftlight::chart {

struct CountedDraw {
  size_t scene = 0;
  int view_deg = 0;
  double yarns_per_pixel = 1;
  Method method = Method::kAuto;
  int samples = 1;
};

class DrawCounter {
 public:
  /// Draws a patch of pixels x pixels and waits for it; false where that cannot be.
  using Draw = std::function<bool(const CountedDraw&, const LodTable&, int pixels)>;
  /// Before this process has made any context of OpenGL; `draw` is called in the other one. Null where this
  /// kind of processor is not known.
  static std::unique_ptr<DrawCounter> start(const Draw& draw);
  ~DrawCounter();

  /// Instructions a pixel: the difference of two patches, so that what is done once a draw is not in it.
  std::optional<double> per_pixel(const CountedDraw& what, const LodTable& lod_table);

 private:
  DrawCounter() = default;
  pid_t child_ = -1;
  int line_ = -1;  // this end of it
};

}  // namespace weftlight::chart
