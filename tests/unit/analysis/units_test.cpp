// Measures as texts in both systems of units, and as they are typed.

#include "analysis/units.h"

#include <gtest/gtest.h>

namespace weftlight::analysis {
namespace {

TEST(Units, MeasuresInBoth) {
  EXPECT_EQ(width_text(508, Units::kMetric), "50.8 cm");
  EXPECT_EQ(width_text(508, Units::kImperial), "20.0 in");
  EXPECT_EQ(short_length_text(19, Units::kMetric), "19 mm");
  EXPECT_EQ(short_length_text(19.05, Units::kImperial), "0.75 in");
  EXPECT_EQ(warp_length_text(3 * 914.4, Units::kMetric), "2.74 m");
  EXPECT_EQ(warp_length_text(3 * 914.4, Units::kImperial), "3.00 yd");
  EXPECT_EQ(yarn_length_text(1000 * 0.9144, Units::kImperial), "1000 yd");
  EXPECT_EQ(yarn_length_text(6400, Units::kMetric), "6.4 km");
  EXPECT_EQ(weight_text(453.59237, Units::kImperial), "1.00 lb");
  EXPECT_EQ(weight_text(28.349523125, Units::kImperial), "1.00 oz");
  EXPECT_EQ(weight_text(1200, Units::kMetric), "1.20 kg");
  EXPECT_EQ(weight_text(0.3, Units::kMetric), "under 1 g") << "what is bought is not nothing";
  EXPECT_EQ(weight_text(0.1, Units::kImperial), "under 0.01 oz");
  EXPECT_EQ(weight_text(0, Units::kMetric), "0 g");
  EXPECT_EQ(yarn_length_text(0.4, Units::kMetric), "under 1 m");
  EXPECT_EQ(yarn_length_text(0.4, Units::kImperial), "under 1 yd");
  EXPECT_EQ(sett_text(10, System::kWarp, Units::kMetric), "10.0 ends per cm");
  EXPECT_EQ(sett_text(10, System::kWeft, Units::kImperial), "25.4 picks per inch");
  EXPECT_EQ(area_weight_text(33.9057, Units::kImperial), "1.0 oz/yd\xC2\xB2");
  EXPECT_EQ(area_weight_text(214, Units::kMetric), "214 g/m\xC2\xB2");
  EXPECT_EQ(reed_text({40, false}), "40/10");
  EXPECT_EQ(reed_text({12, true}), "12 dents per inch");
}

TEST(Units, TypedLengths) {
  EXPECT_EQ(length_mm_from_text("500"), 500);
  EXPECT_EQ(length_mm_from_text("2.5 m"), 2500);
  EXPECT_EQ(length_mm_from_text("50cm"), 500);
  EXPECT_NEAR(*length_mm_from_text("20in"), 508, 1e-9);
  EXPECT_NEAR(*length_mm_from_text("20\""), 508, 1e-9);
  EXPECT_NEAR(*length_mm_from_text("3 yd"), 2743.2, 1e-9);
  for (const char* wrong : {"", "cm", "-5", "5 miles", "nan", "1e999", "5 5"})
    EXPECT_FALSE(length_mm_from_text(wrong)) << wrong;
}

TEST(Units, TypedReeds) {
  EXPECT_EQ(reed_from_text("40/10"), Reed({40, false}));
  EXPECT_EQ(reed_from_text("12/in"), Reed({12, true}));
  EXPECT_EQ(reed_from_text("12/inch"), Reed({12, true}));
  EXPECT_EQ(reed_from_text("12.5 dpi"), Reed({12.5f, true}));
  for (const char* wrong : {"", "40", "0/10", "-4/10", "40/11", "9999/10", "nan/10"})
    EXPECT_FALSE(reed_from_text(wrong)) << wrong;
}

}  // namespace
}  // namespace weftlight::analysis
