// The records of the threads: packing, unpacking, and what they tell; and heights of crossings from the drawdown alone.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

#include "base/resources.h"
#include "cloth/thickness.h"
#include "light/yarn_lobes.h"
#include "packed_threads.h"
#include "wif/wif.h"

namespace weftlight::gl {

using cloth::thread_section, cloth::thread_texture;
using draft::CellRect;
using light::yarn_data;
using render_data::ThreadKind, render_data::thread_kind;

namespace {

/// Equal bit for bit, including NaN.
template <class T>
std::array<std::byte, sizeof(T)> bytes_of(const T& value) {
  return std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
}

TEST(ComputedCrossings, AreThoseThatAreStored) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 3}, {3, 1}, {22, 22}, {23, 45}, {64, 9}, {131, 70}}) {
    const Cloth cloth = unordered(size.x, size.y);
    const PackedCloth p = in_strips(cloth);
    PackedThreads threads(p, 1);
    const std::vector<vec4> stored = thread_crossings(cloth, {0, size.x, 0, size.y});
    float most = 0;
    for (int pick = 0; pick < size.y; ++pick) {
      for (int end = 0; end < size.x; ++end) {
        const vec4 off = threads.crossing_at(end, pick) - stored[static_cast<size_t>(pick * size.x + end)];
        for (int i = 0; i < 4; ++i) most = std::max(most, std::abs(off[i]));
      }
    }
    // Sections are rounded where they are packed.
    EXPECT_LT(most, 2e-4f) << size.x << " x " << size.y;
  }
}

TEST(ComputedCrossings, LieBelowABoundForAnyWeave) {
  const Design d = twill(4, 2, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  const Cloth even = lay_out(d, drawdown(d.draft), Face::kFront, Period::kWholeDraft);
  for (const Cloth& cloth : {even, uneven_twill(), unordered(131, 70)}) {
    const CellRect all{0, cloth.up.cols(), 0, cloth.up.rows()};
    const float own = highest_thread(cloth, thread_crossings(cloth, all)), bound = highest_thread(cloth);
    EXPECT_GE(bound, own);
    EXPECT_LE(bound, 2 * own);
    std::printf("  bound %g of %g mm\n", static_cast<double>(bound), static_cast<double>(own));
  }
}

TEST(ComputedCrossings, FollowPaintedCells) {
  Cloth cloth = unordered(131, 70);
  std::vector<uint32_t> strips = render_data::cell_strips(cloth.up);
  for (int p = 60; p < 70; ++p)
    for (int e = 120; e < 131; ++e) cloth.up.set(p, e, (p + e) % 3 == 0);
  for (const render_data::StripPatch& patch : render_data::cell_strips(cloth.up, {120, 131, 60, 70}))
    std::ranges::copy(patch.strips, strips.begin() + static_cast<std::ptrdiff_t>(patch.first));
  EXPECT_EQ(strips, render_data::cell_strips(cloth.up));
}

TEST(ThreadRecords, ComeBackAsTheyWentIn) {
  const Cloth cloth = uneven_twill();
  const PackedCloth p = packed(cloth);
  const PackedThreads back(p, 1);
  for (const System system : {System::kWarp, System::kWeft}) {
    const auto& threads = system == System::kWarp ? cloth.ends : cloth.picks;
    const float length = system == System::kWarp ? cloth.depth_mm : cloth.width_mm;
    const int s = system == System::kWarp ? 0 : 1;
    for (int i = 0; i < static_cast<int>(threads.size()); ++i) {
      const ThreadBody& body = threads[static_cast<size_t>(i)];
      const auto section = back.thread_body(s, i);
      const auto in_section = thread_section(body, length);
      EXPECT_EQ(vec2(section.centre, section.half_room), vec2(in_section.centre, in_section.half_room));
      // Offsets of borders are bytes.
      const float step = section.half_room / 127;
      EXPECT_NEAR(section.half_width, in_section.half_width, step);
      EXPECT_NEAR(section.half_height / section.half_width, body.height_mm / body.width_mm, 2e-4f);
      EXPECT_EQ(section.squareness, body.squareness);
      for (int k = 0; k < 2; ++k) {
        EXPECT_NEAR(section.aside[k], in_section.aside[k], 0.51f * step);
        EXPECT_NEAR(section.sway[k], in_section.sway[k], 0.26f * step);
      }
      EXPECT_EQ(back.look(s, i), vec4(body.colour.r, body.colour.g, body.colour.b, body.yarn));
      cloth::ThreadRecord in{}, out{};
      in.pattern = thread_texture(cloth.yarns[static_cast<size_t>(body.yarn)], body, system, i, length);
      out.pattern = back.pattern(s, i);
      EXPECT_EQ(bytes_of(in), bytes_of(out)) << "thread " << i << " of system " << s;
    }
  }
  // Parameters of a yarn, all different, so that a mix-up shows.
  interop::YarnData in{};
  std::array<float, sizeof in / sizeof(float)> numbers;
  for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i) + 0.5f;
  std::memcpy(&in, numbers.data(), sizeof in);
  std::array<glm::uvec4, YARN_TEXELS> texels;
  std::memcpy(texels.data(), &in, sizeof in);
  const interop::YarnData out = cloth::thread_formulas::record_yarn(texels[0], texels[1], texels[2], texels[3]);
  EXPECT_EQ(bytes_of(in), bytes_of(out));
  const interop::YarnData second = yarn_data(cloth.yarns[1].lobes), fetched = back.yarn(1);
  EXPECT_EQ(bytes_of(second), bytes_of(fetched));
}

TEST(ThreadRecords, TellOfWhatKindTheThreadsAre) {
  const Design d = twill(4, 2, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  const ThreadKind even =
      thread_kind(packed(lay_out(d, drawdown(d.draft), Face::kFront, Period::kWholeDraft)).lobes.threads);
  EXPECT_TRUE(even.even && even.one_layer && even.smooth);
  const ThreadKind uneven = thread_kind(packed(uneven_twill()).lobes.threads);
  EXPECT_TRUE(!uneven.even && uneven.one_layer && !uneven.smooth);
  EXPECT_FALSE(thread_kind(packed(pockets()).lobes.threads).one_layer);
  EXPECT_FALSE(thread_kind({}).even || thread_kind({}).smooth || thread_kind({}).closed);
}

TEST(ThreadRecords, TellWhetherThreadsTouchEverywhere) {
  const auto shipped = [](const char* name) {
    const wif::WifRead read = wif::read_wif(base::read_file(base::presets_dir() + name).value_or(""));
    if (!read.file) return ThreadKind{};
    const Design& d = read.file->design;
    return thread_kind(packed(lay_out(d, drawdown(d.draft), Face::kFront, Period::kWholeDraft)).lobes.threads);
  };
  EXPECT_TRUE(shipped("/cloths/denim.wif").closed && shipped("/cloths/tweed.wif").closed);
  EXPECT_FALSE(shipped("/cloths/organza.wif").closed || shipped("/cloths/linen.wif").closed);
  EXPECT_FALSE(shipped("/drafts/huck_lace.wif").closed) << "washed threads leave holes";
}

}  // namespace
}  // namespace weftlight::gl
