// Fibre, cross-section, lustre and hairiness: set from and computed back from a yarn's parameters.

#include "design/fibre.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../yarns.h"
#include "design/count.h"
#include "design/edits.h"
#include "design/history.h"
#include "design/written_count.h"

namespace weftlight::design {
namespace {

/// As read from a file that names neither fibre nor section.
Yarn unnamed(Yarn yarn) {
  yarn.fibre = Fibre::kViscose, yarn.section = CrossSection::kFlat;
  return with_recognised_fibre(std::move(yarn));
}

TEST(Fibre, EachReadyYarnIsOfItsOwnFibre) {
  const auto all = yarn_presets();
  ASSERT_EQ(all.size(), static_cast<size_t>(kFibres));
  for (int i = 0; i < kFibres; ++i) {
    const Yarn& yarn = all[static_cast<size_t>(i)];
    EXPECT_EQ(yarn.fibre, static_cast<Fibre>(i)) << yarn.name;
    EXPECT_EQ(&ready_yarn(yarn.fibre), &yarn);
    EXPECT_EQ(fibre_from_name(yarn.name), yarn.fibre);
    EXPECT_EQ(unnamed(yarn), yarn) << yarn.name;
    EXPECT_NEAR(lustre(yarn), 0.5f, 1e-4f) << yarn.name;
  }
  EXPECT_EQ(fibre_from_name("LINEN"), Fibre::kLinen);
  EXPECT_FALSE(fibre_from_name("nettle"));
  EXPECT_EQ(unnamed(Yarn{}), Yarn{}) << "cotton";
}

// Files from before the lobes of these followed from their fibres.
TEST(Fibre, EarlierReadyYarnsWithoutANameAreRecognised) {
  struct Earlier {
    const char* name;
    float along, across, layers, inner, body, transmission;
  };
  constexpr Earlier kEarlier[]{{"Silk", 0.087f, 0.89f, 4.5f, 0.09f, 0.9f, 0.14f},
                               {"Reeled silk", 0.076f, 0.72f, 4.3f, 0.09f, 0.9f, 0.14f},
                               {"Wool", 0.42f, 0.6f, 2, 0.1f, 1, 0.1f},
                               {"Woollen yarn", 0.55f, 0.7f, 1.9f, 0.1f, 1, 0.1f},
                               {"Viscose", 0.1f, 0.6f, 4, 0.1f, 0.9f, 0.2f},
                               {"Polyester filament", 0.06f, 0.69f, 8, 0.02f, 0.9f, 0.12f},
                               {"Spun polyester", 0.11f, 0.44f, 4.3f, 0.03f, 0.9f, 0.12f}};
  for (const Earlier& was : kEarlier) {
    Yarn yarn = yarn_preset(was.name);
    yarn.lobes.along_width = was.along, yarn.lobes.across_width = was.across, yarn.lobes.layers = was.layers;
    yarn.lobes.inner = was.inner, yarn.lobes.body = was.body, yarn.lobes.transmission = was.transmission;
    EXPECT_EQ(unnamed(yarn), yarn) << was.name;
  }
}

TEST(Fibre, AFinishedYarnWithoutANameIsRecognised) {
  Yarn tweed = yarn_preset("Wool");
  tweed.fibre_um = 45, tweed.groove_depth = 0.25f, tweed.hairiness = 1;
  tweed.lobes.fuzz = 0.6f, tweed.lobes.along_width = 0.7f, tweed.lobes.across_width = 0.8f;
  EXPECT_EQ(unnamed(tweed), tweed);
  Yarn gabardine = yarn_preset("Wool");
  gabardine.fibre_um = 24, gabardine.groove_depth = 0.3f, gabardine.hairiness = 0.12f;
  gabardine.lobes.fuzz = 0.08f, gabardine.lobes.along_width = 0.24f;
  EXPECT_EQ(unnamed(gabardine), gabardine);
  Yarn damask = yarn_preset("Linen");
  damask.fibre_um = 30, damask.groove_depth = 0.3f, damask.lobes.along_width = 0.13f, damask.lobes.layers = 7;
  EXPECT_EQ(unnamed(damask), damask);
}

TEST(Fibre, AnotherFibreKeepsThicknessAndTwist) {
  Yarn yarn = yarn_preset("Cotton");
  yarn.name = "Mine", yarn.diameter_mm = 0.7f, yarn.turns_per_m = 123, yarn.irregularity = 0.1f;
  for (const Yarn& ready : yarn_presets()) {
    const Yarn chosen = with_fibre(yarn, ready.fibre);
    EXPECT_EQ(chosen.fibre, ready.fibre);
    EXPECT_EQ(chosen.section, ready.section);
    EXPECT_EQ(chosen.lobes, ready.lobes);
    EXPECT_EQ(chosen.name, "Mine");
    EXPECT_EQ(chosen.diameter_mm, 0.7f);
    EXPECT_EQ(chosen.turns_per_m, 123);
    EXPECT_EQ(chosen.irregularity, 0.1f);
  }
}

TEST(Fibre, ACrossSectionIsRecognisedAndReversible) {
  for (const Yarn& ready : yarn_presets()) {
    const CrossSection own = ready.section;
    EXPECT_EQ(with_cross_section(ready, own), ready) << ready.name;
    for (size_t s = 0; s < kCrossSectionNames.size(); ++s) {
      const CrossSection section = static_cast<CrossSection>(s);
      const Yarn yarn = with_cross_section(ready, section);
      EXPECT_EQ(yarn, clamped(yarn)) << ready.name;
      EXPECT_EQ(yarn.section, section) << ready.name;
      EXPECT_EQ(section_from_name(kCrossSectionNames[s]), section);
      EXPECT_EQ(unnamed(yarn), yarn) << ready.name << " " << kCrossSectionNames[s];
      EXPECT_NEAR(lustre(yarn), 0.5f, 1e-3f) << ready.name << ": usual lustre of the fibre";
      const Yarn back = with_cross_section(yarn, own);
      EXPECT_NEAR(back.lobes.across_width, ready.lobes.across_width, 1e-5f);
      EXPECT_NEAR(back.lobes.layers, ready.lobes.layers, 1e-4f);
      EXPECT_EQ(back.lobes.inner_depth, ready.lobes.inner_depth);
      EXPECT_EQ(unnamed(with_lustre(yarn, 0.9f)), with_lustre(yarn, 0.9f)) << ready.name;
      EXPECT_EQ(back.diameter_mm, ready.diameter_mm);
    }
  }
}

TEST(Fibre, FlatSidesNarrowTheHighlightAndBeansWidenIt) {
  const Yarn& round = yarn_preset("Polyester filament");
  const Yarn trilobal = with_cross_section(round, CrossSection::kTrilobal),
             bean = with_cross_section(round, CrossSection::kBean),
             film = with_cross_section(round, CrossSection::kFlat);
  EXPECT_GT(trilobal.lobes.layers, round.lobes.layers);
  EXPECT_LT(trilobal.lobes.transmission, round.lobes.transmission);
  EXPECT_GT(bean.lobes.along_width, round.lobes.along_width);
  EXPECT_LT(film.lobes.across_width, trilobal.lobes.across_width);
  // The shorter the path through a fibre, the paler its light.
  EXPECT_LT(film.lobes.inner_depth, bean.lobes.inner_depth);
  EXPECT_LT(bean.lobes.inner_depth, trilobal.lobes.inner_depth);
  EXPECT_LT(trilobal.lobes.inner_depth, 1);
}

TEST(Fibre, SlidersReadBackTheirValues) {
  for (const Yarn& ready : yarn_presets()) {
    float width = 100;
    for (const float bright : {0.0f, 0.2f, 0.5f, 0.8f, 1.0f}) {
      const Yarn yarn = with_lustre(ready, bright);
      EXPECT_EQ(yarn, clamped(yarn)) << ready.name;
      EXPECT_LT(yarn.lobes.along_width, width) << ready.name << ": brighter is narrower";
      width = yarn.lobes.along_width;
      EXPECT_NEAR(lustre(yarn), bright, 1e-3f) << ready.name;
      EXPECT_EQ(unnamed(yarn), yarn) << ready.name << " " << bright;
    }
    for (const float flyaways : {0.0f, 0.3f, 1.0f}) {
      const Yarn yarn = with_hairiness(ready, flyaways);
      EXPECT_EQ(yarn.hairiness, flyaways);
      EXPECT_EQ(yarn, clamped(yarn));
    }
  }
}

TEST(Fibre, ACountFollowsTheThicknessUntilItIsSet) {
  Yarn yarn = yarn_preset("Cotton");
  yarn.tex = 0, yarn.diameter_mm = 0.45f;
  const float fine = tex_of(yarn);
  EXPECT_NEAR(fine, 145, 1);  // 250 pi x 1.52 x 0.6 x 0.45^2
  yarn.diameter_mm = 0.9f;
  EXPECT_NEAR(tex_of(yarn), 4 * fine, 0.01f);
  EXPECT_NEAR(packing_fraction(yarn), 0.6, 1e-6);
  Yarn set = *with_count(yarn, "Ne 8/2");
  EXPECT_NEAR(set.tex, 147.6f, 0.1f);
  EXPECT_NEAR(set.diameter_mm, 0.9f * std::sqrt(147.6f / (4 * fine)), 0.001f) << "thinner in proportion to the weight";
  set.diameter_mm = 0.7f;
  EXPECT_NEAR(tex_of(set), 147.6f, 0.1f) << "loftier, of the same weight";
  EXPECT_LT(packing_fraction(set), 0.3);
  EXPECT_NEAR(tex_of(set, 1.4f), 4 * tex_of(set), 0.01f) << "a thicker thread of the same yarn";
  EXPECT_NEAR(tex_of(with_thickness(set, 1.4f)), 4 * tex_of(set), 0.01f);
  EXPECT_NEAR(with_count(set, "Ne 4/2")->diameter_mm, 0.7f * std::sqrt(2.0f), 0.001f) << "keeps its packing";
  const Yarn unset = *with_count(set, "  ");
  EXPECT_EQ(unset.tex, 0);
  EXPECT_EQ(unset.diameter_mm, 0.7f);
}

TEST(Fibre, OpticalSlidersKeepTheCount) {
  for (const bool is_set : {true, false})
    for (Yarn yarn : yarn_presets()) {
      if (!is_set) yarn.tex = 0;
      const float tex = tex_of(yarn);
      for (const float share : {0.0f, 0.5f, 1.0f}) {
        EXPECT_EQ(tex_of(with_hairiness(yarn, share)), tex) << yarn.name << " hairy " << share;
        EXPECT_EQ(tex_of(with_lustre(yarn, share)), tex) << yarn.name << " bright " << share;
      }
      for (size_t s = 0; s < kCrossSectionNames.size(); ++s)
        EXPECT_EQ(tex_of(with_cross_section(yarn, static_cast<CrossSection>(s))), tex) << yarn.name;
      if (is_set) {
        EXPECT_EQ(tex_of(with_fibre(yarn, Fibre::kLinen)), tex) << yarn.name << ": another fibre, the same weight";
      }
    }
}

TEST(Fibre, UndoRevertsCountAndThickness) {
  Design design;
  design.yarns = {yarn_preset("Wool")};
  History history(design);
  history.commit(with_yarn(history.now(), 0, *with_count(history.now().yarns[0], "Nm 5.6")), "Yarn: Count");
  EXPECT_NEAR(history.now().yarns[0].tex, 178.6f, 0.1f);
  history.undo();
  EXPECT_EQ(history.now(), design);
  history.redo();
  EXPECT_NEAR(tex_of(history.now().yarns[0]), 178.6f, 0.1f);
}

TEST(Fibre, ACountStaysAsItWasWritten) {
  const Yarn yarn = *with_count(yarn_preset("Silk"), "Ne 16/4");
  EXPECT_EQ(written_count(yarn), "Ne 16/4");
  EXPECT_EQ(yarn.plies, 4) << "as it says";
  EXPECT_EQ(with_count(yarn, "30 tex")->plies, 4) << "it does not say";
  EXPECT_EQ(with_count(yarn, "Nm 30")->plies, 1);
  EXPECT_EQ(written_count(with_hairiness(with_lustre(with_fibre(yarn, Fibre::kCotton), 0.8f), 0.5f)), "Ne 16/4");
  EXPECT_EQ(written_count(yarn_preset("Cotton")), "Ne 8/2") << "as the ready yarns are sold";
  EXPECT_EQ(written_count(yarn_preset("Wool")), "Nm 28/2");
}

TEST(Fibre, ACountThatFollowsFromTheThicknessIsInTheUnitOfTheTrade) {
  const std::pair<const char*, const char*> units[] = {{"Cotton", "Ne "},         {"Linen", " lea"},
                                                       {"Wool", "Nm "},           {"Silk", "Nm "},
                                                       {"Viscose", " den"},       {"Polyester filament", " den"},
                                                       {"Spun polyester", "Ne "}, {"Reeled silk", " den"}};
  for (const auto& [name, unit] : units) {
    Yarn yarn = *with_count(yarn_preset(name), "");
    for (const float mm : {0.16f, 0.5f, 1.37f}) {
      yarn.diameter_mm = mm;
      EXPECT_NE(written_count(yarn).find(unit), std::string::npos) << name << ": " << written_count(yarn);
    }
  }
}

TEST(Fibre, CountsOfThePresets) {
  const std::pair<const char*, const char*> counts[] = {{"Cotton", "Ne 8/2"},
                                                        {"Mercerised cotton", "Ne 10/2"},
                                                        {"Linen", "16/2 lea"},
                                                        {"Silk", "Nm 30/2"},
                                                        {"Wool", "Nm 28/2"},
                                                        {"Viscose", "300 den"},
                                                        {"Polyester filament", "150 den"},
                                                        {"Combed cotton", "Ne 20/2"},
                                                        {"Reeled silk", "Nm 47"},
                                                        {"Woollen yarn", "Nm 8/2"},
                                                        {"Spun polyester", "Ne 30/2"}};
  for (const auto& [name, count] : counts) {
    const Yarn& ready = yarn_preset(name);
    const std::optional<Yarn> spun = with_count(ready, count);
    ASSERT_TRUE(spun) << name;
    EXPECT_NEAR(spun->diameter_mm / ready.diameter_mm, 1, 0.04f) << name;
    const double tex = tex_from_text(count).value_or(0);
    EXPECT_NEAR(static_cast<double>(tex_of(*spun)) / tex, 1, 1e-3) << name;
    EXPECT_NEAR(static_cast<double>(ready.tex) / tex, 1, 3e-3) << name;
    EXPECT_NEAR(packing_fraction(ready), name == std::string("Woollen yarn") ? 0.4 : 0.55, 0.12) << name;
  }
  EXPECT_FALSE(with_count(yarn_preset("Cotton"), "thick"));
  EXPECT_EQ(with_count(yarn_preset("Cotton"), "Ne 8/2")->lobes, yarn_preset("Cotton").lobes);
}

}  // namespace
}  // namespace weftlight::design
