// The pattern of threads (shaders/thread_texture.glsl): what the sampler of the maps leaves out where it does not show.

#include "cloth/thread_texture.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "design/yarn_presets.h"

namespace weftlight::cloth {
namespace {

using design::yarn_presets;
using thread_formulas::shows_turn;

ThreadTexture texture_of(const Yarn& yarn) {
  const ThreadBody body{0, 1.2f * yarn.diameter_mm, yarn.diameter_mm, yarn.flattening * yarn.diameter_mm, {}, 0};
  return thread_texture(yarn, body, System::kWeft, 5, 20);
}

std::vector<Yarn> spun_of_everything() {
  std::vector<Yarn> yarns(yarn_presets().begin(), yarn_presets().end());
  for (const int plies : {1, 2, 5}) {
    for (const float melange : {0.0f, 1.0f}) {
      Yarn odd;
      odd.plies = plies, odd.melange = melange, odd.hairiness = 1, odd.groove_depth = 1;
      yarns.push_back(odd);
    }
  }
  return yarns;
}

TEST(ThreadTexture, ATurnThatDoesNotShowChangesNoBitOfTheTexel) {
  std::mt19937 rng(11);
  std::uniform_real_distribution<float> u(0, 1);
  int hidden = 0, shown = 0;
  for (const Yarn& yarn : spun_of_everything()) {
    const ThreadTexture x = texture_of(yarn);
    for (int i = 0; i < 2000; ++i) {
      const float cycles = 5 * u(rng) * u(rng);
      TexturePoint p{100 * u(rng), 5 * u(rng), 40 * u(rng), static_cast<int>(u(rng) * static_cast<float>(x.nodes - 1)),
                     u(rng),       cycles,     u(rng)};
      if (shows_turn(x, cycles)) {
        ++shown;
        continue;
      }
      ++hidden;
      const Texel here = texture_at(x, p), mean = texture_at(x, {0, 0, 0, 0, 0, 1e6f, 0});
      EXPECT_EQ(here.groove, mean.groove);
      EXPECT_EQ(here.tone, mean.tone);
      EXPECT_EQ(here.ply, mean.ply);
      EXPECT_EQ(here.hue, mean.hue);
    }
  }
  EXPECT_GT(hidden, 1000);
  EXPECT_GT(shown, 1000);
}

}  // namespace
}  // namespace weftlight::cloth
