// The shipped cloths as engines show them.

#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "paths.h"
#include "texture_set/texture_set.h"
#include "wif/wif.h"

namespace weftlight::texture_set {

using base::read_file;
using design::Design;
using draft::Face;
using wif::WifRead, wif::read_wif;

namespace {

namespace fs = std::filesystem;

Design shipped(const fs::path& path) {
  const WifRead read = read_wif(read_file(path.string()).bytes);
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

// Organza and tweed came out without any highlight, since that is nearly as good from afar.
TEST_P(ShippedCloths, KeepTheHighlightOfADielectric) {
  TextureSetOptions options;
  const FaceSource face = face_at(shipped(GetParam()), Face::kFront, options, 64);
  EXPECT_GE(face.fit().f0, 0.99f * formulas::kEngineF0);
  EXPECT_GE(face.fit().f90, face.fit().f0);
}

}  // namespace
}  // namespace weftlight::texture_set
