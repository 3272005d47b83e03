// presets/cloths against what real cloths send back (tests/measured/README.md): half an octave, root mean square of
// log2(ours / measured) where the measured is above 3 percent of its peak.

#include <cmath>
#include <fstream>
#include <sstream>

#include "../figures.h"
#include "files/files.h"
#include "scratch_folder.h"

namespace weftlight::commands {
namespace {

constexpr double kHalfAnOctave = 0.5, kSeen = 0.03;
// The satin's table turns light and eye round with a factor of two between 0 and 60 degrees, where one cloth sends both
// the same (radiance times the eye's cosine), and its floats lie at four slopes alone: docs/measured.md.
constexpr double kUnlikeAnyCloth = 0.75;

struct MeasuredCloth {
  const char* table;
  const char* name;
  bool shape_alone;  // one column, whose height does not count
  double most = kHalfAnOctave;
};
constexpr MeasuredCloth kCloths[] = {{"sadeghi2013.csv", "linen_plain", false},
                                     {"sadeghi2013.csv", "silk_crepe_de_chine", false},
                                     {"sadeghi2013.csv", "polyester_satin_charmeuse", false, kUnlikeAnyCloth},
                                     {"denim2012.csv", "cotton_denim", false},
                                     {"irawan2012.csv", "silk_charmeuse", true},
                                     {"irawan2012.csv", "cotton_twill", true}};

/// Numbers of each row after `skip` fields; of the rows that begin with `with`.
std::vector<std::vector<double>> rows_of(const std::string& path, const std::string& with, int skip) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    if (!line.starts_with(with)) continue;
    std::istringstream fields(line);
    std::vector<double> row;
    for (int k = 0; std::getline(fields, line, ','); ++k)
      if (k >= skip) row.push_back(std::stod(line));
    rows.push_back(row);
  }
  return rows;
}

/// In octaves. Rows of both: angles of view and light, radiances.
double octaves_off(const std::vector<std::vector<double>>& measured, const std::vector<std::vector<double>>& ours,
                   bool shape_alone) {
  double peak = 0, sum = 0, squares = 0, count = 0;
  for (const auto& row : measured)
    for (size_t c = 2; c < row.size(); ++c) peak = std::max(peak, row[c]);
  for (size_t i = 0; i < measured.size(); ++i) {
    for (size_t c = 2; c < measured[i].size(); ++c) {
      if (measured[i][c] <= kSeen * peak) continue;
      const double value = shape_alone ? (ours[i][2] + ours[i][3] + ours[i][4]) / 3 : ours[i][c];
      const double off = std::log2(std::max(value, 1e-6) / measured[i][c]);
      sum += off, squares += off * off, ++count;
    }
  }
  const double mean = shape_alone ? sum / count : 0;
  return std::sqrt(squares / count - mean * mean);
}

class Measured : public ScratchFolder {
 protected:
  void compare(const std::string& method) {
    for (const MeasuredCloth& cloth : kCloths) {
      const std::string preset = presets_dir() + "/cloths/" + cloth.name + ".wif";
      const Ran ran = run({"response", preset, "-o", path("out.csv"), "--method", method, "--spp", "8"});
      ASSERT_EQ(ran.code, kDone) << ran.said;
      const auto measured =
          rows_of(std::string(WEFTLIGHT_TESTS_DIR) + "/measured/" + cloth.table, std::string(cloth.name) + ",", 2);
      const auto ours = rows_of(path("out.csv"), "", 1);
      ASSERT_EQ(measured.size(), 198u) << cloth.name;
      ASSERT_EQ(ours.size(), measured.size());
      for (size_t i = 0; i < ours.size(); ++i)
        ASSERT_TRUE(ours[i][0] == measured[i][0] && ours[i][1] == measured[i][1]);
      const double off = octaves_off(measured, ours, cloth.shape_alone);
      figure(method + " of " + cloth.name + ", octaves off", cloth.most, off);
      EXPECT_LT(off, cloth.most) << cloth.name;
    }
  }
};

TEST_F(Measured, cloths_are_sent_back_as_measured_by_the_rung_for_afar) { compare("cloth"); }

TEST_F(Measured, cloths_are_sent_back_as_measured_by_the_traced_threads) { compare("reference"); }

}  // namespace
}  // namespace weftlight::commands
