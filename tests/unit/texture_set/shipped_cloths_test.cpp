// The shipped cloths as engines show them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/files.h"
#include "paths.h"
#include "texture_set/texture_set.h"
#include "wif/wif.h"

namespace weftlight::texture_set {

using base::read_file;
using design::Design;
using draft::Face;
using light::EngineScore;
using wif::WifRead, wif::read_wif;

namespace {

namespace fs = std::filesystem;

Design shipped(const fs::path& path) {
  const WifRead read = read_wif(read_file(path.string()).value_or(""));
  if (!read.file) throw std::runtime_error(path.string() + ": no draft");
  return read.file->design;
}

std::vector<fs::path> shipped_cloths() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(WEFTLIGHT_SOURCE_DIR "/presets/cloths"))
    if (entry.path().extension() == ".wif") out.push_back(entry.path());
  return out;
}

class ShippedCloths : public testing::TestWithParam<fs::path> {};
INSTANTIATE_TEST_SUITE_P(All, ShippedCloths, testing::ValuesIn(shipped_cloths()),
                         [](const auto& cloth) { return cloth.param.stem().string(); });

/// The largest miss of a view's mean in a plane, to 60 degrees. An engine's one lobe has not the shape of two systems
/// of threads: what cancels over all azimuths does not in one plane.
const std::map<std::string, float> kPlaneMisses = {{"chambray", 0.15f},
                                                   {"chintz", 0.32f},
                                                   {"cotton_denim", 0.12f},
                                                   {"cotton_twill", 0.14f},
                                                   {"damask", 0.09f},
                                                   {"denim", 0.24f},
                                                   {"flannel", 0.01f},
                                                   {"gabardine", 0.19f},
                                                   {"linen", 0.14f},
                                                   {"linen_plain", 0.06f},
                                                   {"organza", 0.23f},
                                                   {"ottoman", 0.27f},
                                                   {"oxford", 0.23f},
                                                   {"polyester_satin_charmeuse", 0.34f},
                                                   {"shot_taffeta", 0.23f},
                                                   {"silk_charmeuse", 0.28f},
                                                   {"silk_crepe_de_chine", 0.41f},
                                                   {"silk_satin", 0.17f},
                                                   {"tweed", 0.16f}};

TEST_P(ShippedCloths, AreNoFurtherOffInAPlaneThanKnown) {
  const FaceSource face = face_at(shipped(GetParam()), Face::kFront, TextureSetOptions{}, 64);
  float most = 0;
  for (const std::vector<EngineScore>& plane : face.plane_scores()) {
    ASSERT_EQ(plane.size(), 5u);
    for (const EngineScore& s : plane)
      if (s.view_deg < 65) most = std::max(most, std::abs(s.mean - 1));
  }
  EXPECT_LE(most, 1.1f * kPlaneMisses.at(GetParam().stem().string()) + 0.03f);
}

}  // namespace
}  // namespace weftlight::texture_set
