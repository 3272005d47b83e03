#pragma once
// Tests of significance: Pearson's chi-square of counts against a density, Z of two means, and what significance each
// of several tests has so that all of them together raise a false alarm with a stated probability. Seeds are fixed, so
// a test that passes once passes always; the probability is that of a new seed or a new order of the random numbers.
//
// Based on: Pearson 1900; Sidak 1967; Press et al. 2007, section 6.2 (incomplete gamma function); Subr and Arvo 2007,
//   "Statistical hypothesis testing for assessing Monte Carlo estimators".

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace weftlight {

/// The probability with which a sound sampler fails the tests of one `Verdict`.
inline constexpr double kFalseAlarm = 0.01;

/// Upper tail of the incomplete gamma function, Q(a, x): a series below a + 1, a continued fraction above.
inline double gamma_tail(double a, double x) {
  if (!(x > 0)) return 1;
  const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > 1e-16 * sum; ++n) sum += term *= x / n;
    return 1 - sum * scale;
  }
  constexpr double kTiny = 1e-300;
  double b = x + 1 - a, c = 1 / kTiny, d = 1 / b, h = d;
  for (int i = 1; i < 10000; ++i) {
    const double an = -i * (i - a);
    b += 2;
    d = an * d + b, c = b + an / c;
    d = 1 / (std::abs(d) < kTiny ? kTiny : d), c = std::abs(c) < kTiny ? kTiny : c;
    h *= d * c;
    if (std::abs(d * c - 1) < 1e-15) break;
  }
  return h * scale;
}

/// Probability that counts of this distribution differ from the expected ones at least as much. The cells with the
/// fewest expected are merged until none expects fewer than 5. 0 if something is counted where nothing can be.
inline double chi_square(const std::vector<double>& counted, std::vector<double> expected) {
  const double all = std::accumulate(counted.begin(), counted.end(), 0.0),
               whole = std::accumulate(expected.begin(), expected.end(), 0.0);
  for (double& e : expected) e *= all / whole;
  std::vector<size_t> order(counted.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return expected[a] < expected[b]; });
  double sum = 0, merged_counted = 0, merged_expected = 0;
  int cells = 0;
  for (const size_t i : order) {
    if (expected[i] <= 0 && counted[i] > 0) return 0;
    merged_counted += counted[i], merged_expected += expected[i];
    if (merged_expected < 5) continue;
    sum += (merged_counted - merged_expected) * (merged_counted - merged_expected) / merged_expected;
    merged_counted = merged_expected = 0;
    ++cells;
  }
  // What is left of the few has fewer than 5 expected only if that is all there is.
  return cells < 2 ? std::numeric_limits<double>::quiet_NaN() : gamma_tail(0.5 * (cells - 1), 0.5 * sum);
}

/// Two-sided probability of a difference of so many standard deviations.
inline double z_tail(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

/// Significance of each of n independent tests, so that one of them fails by chance with probability `of_all`.
inline double sidak(size_t n, double of_all = kFalseAlarm) {
  return -std::expm1(std::log1p(-of_all) / static_cast<double>(n));
}

/// The least of several probabilities against what chance alone would give.
class Verdict {
 public:
  void add(double probability) { all_.push_back(probability); }
  bool holds() const {
    const double least = sidak(all_.size());
    return !all_.empty() && std::all_of(all_.begin(), all_.end(), [&](double p) { return p >= least; });
  }
  double least() const { return *std::min_element(all_.begin(), all_.end()); }
  double needed() const { return sidak(all_.size()); }

 private:
  std::vector<double> all_;
};

}  // namespace weftlight
