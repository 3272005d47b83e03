// What is exported of threads whose colour has a channel at exactly 0: fitted as a dark colour is, for every model.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "texture_set/texture_set.h"
#include "weaves/weaves.h"

namespace weftlight::texture_set {

using design::Design;
using draft::Face, draft::Rgb;
using weaves::plain;

namespace {

Rgb of_255(int r, int g, int b) {
  return {static_cast<float>(r) / 255, static_cast<float>(g) / 255, static_cast<float>(b) / 255};
}

Design plain_in(const Rgb& warp, const Rgb& weft) {
  Design design = plain({4, 4});
  design.draft.palette = {warp, weft};
  std::fill(design.draft.warp.color.begin(), design.draft.warp.color.end(), 0);
  std::fill(design.draft.weft.color.begin(), design.draft.weft.color.end(), 1);
  return design;
}

FaceSource source_of(const Design& design, Face face, const ExportTarget* target) {
  TextureSetOptions options;
  options.target = target, options.size = 64;
  return face_at(design, face, options, 64);
}

/// make: a design by so many of 255. What the fitted material sends goes evenly to that of 0, and so do its factors:
/// the last step is no more than those from 8 on together, or than 1.2 hundredths.
template <class Make>
void expect_even(const Make& make, const std::string& what) {
  for (const ExportTarget* target : {&targets::kGltf, &targets::kUnreal}) {
    for (const Face face : {Face::kFront, Face::kBack}) {
      const FaceSource eight = source_of(make(8), face, target), one = source_of(make(1), face, target),
                       none = source_of(make(0), face, target);
      const std::string where = what + ", target " + target->id;
      for (size_t i = 0; i < none.checks().size(); ++i) {
        const glm::vec3 before = eight.checks()[i].engine, last = one.checks()[i].engine, now = none.checks()[i].engine;
        const float bright = std::max({before.r, before.g, before.b});
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(now[c], last[c], std::abs(before[c] - last[c]) + 0.012f * bright) << where << ", channel " << c;
      }
      EXPECT_NEAR(none.fit().f0.g, one.fit().f0.g, std::abs(eight.fit().f0.g - one.fit().f0.g) + 0.01f) << where;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(none.fit().base[c], one.fit().base[c], std::abs(eight.fit().base[c] - one.fit().base[c]) + 0.05f)
            << where << ", channel " << c;
    }
  }
}

TEST(TextureSetColours, GoEvenlyTo0WithAChannel) {
  const Rgb white = of_255(255, 255, 255);
  expect_even([&](int v) { return plain_in(of_255(v, v, v), white); }, "black and white");
  expect_even([](int v) { return plain_in(of_255(255, v, v), of_255(0x33, v, 255)); }, "red and violet");
}

}  // namespace
}  // namespace weftlight::texture_set
