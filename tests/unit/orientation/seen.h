#pragma once
// One small design whose every crossing can be told from where it is shown, and what a picture of it must show.
//
// The rule of the house (core/README.md): a face is shown with end 1 at the right and pick 1 at the top, front and back
// alike, so that a thread is at the same place in both; the back has the crossings turned. Text, and grids for a weaver
// who likes another corner, begin there. Only from behind a cloth that hangs is it seen turned over: end 1 at the left.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "design/edits.h"
#include "files/files.h"

namespace weftlight::orientation {

using design::Design, design::Twist;
using draft::BitMatrix, draft::Draft, draft::Face, draft::ShedControl, draft::Threads, draft::blank_draft,
    draft::drawdown;
using files::Image;

inline constexpr int kEnds = 7, kPicks = 6;
inline constexpr int kLoneEnd = 1, kLonePick = 4;        // of the one crossing where that end is up: end 2, pick 5
inline constexpr int kColoredEnd = 3, kColoredPick = 2;  // end 4 and pick 3

/// All weft, dark as the warp, but for a lone red crossing, a green end that is up twice and a blue pick. Threads are a
/// millimetre apart.
inline Design marked_design() {
  Design design;
  Draft& d = design.draft;
  d = blank_draft(kEnds, kPicks, kEnds, kEnds);
  d.shed_control = ShedControl::kLiftplan;
  d.palette = {{0.08f, 0.08f, 0.08f}, {0.9f, 0.1f, 0.1f}, {0.1f, 0.8f, 0.1f}, {0.15f, 0.2f, 0.95f}};
  for (int e = 0; e < kEnds; ++e) d.threading.set(e, e, true);
  for (Threads* threads : {&d.warp, &d.weft}) {
    threads->color.assign(threads->color.size(), 0);
    threads->spacing_mm.assign(threads->color.size(), 1.0f);
    threads->thickness_mm.assign(threads->color.size(), 0.9f);
  }
  d.warp.color[kLoneEnd] = 1, d.warp.color[kColoredEnd] = 2, d.weft.color[kColoredPick] = 3;
  d.liftplan.set(kLonePick, kLoneEnd, true);
  d.liftplan.set(1, kColoredEnd, true), d.liftplan.set(5, kColoredEnd, true);
  design.yarns[0].twist = Twist::kNone;
  design.plan.warp_shrinkage = design.plan.weft_shrinkage = 0;  // no relief beside that of the crossings
  design.scene.mesh = "plane";
  return design;
}

inline bool warp_on_top(int end, int pick, Face face) {
  static const BitMatrix cells = drawdown(marked_design().draft);
  return cells.get(pick, end) == (face == Face::kFront);
}

/// What the pixels of a picture are.
enum class Shows {
  kColors,   // of the threads
  kPoints,   // black where the warp is on top, else white
  kThreads,  // number of the thread, and 1 for a weft, as 16 bits
  kFibres,   // which way the fibres run
  kNormals,  // green up
  kNormalsDown,
  kHeights
};

/// A picture, and the pixels where one repeat stands in it.
struct Seen {
  std::string name;
  Image image;
  double x = 0, y = 0, width = 0, height = 0;
  Face face = Face::kFront;
  bool end1_left = false, pick1_bottom = false;
  Shows shows = Shows::kColors;

  /// A picture of one repeat.
  static Seen whole(std::string name, Image image, Face face = Face::kFront, Shows shows = Shows::kColors) {
    Seen s{std::move(name), std::move(image)};
    s.width = s.image.width, s.height = s.image.height, s.face = face, s.shows = shows;
    return s;
  }
  Seen from(bool left, bool bottom) && {
    end1_left = left, pick1_bottom = bottom;
    return std::move(*this);
  }

  /// A channel near a place within a crossing: 0..1 from its left and its top.
  double at(int end, int pick, int channel, double across = 0.5, double down = 0.5) const {
    const int column = end1_left ? end : kEnds - 1 - end, row = pick1_bottom ? kPicks - 1 - pick : pick;
    const double left = x + width * (column + across) / kEnds, top = y + height * (row + down) / kPicks;
    const int reach = std::clamp(static_cast<int>(width / kEnds / 8), 0, 3);
    double sum = 0;
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) {
        const int px = std::clamp(static_cast<int>(left) + i, 0, image.width - 1);
        const int py = std::clamp(static_cast<int>(top) + j, 0, image.height - 1);
        const size_t texel = static_cast<size_t>(py) * static_cast<size_t>(image.width) + static_cast<size_t>(px);
        sum += static_cast<double>(image.texels[texel * static_cast<size_t>(image.channels) +
                                                static_cast<size_t>(std::min(channel, image.channels - 1))]);
      }
    return sum / ((2 * reach + 1) * (2 * reach + 1));
  }
};

