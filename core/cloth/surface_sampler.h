#pragma once
// Samples the surface of a cloth row by row: what is on top at each sample. Used by the maps and by their moments,
// which differ in how they average samples into texels.

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "cloth/centre_line.h"
#include "cloth/maps.h"
#include "cloth/thread_texture.h"

namespace weftlight::cloth {

using draft::System;

/// Sample grid of one period. A texel holds per_texel_x x per_texel_y samples, so that each thread gets about
/// `samples_a_thread` where the map has fewer texels.
struct SampleGrid {
  int width = 1, height = 1;  // of the maps, texels
  int per_texel_x = 1, per_texel_y = 1;
  int samples_x() const { return width * per_texel_x; }
  int samples_y() const { return height * per_texel_y; }
};
SampleGrid sample_grid(const Cloth& cloth, int width, int height, int samples_a_thread = 3);

/// For each thread the first sample that shows it, and for each crossing the first sample past it, in their order
/// across the threads of a system. Both have one more entry: the number of samples.
struct SampleAxis {
  int per_texel = 1;
  std::vector<int> thread_from, crossing_from;
};
SampleAxis sample_axis(const Cloth& cloth, System system, const SampleGrid& grid);

/// The surface of one system at a sample; cover is the fraction of the sample where it is on top.
struct SurfaceSample {
  float height_mm = 0, cover = 0, groove = 1;
  Linear colour;
  Slope slope;
  Direction tangent;
  uint32_t thread = 0;
  uint8_t system = 0;
};

/// Level of the bottom of gaps: the underside of the lowest thread in any weave.
float floor_mm(const Cloth& cloth);

/// Samples rows of a window of the grid, columns [x0, x1) and rows [y0, y1).
class SurfaceSampler {
 public:
  SurfaceSampler(const Cloth& cloth, const SampleGrid& grid, int x0, int x1, int y0, int y1);
  /// A second system that is visible in the same sample, at a border.
  struct Beside {
    int sample = 0;
    SurfaceSample shows;
  };
  /// Samples row y of the window: `out` (x1 - x0 entries) gets the system with more coverage, `beside` the other one
  /// where it is visible too. Rows in order are cheapest.
  void row(int y, std::span<SurfaceSample> out, std::vector<Beside>& beside);

 private:
  // Indices of threads go one beyond the period where an uneven one may reach over its edge.

  /// A sample across the threads of one system, and these as the draft spaces them: the first and the last within it,
  /// and the one in its middle.
  struct Slot {
    float from = 0, to = 0;
    int lowest = 0, highest = 0, middle = 0;
  };
  /// Position of a sample across the threads of one system.
  struct Across {
    int thread = 0;
    float cover = 0;          // fraction of the sample's width that threads cover
    float beyond_mm = 0;      // distance from the thread's edge, 0 inside
    float height_mm = 0;      // of the section above the centre line
    float u = 0, top = 0;     // place on the section, in half sizes
    int first = 0, last = 0;  // threads that may cover the sample
    // What only a visible thread needs (add_pattern).
    float slope = 0;  // -d height / d across, mean over the sample
    float turn = 0, ply_turn = 0, cycles = 0, ply_fade = 1;
    bool turns = false;  // the colour depends on the turns
  };
  /// State of a thread at a sample along it.
  struct Along {
    float at_mm = 0, centre_mm = 0, slope = 0, turn = 0, ply_turn = 0, stray_turn = 0;
    float lengthened = 1;  // height of the vertical cut over that of the section, where the thread climbs
    float bend = 0;        // change of the slope for 1 mm above the centre line
    float sideways = 0;    // d offset of the centre line / d s
    int node = 0;
    float blend = 0;
  };

  /// A thread at a sample, mm.
  struct Section {
    glm::vec2 half;  // width, height
    float place;     // of its centre, if it were even
    float aside;     // of its centre, from there
    glm::vec2 room;  // from that to the borders before and after the thread
    float squareness;
    float centre() const { return place + aside; }
  };
  /// Sections of the threads of a window at its crossings, computed once since every sample reads several.
  struct CrossingSizes {
    int first_thread = 0, first = 0, crossings = 0;
    std::vector<float> place, room_by_width, squareness;  // by thread
    std::vector<glm::vec3> over_size;  // 1 over half width and half height, and the offset, by thread, then by crossing
    std::vector<glm::vec2> more_room;  // on both sides, where threads are moved sideways; likewise
    /// section_at() of a thread of the window.
    Section at(int thread, const CentreStep& step) const {
      const int t = thread - first_thread;
      const size_t i = static_cast<size_t>(t * crossings + step.crossing - first);
      const auto between = [&](const auto& all) { return all[i] + (all[i + 1] - all[i]) * step.t; };
      const glm::vec3 size = between(over_size);
      const glm::vec2 half = 1.0f / glm::vec2(size);
      const size_t of = static_cast<size_t>(t);
      Section section{half, place[of], size.z, glm::vec2(half.x * room_by_width[of]), squareness[of]};
      if (!more_room.empty()) section.room += between(more_room);
      return section;
    }
    /// Change of the offset for 1 mm along; 0 for threads beyond the window.
    float sideways(int thread, const CentreStep& step) const {
      const int i = (thread - first_thread) * crossings + step.crossing - first;
      if (thread < first_thread || i + 1 >= static_cast<int>(over_size.size())) return 0;
      return (over_size[static_cast<size_t>(i + 1)].z - over_size[static_cast<size_t>(i)].z) / step.h1;
    }
  };

