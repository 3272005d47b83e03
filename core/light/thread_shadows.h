#pragma once
// Tests many directions from one point on a thread against the other threads at once, since the threads nearby are the
// same for all of them; rays one by one would fetch them again for each.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/thread_scene.h"

namespace weftlight::light {

using cloth::ThreadScene;

/// Unit vectors, all above the cloth or all below it, identified by number, in groups that are tested at once. Stored
/// by component for vectorisation.
struct Directions {
  static constexpr size_t kGroup = 8, kMostGroups = 48;
  std::vector<float> x, y, z;
  std::vector<float> slant;  // distance in the plane for a height of 1
  std::vector<uint16_t> number;
  // By group: bounds of where its directions are at a height of 1, and of slant.
  std::vector<float> least_x, most_x, least_y, most_y, least_slant, most_slant;

  /// Those of one group, one after the other, should be close to each other.
  void add(const glm::vec3& w, size_t number);
  /// Later ones begin a group of their own.
  void finish_group();
  size_t groups() const { return least_x.size(); }
  bool down() const { return z.front() < 0; }
};

/// A subset of them: a bit for each of a group.
using OpenDirections = std::array<uint8_t, Directions::kMostGroups>;

/// Calls on(k) for each direction k of a subset.
template <class On>
void for_each_open(const Directions& all, const OpenDirections& open, const On& on) {
  for (size_t g = 0; g < all.groups(); ++g) {
    for (size_t i = 0; open[g] >> i; ++i)
      if (open[g] >> i & 1) on(g * Directions::kGroup + i);
  }
}

class ThreadShadows {
 public:
  explicit ThreadShadows(ThreadScene& scene);
  /// Removes directions that are occluded by a thread other than `thread` of the system; only_it: by just that thread.
  void cast(const Directions& all, OpenDirections& open, const glm::vec3& from, int system, int thread,
            bool only_it = false);

 private:
  using ThreadGrid = ThreadScene::ThreadGrid;
  struct Around;
  struct Rays;
  void cast_layer(Rays& rays, const ThreadGrid& grid, Around& around);
  void cast_span(Rays& rays, const ThreadGrid& grid, const Around& around, int system, int across, int along);

  ThreadScene& scene_;  // its formulas are not const
  std::vector<ThreadGrid> layers_;
};

}  // namespace weftlight::light
