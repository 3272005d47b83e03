// presets/cloths against what real cloths send back (tests/measured/README.md): half an octave, root mean square of
// log2(ours / measured) where the measured is above 3 percent of its peak. The satin's table turns light and eye
// round with another answer than before, which no cloth of ours does: by how much, the table itself tells, and so much
// is allowed on top.

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "../figures.h"
#include "files/files.h"
#include "scratch_folder.h"

namespace weftlight::commands {
namespace {

constexpr double kHalfAnOctave = 0.5, kSeen = 0.03;
struct MeasuredCloth {
  const char* table;
  const char* name;
  bool shape_alone;             // one column, whose height does not count
  bool answers_change = false;  // when light and eye change places
};
constexpr MeasuredCloth kCloths[] = {{"sadeghi2013.csv", "linen_plain", false},
                                     {"sadeghi2013.csv", "silk_crepe_de_chine", false},
                                     {"sadeghi2013.csv", "polyester_satin_charmeuse", false, true},
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

using Rows = std::vector<std::vector<double>>;

double peak_of(const Rows& measured) {
  double peak = 0;
  for (const auto& row : measured)
    for (size_t c = 2; c < row.size(); ++c) peak = std::max(peak, row[c]);
  return peak;
}

/// In octaves, by the view's angle: what each view's rows lack for light and eye to change places without a
/// difference (radiance for a unit of irradiance across the beam is the BRDF times the light's cosine). Least squares
/// over all pairs that the table has; their mean over the rows that count is 0, since the height is not at fault.
std::map<double, double> lacking_by_view(const Rows& measured) {
  struct Pair {
    double view, other, octaves;
  };
  const double least = kSeen * peak_of(measured);
  const auto cosine = [](double degrees) { return std::cos(degrees * std::numbers::pi / 180); };
  std::vector<Pair> pairs;
  std::map<double, double> lacking, counts;
  for (size_t i = 0; i < measured.size(); ++i) {
    const auto& a = measured[i];
    lacking[a[0]] = 0;
    for (size_t c = 2; c < a.size(); ++c) counts[a[0]] += a[c] > least ? 1 : 0;
    for (size_t k = 0; k < measured.size(); ++k) {
      const auto& b = measured[k];
      // Of the same plane, as it stands or turned by half: the tables' halves are warp and weft.
      const bool same_plane = i / (measured.size() / 2) == k / (measured.size() / 2);
      const bool turned = (b[0] == a[1] && b[1] == a[0]) || (b[0] == -a[1] && b[1] == -a[0]);
      if (!same_plane || !turned || std::abs(a[0]) == std::abs(a[1])) continue;
      for (size_t c = 2; c < a.size(); ++c)
        if (std::min(a[c], b[c]) > least)
          pairs.push_back({a[0], b[0], std::log2(a[c] / cosine(a[1])) - std::log2(b[c] / cosine(b[1]))});
    }
  }
  for (int step = 0; step < 200; ++step) {
    for (auto& [view, octaves] : lacking) {
      double sum = 0, count = 0;
      for (const Pair& p : pairs)
        if (p.view == view) sum += lacking[p.other] - p.octaves, ++count;
      if (count > 0) octaves = sum / count;
    }
  }
  double sum = 0, count = 0;
  for (const auto& [view, octaves] : lacking) sum += octaves * counts[view], count += counts[view];
  for (auto& [view, octaves] : lacking) octaves -= sum / count;
  return lacking;
}

/// Root mean square of it over the rows that count: a cloth that obeys reciprocity is at least so far off.
double own_break(const Rows& measured, const std::map<double, double>& lacking) {
  double squares = 0, count = 0;
  for (const auto& row : measured)
    for (size_t c = 2; c < row.size(); ++c)
      if (row[c] > kSeen * peak_of(measured)) squares += lacking.at(row[0]) * lacking.at(row[0]), ++count;
  return std::sqrt(squares / count);
}

/// In octaves. Rows of both: angles of view and light, radiances. `lacking`: added to what was measured, by view.
double octaves_off(const Rows& measured, const Rows& ours, bool shape_alone,
                   const std::map<double, double>& lacking = {}) {
  const double least = kSeen * peak_of(measured);
  double sum = 0, squares = 0, count = 0;
  for (size_t i = 0; i < measured.size(); ++i) {
    for (size_t c = 2; c < measured[i].size(); ++c) {
      if (measured[i][c] <= least) continue;
      const double value = shape_alone ? (ours[i][2] + ours[i][3] + ours[i][4]) / 3 : ours[i][c];
      const double lacks = lacking.empty() ? 0 : lacking.at(measured[i][0]);
      const double off = std::log2(std::max(value, 1e-6) / measured[i][c]) - lacks;
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
      const std::map<double, double> lacking = lacking_by_view(measured);
      const double broken = own_break(measured, lacking);
      const double most = cloth.answers_change ? std::hypot(kHalfAnOctave, broken) : kHalfAnOctave;
      const double off = octaves_off(measured, ours, cloth.shape_alone);
      figure(method + " of " + cloth.name + ", octaves off", most, off);
      figure("of them made reciprocal", most, octaves_off(measured, ours, cloth.shape_alone, lacking));
      figure("the table's own break of reciprocity", most, broken);
      EXPECT_LT(off, most) << cloth.name;
    }
  }
};

TEST_F(Measured, far_field_of_cloths_is_as_measured) { compare("cloth"); }

TEST_F(Measured, cloths_are_sent_back_as_measured_by_the_traced_threads) { compare("reference"); }

}  // namespace
}  // namespace weftlight::commands
