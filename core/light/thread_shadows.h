#pragma once
// Tests many directions from one point on a thread against the other threads at once, since the threads nearby are the
// same for all of them; rays one by one would fetch them again for each.

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "cloth/thread_scene.h"

namespace weftlight::light {

using cloth::ThreadScene;

/// Unit vectors, all above the cloth or all below it, stored by component for vectorisation; identified by number.
struct Directions {
  std::vector<float> x, y, z;
  std::vector<float> slant;  // distance in the plane for a height of 1
  std::vector<uint16_t> number;
  size_t size() const { return number.size(); }
  void add(const glm::vec3& w, size_t number);
  void add_from(const Directions& from, size_t k);
  void reserve(size_t count);
};

class ThreadShadows {
 public:
  explicit ThreadShadows(ThreadScene& scene);
  /// Removes directions that are occluded by a thread other than `thread` of the system; only_it: by just that thread.
  void cast(Directions& open, const glm::vec3& from, int system, int thread, bool only_it = false);

 private:
  using ThreadGrid = ThreadScene::ThreadGrid;
  struct Around;
  void cast_layer(Directions& open, const ThreadGrid& grid, Around& around);
  static void split_before(Directions& open, Directions& through, std::vector<float>& clear, Around& around,
                           float depth, float away);
  void cast_span(Directions& open, std::vector<float>& clear, const ThreadGrid& grid, const Around& around, int system,
                 int across, int along);

  ThreadScene& scene_;  // its formulas are not const
  std::vector<ThreadGrid> layers_;
};

}  // namespace weftlight::light
