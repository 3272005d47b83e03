#pragma once
// Which of many directions from a place on a thread meet other threads: all of them at once, since the threads near
// by are the same for all, where rays one by one would fetch them anew for each.

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "cloth/thread_scene.h"
#include "light/names.h"

namespace weftlight::light {

/// Unit vectors, all above the cloth or all below it, in rows for the processor's vectors. Known by their number.
struct Directions {
  std::vector<float> x, y, z;
  std::vector<float> slant;  // way in the plane for a height of 1
  std::vector<uint16_t> number;
  size_t size() const { return number.size(); }
  void add(const glm::vec3& w, size_t number);
  void add_from(const Directions& from, size_t k);
  void reserve(size_t count);
};

class ThreadShadows {
 public:
  explicit ThreadShadows(ThreadScene& scene);
  /// Takes out those that meet a thread other than thread `thread` of the system; only_it: that meet just that one.
  void cast(Directions& open, const glm::vec3& from, int system, int thread, bool only_it = false);

 private:
  using ThreadGrid = ThreadScene::ThreadGrid;
  struct Around;
  void cast_layer(Directions& open, const ThreadGrid& grid, Around& around);
  static void leave_before(Directions& open, Directions& through, std::vector<float>& clear, Around& around,
                           float depth, float away);
  void cast_span(Directions& open, std::vector<float>& clear, const ThreadGrid& grid, const Around& around, int system,
                 int across, int along);

  ThreadScene& scene_;  // its formulas are not const
  std::vector<ThreadGrid> layers_;
};

}  // namespace weftlight::light
