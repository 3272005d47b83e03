// How far the shipped cloths cover what is behind them: the baked maps against Peirce's cover factor of their yarns and
// setts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "analysis/loom_sett.h"
#include "base/whole_files.h"
#include "cloth/maps.h"
#include "cloth/thickness.h"
#include "design/yarn_presets.h"
#include "paths.h"
#include "weaves/table.h"
#include "weaves/weaves.h"
#include "wif/wif.h"

namespace weftlight::wif {

using base::read_file;
using cloth::Cloth, cloth::Maps, cloth::MapsSize, cloth::Period;
using design::Design, design::Finish, design::Yarn;
using draft::Face, draft::System, draft::Threads, draft::drawdown;

namespace {

constexpr int kTexels = 12;   // across a thread
constexpr int kWindow = 512;  // texels a side

Design shipped(const std::string& path) {
  const auto file = std::filesystem::path(WEFTLIGHT_TESTS_DIR).parent_path() / "presets" / (path + ".wif");
  return read_wif(read_file(file.string()).value_or("")).file.value().design;
}

/// Fraction of its spacing that an even thread of this yarn is wide: a section of the yarn's flattening where it
/// touches its neighbours (F. T. Peirce 1937; A. Kemp 1958 for flattened threads), rounder in an open sett.
double fraction_covered(const Yarn& yarn, double diameter_mm, double spacing_mm, const Finish& finish) {
  const double flattening = static_cast<double>(yarn.flattening), calendered = static_cast<double>(finish.calendered);
  const double tightness = std::min(1.0, 1.06 * diameter_mm / spacing_mm);
  const double woven = std::min(1.0, diameter_mm / std::sqrt(1 - (1 - flattening) * tightness) / spacing_mm);
  const double pressed = std::max(woven, std::min(1.0, diameter_mm / std::sqrt(flattening) / spacing_mm));
  const double flat = woven + (pressed - woven) * calendered;
  return flat + (1 - flat) * static_cast<double>(finish.raised);
}

/// Mean of a system.
double fraction_covered(const Design& design, System system) {
  const Threads& threads = design.draft.threads(system);
  const std::vector<Yarn> yarns = finished(design.yarns, design.finish);
  double covered = 0, room = 0;
  for (int i = 0; i < threads.size(); ++i) {
    const cloth::ThreadSize size = cloth::thread_size(design, system, i);
    const auto k =
        static_cast<size_t>(i) < threads.yarn.size() ? static_cast<size_t>(threads.yarn[static_cast<size_t>(i)]) : 0;
    const double spacing = static_cast<double>(size.spacing_mm);
    covered += spacing * fraction_covered(yarns[k], static_cast<double>(size.thickness_mm), spacing, design.finish);
    room += spacing;
  }
  return covered / room;
}

/// Peirce's cover, K1 + K2 - K1 K2 / 28, with the cover of a cloth of touching threads as 1.
double peirce_cover(const Design& design) {
  const double warp = fraction_covered(design, System::kWarp), weft = fraction_covered(design, System::kWeft);
  return warp + weft - warp * weft;
}

/// Of a part of the cloth, as the maps have it.
double baked_cover(const Design& design) {
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kWholeDraft);
  const MapsSize whole{static_cast<int>(cloth.ends.size()) * kTexels, static_cast<int>(cloth.picks.size()) * kTexels,
                       0};
  const Maps maps = bake(cloth, whole, {0, 0, std::min(kWindow, whole.width), std::min(kWindow, whole.height)});
  double sum = 0;
  for (const float c : maps.coverage.at_) sum += static_cast<double>(c);
  return sum / static_cast<double>(maps.coverage.at_.size());
}

TEST(ShippedCloths, CoverAsPeirceHasIt) {
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(WEFTLIGHT_TESTS_DIR).parent_path() / "presets/cloths")) {
    const std::string name = entry.path().stem().string();
    const Design design = shipped("cloths/" + name);
    const double wanted = peirce_cover(design), ours = baked_cover(design);
    RecordProperty(name, std::to_string(wanted) + " " + std::to_string(ours));
    EXPECT_NEAR(ours, wanted, 0.01) << name;
  }
}

TEST(NewDrafts, OfCottonAtTheFirmSettAreClosed) {
  const weaves::WeaveKind* plain = weaves::find_weave("plain");
  ASSERT_TRUE(plain);
  Design design = weaves::new_draft(*plain, weaves::complete_values(*plain, {}), {16, 16}).design;
  design = weaves::with_ground_yarn(std::move(design), design::ready_yarn(design::Fibre::kCotton));
  const analysis::LoomSett sett = analysis::firm_sett(design, analysis::Units::kImperial);
  EXPECT_EQ(sett.ends, 28) << "half of the wraps of 8/2 cotton, as it is wound";
  EXPECT_GT(baked_cover(analysis::with_loom_sett(design, sett, analysis::Units::kImperial)), 0.95)
      << "washed, it has pinholes";
}

TEST(ShippedCloths, OpenClothStaysOpen) {
  EXPECT_LT(baked_cover(shipped("cloths/organza")), 0.5);
  EXPECT_LT(baked_cover(shipped("drafts/gauze")), 0.75);
  // Linen at half its sett.
  Design open = shipped("cloths/linen");
  for (const System s : {System::kWarp, System::kWeft})
    for (float& spacing : open.draft.threads(s).spacing_mm) spacing *= 2;
  EXPECT_NEAR(baked_cover(open), peirce_cover(open), 0.01);
  EXPECT_LT(baked_cover(open), 0.68);
}

}  // namespace
}  // namespace weftlight::wif
