// The cloth as it is laid out for every other picture (cloth/cloth.h), threads, gaps and layers, seen head on.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "base/loops.h"
#include "cloth/layers.h"
#include "cloth/thickness.h"
#include "print/sheets.h"

namespace weftlight::print {

using base::for_each_job;
using cloth::Cloth, cloth::Linear, cloth::Period, cloth::ThreadBody, cloth::lay_out, cloth::layer_count,
    cloth::srgb_from_linear;
using design::Design;
using draft::BitMatrix, draft::Face, draft::Rgb, draft::System;

namespace {

constexpr uint32_t kPaper = 0xffffff;
constexpr double kEdge = 1.0001;  // of a thread, in half widths: threads that touch leave no gap by their last bits

/// The thread whose room holds a point, and how far the point is from its middle, in half widths: beyond 1 in the gap.
struct Place {
  int thread = 0;
  double off = 0;
};

/// Of the threads `first` and on, side by side from 0 to the period.
Place place_of(const std::vector<ThreadBody>& all, int first, int count, double mm) {
  const std::span threads = std::span(all).subspan(static_cast<size_t>(first), static_cast<size_t>(count));
  const auto edge = [](const ThreadBody& t) { return static_cast<double>(t.centre_mm + 0.5f * t.spacing_mm); };
  const auto at = std::ranges::upper_bound(threads, mm, {}, edge);
  const auto i = std::min(static_cast<int>(at - threads.begin()), count - 1);
  const ThreadBody& t = threads[static_cast<size_t>(i)];
  const double half = 0.5 * static_cast<double>(t.width_mm);
  return {first + i, half > 0 ? (mm - static_cast<double>(t.centre_mm)) / half : std::numeric_limits<double>::max()};
}

/// Millimetres from the corner of end 1 or pick 1, within the period, of each pixel; `reversed`: the last is next to
/// it.
std::vector<double> distances(int count, double pixels_per_mm, bool reversed, double period_mm) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i)
    out.push_back(std::fmod(((reversed ? count - 1 - i : i) + 0.5) / pixels_per_mm, period_mm));
  return out;
}

uint32_t shaded(const Rgb& c, double off) {
  const double shade = 0.5 + 0.5 * std::sqrt(std::max(0.0, 1 - off * off * 0.96));
  const auto byte = [shade](float channel) {
    return static_cast<uint32_t>(std::clamp(static_cast<double>(channel) * shade, 0.0, 1.0) * 255 + 0.5);
  };
  return byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
}

/// A cloth and what of each of its layers lies at the pixels.
class Swatch {
 public:
  Swatch(const Cloth& cloth, const std::vector<double>& across_mm, const std::vector<double>& down_mm)
      : cloth_(cloth), across_mm_(across_mm), down_mm_(down_mm) {
    for (const ThreadBody& t : cloth.ends) end_color_.push_back(srgb_from_linear(t.colour));
    for (const ThreadBody& t : cloth.picks) pick_color_.push_back(srgb_from_linear(t.colour));
    for (const std::vector<Linear>& dye : cloth.dyes)
      std::ranges::transform(dye, std::back_inserter(dye_color_.emplace_back()), srgb_from_linear);
    for (int i = 0; i < layer_count(cloth); ++i) {
      const auto l = cloth.layers.empty() ? cloth::ClothLayer{0, cloth.up.cols(), 0, cloth.up.rows()}
                                          : cloth.layers[static_cast<size_t>(i)];
      Places& places = layers_.emplace_back();
      for (const double mm : across_mm) places.across.push_back(place_of(cloth.ends, l.first_end, l.ends, mm));
      for (const double mm : down_mm) places.down.push_back(place_of(cloth.picks, l.first_pick, l.picks, mm));
    }
  }