/// The face as letters, a line a pick, end 1 first: r, g, b; w is white, a dot dark.
inline std::string letters(const Seen& s) {
  std::string out;
  for (int pick = 0; pick < kPicks; ++pick, out += '\n')
    for (int end = 0; end < kEnds; ++end) {
      const double r = s.at(end, pick, 0), g = s.at(end, pick, 1), b = s.at(end, pick, 2);
      const double most = std::max({r, g, b}), least = std::min({r, g, b}), middle = r + g + b - most - least;
      const bool grey = most - middle < 0.12 * most + 0.04;
      out += grey ? (least > 0.7 ? 'w' : '.') : most == r ? 'r' : most == g ? 'g' : 'b';
    }
  return out;
}

inline std::string wanted_letters(Face face, Shows shows) {
  static const Draft d = marked_design().draft;
  std::string out;
  for (int pick = 0; pick < kPicks; ++pick, out += '\n')
    for (int end = 0; end < kEnds; ++end) {
      const bool warp = warp_on_top(end, pick, face);
      const int color = warp ? d.warp.color[static_cast<size_t>(end)] : d.weft.color[static_cast<size_t>(pick)];
      out += shows == Shows::kPoints ? (warp ? '.' : 'w') : ".rgb"[color];
    }
  return out;
}

inline void expect_threads(const Seen& s) {
  for (int pick = 0; pick < kPicks; ++pick)
    for (int end = 0; end < kEnds; ++end) {
      const bool warp = warp_on_top(end, pick, s.face);
      EXPECT_NEAR(s.at(end, pick, 0) * 65535, warp ? end : pick, 0.5) << "end " << end + 1 << ", pick " << pick + 1;
      EXPECT_EQ(s.at(end, pick, 2) * 65535 > 0.5, !warp) << "end " << end + 1 << ", pick " << pick + 1;
    }
}

inline void expect_fibres(const Seen& s) {
  for (int pick = 0; pick < kPicks; ++pick)
    for (int end = 0; end < kEnds; ++end) {
      const auto along = [&](int channel) { return std::abs(2 * s.at(end, pick, channel) - 1); };
      EXPECT_EQ(along(1) > along(0), warp_on_top(end, pick, s.face)) << "end " << end + 1 << ", pick " << pick + 1;
    }
}

/// Threads are round: the flank that lies at the right looks to the right, whichever way the image is stored.
inline void expect_normals(const Seen& s) {
  const auto slope = [&](int end, int pick, int channel) {
    return channel == 0 ? s.at(end, pick, 0, 0.8) - s.at(end, pick, 0, 0.2)
                        : s.at(end, pick, 1, 0.5, 0.2) - s.at(end, pick, 1, 0.5, 0.8);
  };
  const bool warp = warp_on_top(kLoneEnd, kLonePick, s.face);
  const double up = s.shows == Shows::kNormals ? 1 : -1;
  const double lone = warp ? slope(kLoneEnd, kLonePick, 0) : up * slope(kLoneEnd, kLonePick, 1);
  const double other = warp ? up * slope(6, 3, 1) : slope(6, 3, 0);
  EXPECT_GT(lone, 0.05);
  EXPECT_GT(other, 0.05);
}

/// The lone crossing is not as high as the same place is in the rest of the cloth, and its mirror images are.
inline void expect_heights(const Seen& s) {
  const auto above = [&](int end, int pick) { return std::abs(s.at(end, pick, 0) - s.at(6, 3, 0)); };
  const int end = kEnds - 1 - kLoneEnd, pick = kPicks - 1 - kLonePick;
  EXPECT_GT(above(kLoneEnd, kLonePick), std::max({above(end, kLonePick), above(kLoneEnd, pick), above(end, pick)}));
}

inline void expect_seen(const Seen& s) {
  const testing::ScopedTrace trace(__FILE__, __LINE__, s.name);
  ASSERT_FALSE(s.image.texels.empty());
  switch (s.shows) {
    case Shows::kColors:
    case Shows::kPoints:
      EXPECT_EQ(letters(s), wanted_letters(s.face, s.shows));
      break;
    case Shows::kThreads:
      expect_threads(s);
      break;
    case Shows::kFibres:
      expect_fibres(s);
      break;
    case Shows::kNormals:
    case Shows::kNormalsDown:
      expect_normals(s);
      break;
    case Shows::kHeights:
      expect_heights(s);
      break;
  }
}

}  // namespace weftlight::orientation