  /// The part of a sample that a thread covers.
  struct Part {
    float from = 0, to = 0;
    float width() const { return std::max(to - from, 0.0f); }
  };
  static Part covered_part(const Slot& slot, const Section& thread) {
    return {std::max(slot.from, thread.centre() - thread.half.x), std::min(slot.to, thread.centre() + thread.half.x)};
  }
  std::vector<Slot> slots(System system, int first, int last) const;
  std::vector<Across> across(System system) const;
  CrossingSizes crossing_sizes(System system) const;
  /// sections: of a thread at this sample.
  template <class Sections>
  void set_across(Across& a, System system, const Slot& slot, const Sections& sections) const;
  template <class Sections>
  void add_pattern(Across& a, System system, const Slot& slot, const Sections& sections) const;
  template <class Sections>
  int thread_under(System system, const Slot& slot, const Sections& sections) const;
  float centre_of(System system, int thread) const;
  Along along(System system, int thread, const CentreStep& step, float s_mm) const;
  void sample_row(int y, std::span<SurfaceSample> out, std::vector<Beside>& beside);
  const std::vector<Along>& along_pick(int pick);
  const std::vector<Section>& sections_of_pick(int pick);
  CentreStep pick_step(int pick, size_t column) const;
  SurfaceSample finish(System system, const Across& across, const Along& along, float cover) const;

  const Cloth& cloth_;
  SampleGrid grid_;
  int x0_, x1_, y0_, y1_;
  float dx_mm_, dy_mm_, floor_mm_;
  /// Textures of the threads in the window, from `first` on.
  struct Textures {
    struct Thread {
      ThreadTexture texture;
      Texel mean;                                    // where the pattern is too fine for the samples
      float cycles_along = 0, ply_cycles_along = 0;  // grooves and plies that a sample spans along the thread
      bool patterned = false;                        // false: too fine everywhere, without contrast
    };
    int first = 0;
    std::vector<Thread> of;
    const Thread& at(int thread) const { return of[static_cast<size_t>(thread - first)]; }
  };
  static Textures textures(const Cloth& cloth, System system, float from_mm, float to_mm, float step, float step_along);
  Textures warp_texture_, weft_texture_;
  bool uneven_[2];  // whether the system has threads of uneven thickness
  std::vector<Slot> column_slots_, row_slots_;
  std::vector<Across> columns_, rows_;  // of a system of even threads
  CrossingSizes warp_sizes_, weft_sizes_;
  std::vector<CentreStep> column_steps_;
  CentreLines lines_;
  int first_end_ = 0;
  std::vector<Along> warp_along_;       // of the current row, by end of the window, from first_end_ on
  std::vector<Section> warp_sections_;  // of the current row, by end of warp_sizes_
  /// The last used, by index modulo their number: as many as one row reads.
  template <class Value>
  struct Picks {
    struct Row {
      int pick = std::numeric_limits<int>::min();
      std::vector<Value> by_column;
    };
    std::vector<Row> rows;
    Row& at(int pick) { return rows[static_cast<size_t>(pick) & (rows.size() - 1)]; }
  };
  Picks<Along> pick_along_;
  Picks<Section> pick_sections_;
};

/// The same over all layers of a cloth: upper layers hide lower ones except through their gaps. `beside` may have
/// several entries a sample.
class LayeredSampler {
 public:
  using Beside = SurfaceSampler::Beside;
  /// layers: from layers_apart(); empty for a single layer.
  LayeredSampler(const Cloth& cloth, std::span<const Cloth> layers, const SampleGrid& grid, int x0, int x1, int y0,
                 int y1);
  void row(int y, std::span<SurfaceSample> out, std::vector<Beside>& beside);

 private:
  struct Shown {
    SurfaceSampler sampler;
    std::vector<SurfaceSample> out;
    std::vector<Beside> beside;
    size_t next = 0;  // next entry of beside
  };
  /// Visible surfaces of all layers at a sample, with their coverage.
  const std::vector<SurfaceSample>& stacked(size_t i);

  std::vector<Shown> layers_;
  std::vector<Shown*> order_;
  std::vector<SurfaceSample> stack_;
};

}  // namespace weftlight::cloth
