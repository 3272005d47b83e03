#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "../program.h"
#include "files/files.h"

namespace weftlight::files {

using base::problem_of;

namespace {

// RMS over all channels, 0..1. Another CPU or driver changes the last bit of many pixels and a few edge pixels; a
// wrong shadow or a shifted thread is far above.
constexpr double kRmsTolerance = 0.012;

struct Golden {
  const char* name;
  const char* draft;
  const char* options;
  const char* mesh = "plane";
  // Largest RMS of a tile: a wrong patch is lost in the RMS of the whole. At edges, where fibres stand off, drivers
  // differ in single pixels (an NVIDIA card from llvmpipe by up to 0.052 of a tile, RMS 0.0071).
  double worst_tile = 0.02;
};

constexpr Golden kGoldens[] = {
    {"starter_yarn", "starter", "--method yarn"},
    {"starter_back", "starter", "--method yarn --face back --view -30,35"},
    {"houndstooth_flat", "houndstooth", "--method flat"},
    {"twill_vrst03", "twill_2_2", "--method vrst03 --yarns-per-pixel 0.1"},
    {"satin_threads", "satin_8", "--method yarn --yarns-per-pixel 0.05", "plane", 0.05},
    {"gauze_gaps", "gauze", "--method yarn --yarns-per-pixel 0.08", "plane", 0.03},
    {"starter_auto", "starter", "--method auto --yarns-per-pixel 1.5 --view 20,40", "plane", 0.05},
    {"overshot_repeat", "overshot", "--method repeat --yarns-per-pixel 1"},
    {"damask_cell", "twill_damask", "--method cell --yarns-per-pixel 1"},
    {"denim_cloth", "denim", "--method cloth --view 0,25"},
    {"satin_engine", "satin_8", "--method engine --yarns-per-pixel 0.3"},
    {"twill_irawan", "twill_2_2", "--method irawan --yarns-per-pixel 0.1", "plane", 0.07},
    {"ikat_threads", "ikat", "--method yarn --yarns-per-pixel 0.15 --view 0,60", "plane", 0.05},
    {"deflected_threads", "deflected_double_weave", "--method yarn --yarns-per-pixel 0.15 --view 0,0", "plane", 0.05},
    {"starter_draped", "starter", "--method auto", "tablecloth", 0.05},
};

void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.name; }

class GoldenTest : public testing::TestWithParam<Golden> {};

int run_render(const Golden& golden, const std::string& out) {
  const std::string command = tested_program() + " render " WEFTLIGHT_DRAFTS "/" + golden.draft +
                              ".wif --exposure 0 -o '" + out + "' --mesh " + golden.mesh + " --size 256x256 " +
                              golden.options;
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

constexpr int kTile = 16;  // pixels

/// The largest RMS of a tile.
double worst_tile(const Image& reference, const Image& result) {
  const size_t width = static_cast<size_t>(result.width), channels = static_cast<size_t>(result.channels);
  double worst = 0;
  for (int top = 0; top + kTile <= result.height; top += kTile)
    for (int left = 0; left + kTile <= result.width; left += kTile) {
      double sum = 0;
      for (int y = top; y < top + kTile; ++y)
        for (size_t i = 0; i < kTile * channels; ++i) {
          const size_t at = (static_cast<size_t>(y) * width + static_cast<size_t>(left)) * channels + i;
          const double d = static_cast<double>(result.texels[at] - reference.texels[at]);
          sum += d * d;
        }
      worst = std::max(worst, std::sqrt(sum / (kTile * kTile * static_cast<double>(channels))));
    }
  return worst;
}

double compare(const Image& reference, const Image& result, Image& difference) {
  double sum = 0;
  difference = result;
  for (size_t i = 0; i < result.texels.size(); ++i) {
    const float d = result.texels[i] - reference.texels[i];
    sum += static_cast<double>(d) * static_cast<double>(d);
    difference.texels[i] = std::min(1.0f, std::abs(d) * 8);  // so that small errors are seen
  }
  return std::sqrt(sum / static_cast<double>(result.texels.size()));
}

TEST_P(GoldenTest, IsAsItWas) {
  const Golden& golden = GetParam();
  const std::string results = WEFTLIGHT_GOLDEN_RESULTS "/" + std::string(golden.name);
  const std::string stored = WEFTLIGHT_GOLDENS "/" + std::string(golden.name) + ".png";
  const int code = run_render(golden, results + "_result.png");
  if (code == 4) GTEST_SKIP() << "no graphics on this machine";
  ASSERT_EQ(code, 0);
  if (std::getenv("WEFTLIGHT_UPDATE_GOLDENS")) {
    std::filesystem::copy_file(results + "_result.png", stored, std::filesystem::copy_options::overwrite_existing);
    GTEST_SKIP() << "written anew: " << stored;
  }
  const base::Result<Image> reference = read_image(stored), result = read_image(results + "_result.png");
  ASSERT_TRUE(reference) << problem_of(reference);
  ASSERT_TRUE(result) << problem_of(result);
  ASSERT_EQ(reference->texels.size(), result->texels.size());
  Image difference;
  const double rms = compare(*reference, *result, difference);
  const double tile = worst_tile(*reference, *result);
  std::printf("  RMS %.4f, worst tile %.4f\n", rms, tile);
  if (rms > kRmsTolerance || tile > golden.worst_tile) {
    write_image(results + "_reference.png", *reference, PixelType::kU8);
    write_image(results + "_difference.png", difference, PixelType::kU8);
  }
  EXPECT_LE(rms, kRmsTolerance) << "see " << results << "_{reference,result,difference}.png";
  EXPECT_LE(tile, golden.worst_tile) << "a part of the picture differs: see " << results
                                     << "_{reference,result,difference}.png";
}

INSTANTIATE_TEST_SUITE_P(Pictures, GoldenTest, testing::ValuesIn(kGoldens),
                         [](const testing::TestParamInfo<Golden>& golden) { return std::string(golden.param.name); });

}  // namespace
}  // namespace weftlight::files