  /// The highest thread's colour; paper where there is none.
  uint32_t pixel(size_t x, size_t y) const {
    float highest = std::numeric_limits<float>::lowest();
    uint32_t color = kPaper;
    for (const Places& layer : layers_) {
      Place end = layer.across[x], pick = layer.down[y];
      if (!cloth_.warp_aside_mm.empty()) {
        end = moved(System::kWarp, layer.across[x], across_mm_[x], down_mm_[y]);
        pick = moved(System::kWeft, layer.down[y], down_mm_[y], across_mm_[x]);
      }
      const auto e = static_cast<size_t>(end.thread), p = static_cast<size_t>(pick.thread);
      const size_t crossing = p * static_cast<size_t>(cloth_.up.cols()) + e;
      const auto level = [&](const std::vector<float>& mm) { return mm.empty() ? 0.0f : mm[crossing]; };
      const float apart = 0.25f * (cloth_.ends[e].height_mm + cloth_.picks[p].height_mm);
      const float up = cloth_.up.get(pick.thread, end.thread) ? apart : -apart;
      const auto take = [&](const Place& at, float height, const Rgb& c) {
        if (std::abs(at.off) <= kEdge && height > highest) highest = height, color = shaded(c, at.off);
      };
      const ThreadBody &warp = cloth_.ends[e], &weft = cloth_.picks[p];
      take(end, level(cloth_.warp_level_mm) + up, color_at(warp, end_color_[e], weft.place));
      take(pick, level(cloth_.weft_level_mm) - up, color_at(weft, pick_color_[p], warp.place));
    }
    return color;
  }

 private:
  struct Places {
    std::vector<Place> across, down;
  };
  /// The nearest thread to a point where washing has moved some of them sideways; one of those beside the even place.
  Place moved(System system, const Place& even, double across_mm, double along_mm) const {
    const std::vector<ThreadBody>& threads = system == System::kWarp ? cloth_.ends : cloth_.picks;
    const float period = system == System::kWarp ? cloth_.width_mm : cloth_.depth_mm;
    const int count = static_cast<int>(threads.size());
    Place nearest{even.thread, std::numeric_limits<double>::max()};
    for (int t = even.thread - 1; t <= even.thread + 1; ++t) {
      const int turn = t < 0 ? -1 : t >= count ? 1 : 0, thread = t - turn * count;
      const ThreadBody& body = threads[static_cast<size_t>(thread)];
      const auto step = cloth::centre_step(cloth_, system, thread, static_cast<float>(along_mm));
      const float centre =
          body.centre_mm + static_cast<float>(turn) * period + cloth::section_at(cloth_, system, thread, step).z;
      const double off =
          (across_mm - static_cast<double>(centre)) / std::max(0.5 * static_cast<double>(body.width_mm), 1e-9);
      if (std::abs(off) < std::abs(nearest.off)) nearest = {thread, off};
    }
    return nearest;
  }
  /// own: where the thread has one colour.
  const Rgb& color_at(const ThreadBody& thread, const Rgb& own, int place) const {
    return thread.dye < 0 ? own : at_place(dye_color_[static_cast<size_t>(thread.dye)], thread, place);
  }

  const Cloth& cloth_;
  const std::vector<double>&across_mm_, &down_mm_;
  std::vector<Rgb> end_color_, pick_color_;
  std::vector<std::vector<Rgb>> dye_color_;
  std::vector<Places> layers_;
};

}  // namespace

std::vector<uint32_t> swatch_pixels(const Design& design, const BitMatrix& cells, const PrintOptions& options,
                                    int width, int height, double pixels_per_mm) {
  std::vector<uint32_t> out(static_cast<size_t>(width) * static_cast<size_t>(height), kPaper);
  const Cloth cloth = lay_out(design, cells, Face::kFront, Period::kWholeDraft);
  if (!(cloth.width_mm > 0) || !(cloth.depth_mm > 0)) return out;
  const std::vector<double> across_mm =
      distances(width, pixels_per_mm, options.end1_right, static_cast<double>(cloth.width_mm));
  const std::vector<double> down_mm =
      distances(height, pixels_per_mm, options.pick1_bottom, static_cast<double>(cloth.depth_mm));
  const Swatch swatch(cloth, across_mm, down_mm);
  for_each_job(height, [&](int y) {
    for (size_t x = 0; x < static_cast<size_t>(width); ++x)
      out[static_cast<size_t>(y) * static_cast<size_t>(width) + x] = swatch.pixel(x, static_cast<size_t>(y));
  });
  return out;
}

}  // namespace weftlight::print
