// The figures of the sliders of yarns and finish.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include "design/finish.h"
#include "views/inspector/yarn_panel.h"

namespace weftlight::views {

using design::FieldFacts;

namespace {

std::string shown(const FieldFacts& field, double value) {
  char text[48];
  std::snprintf(text, sizeof text, figure_format(field).c_str(), value);
  return text;
}

TEST(YarnFigures, EndWithTheirUnit) {
  const auto check = [](const FieldFacts& field) {
    const std::string text = shown(field, static_cast<double>(field.to));
    const std::string unit = *field.unit ? std::string(" ").append(field.unit) : std::string();
    EXPECT_TRUE(text.ends_with(unit)) << field.label << ": " << text;
    EXPECT_NE(text.back(), ' ') << field.label;
  };
  for (const auto& field : design::kYarnFields) check(field.facts);
  for (const auto& field : design::kLobeFields) check(field.facts);
  for (const auto& field : design::kFinishFields) check(field.facts);
  const auto uneven = std::ranges::find(design::kYarnFields, std::string_view("unevenness"),
                                        [](const auto& field) { return std::string_view(field.facts.id); });
  ASSERT_NE(uneven, design::kYarnFields.end());
  EXPECT_EQ(shown(uneven->facts, 12), "12 %");
}

}  // namespace
}  // namespace weftlight::views
