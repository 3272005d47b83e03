// Based on: Debevec 2005, "A median cut algorithm for light probe sampling" (a picture as a few lights); Ramamoorthi,
//   Hanrahan 2001 (the rest as harmonics); Pharr, Jakob, Humphreys 2016, section 14.2.4 (texels by their light).
// Differs: a median cut makes lights of all the sky, which few lights then throw as hard shadows. Here only what stands
//   out becomes lights, each what is brighter than the mean within a disc; the rest stays soft. No light is lost.

#include "scene/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weftlight::scene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kReachCos = 0.9659f;   // 15 degrees: largest disc of a light
constexpr float kMinFraction = 0.04f;  // of all light; smaller sources stay in the rest
constexpr float kMinRadius = 0.0047f;  // the sun's
constexpr int kCoarse = 64;            // columns of the map in which lights are searched

float luminance(glm::vec3 c) { return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

struct Texel {
  glm::vec3 towards, radiance;
  float covers;  // steradians
};

/// Downsamples to at most `width` columns, by means over whole texels.
std::vector<Texel> texels_of(const Image& picture, int width) {
  const int w = std::min(picture.width, width), h = std::max(1, w / 2);
  std::vector<Texel> out(static_cast<size_t>(w) * static_cast<size_t>(h), {{}, {}, 0});
  const float around = 2 * kPi / static_cast<float>(picture.width), step = kPi / static_cast<float>(picture.height);
  const float* from = picture.texels.data();
  for (int y = 0; y < picture.height; ++y) {
    const float top = static_cast<float>(y) * step, covers = around * (std::cos(top) - std::cos(top + step));
    for (int x = 0; x < picture.width; ++x, from += 3) {
      Texel& to = out[static_cast<size_t>(y * h / picture.height * w + x * w / picture.width)];
      const float across = (static_cast<float>(x) + 0.5f) / static_cast<float>(picture.width);
      const float down = (static_cast<float>(y) + 0.5f) / static_cast<float>(picture.height);
      to.towards += environment_direction(across, down) * covers;
      to.radiance += glm::vec3(from[0], from[1], from[2]) * covers;
      to.covers += covers;
    }
  }
  for (Texel& t : out) t.radiance /= t.covers, t.towards = glm::normalize(t.towards);
  return out;
}

/// Light above `level` within a disc.
struct Excess {
  glm::vec3 light{0}, towards{0};
  float luminous = 0, spread = 0;  // spread: of the squared sine from the centre
};

glm::vec3 above(const Texel& t, glm::vec3 level) { return glm::max(t.radiance - level, glm::vec3(0)) * t.covers; }

Excess excess_about(const std::vector<Texel>& texels, glm::vec3 middle, glm::vec3 level) {
  Excess sum;
  for (const Texel& t : texels) {
    const float c = glm::dot(t.towards, middle);
    if (c < kReachCos) continue;
    const glm::vec3 light = above(t, level);
    const float y = luminance(light);
    sum.light += light, sum.luminous += y;
    sum.towards += t.towards * y;
    sum.spread += std::max(0.0f, 1 - c * c) * y;
  }
  return sum;
}

/// Centre of the disc with the most light above the level, found coarsely and then refined.
glm::vec3 brightest_disc(const std::vector<Texel>& coarse, const std::vector<Texel>& fine, glm::vec3 level) {
  glm::vec3 best(0, 1, 0);
  float most = 0;
  for (const Texel& t : coarse) {
    const float here = excess_about(coarse, t.towards, level).luminous;
    if (here > most) most = here, best = t.towards;
  }
  for (int k = 0; k < 4; ++k) {
    const Excess e = excess_about(fine, best, level);
    if (e.luminous > 0 && glm::length(e.towards) > 0) best = glm::normalize(e.towards);
  }
  return best;
}

void remove_light(std::vector<Texel>& texels, glm::vec3 middle, glm::vec3 level) {
  for (Texel& t : texels)
    if (glm::dot(t.towards, middle) >= kReachCos) t.radiance = glm::min(t.radiance, level);
}

Harmonics project(const std::vector<Texel>& texels) {
  Harmonics sum{};
  for (const Texel& t : texels) {
    const std::array<float, 9> basis = harmonics(t.towards);
    for (size_t k = 0; k < 9; ++k) sum[k] += t.radiance * (basis[k] * t.covers);
  }
  return sum;
}

/// Index of the first cumulative sum above u.
size_t pick(const float* sums, size_t count, float u) {
  return std::min(static_cast<size_t>(std::upper_bound(sums, sums + count, u) - sums), count - 1);
}

}  // namespace

std::array<float, 9> harmonics(glm::vec3 d) {
  return {0.282095f,
          0.488603f * d.y,
          0.488603f * d.z,
          0.488603f * d.x,
          1.092548f * d.x * d.y,
          1.092548f * d.y * d.z,
          0.315392f * (3 * d.z * d.z - 1),
          1.092548f * d.x * d.z,
          0.546274f * (d.x * d.x - d.y * d.y)};
}

glm::vec3 environment_direction(float across, float down) {
  const float a = 2 * kPi * (across - 0.5f), polar = kPi * down, s = std::sin(polar);
  return {std::sin(a) * s, std::cos(polar), -std::cos(a) * s};
}

Environment::Environment(Image picture) : picture_(std::move(picture)) {
  constexpr int kFine = 512;
  std::vector<Texel> fine = texels_of(picture_, kFine), coarse = texels_of(picture_, kCoarse);
  for (const Texel& t : fine) mean_ += t.radiance * (t.covers / (4 * kPi));
  const float whole = 4 * kPi * luminance(mean_);
  while (lights_.size() < kMaxLights) {
    const glm::vec3 middle = brightest_disc(coarse, fine, mean_);
    const Excess e = excess_about(fine, middle, mean_);
    if (!(e.luminous > kMinFraction * whole)) break;
    // The mean square of a uniform disc is half its squared radius.
    const float radius = std::sqrt(2 * e.spread / e.luminous);
    lights_.push_back({glm::normalize(e.towards), e.light, std::clamp(radius, kMinRadius, 0.26f)});
    remove_light(fine, middle, mean_), remove_light(coarse, middle, mean_);
  }
  std::sort(lights_.begin(), lights_.end(), [](const DistantLight& a, const DistantLight& b) {
    return luminance(a.irradiance) > luminance(b.irradiance);
  });
  rest_ = project(fine);

  const size_t w = static_cast<size_t>(picture_.width), h = static_cast<size_t>(picture_.height);
  rows_.resize(h), columns_.resize(w * h);
  double all = 0;
  for (size_t y = 0; y < h; ++y) {
    const float step = kPi / static_cast<float>(h), top = static_cast<float>(y) * step;
    double row = 0;
    for (size_t x = 0; x < w; ++x) {
      row += static_cast<double>(luminance(texel(y * w + x) - capped(texel(y * w + x))));
      columns_[y * w + x] = static_cast<float>(row);
    }
    for (size_t x = 0; x < w; ++x) columns_[y * w + x] /= static_cast<float>(std::max(row, 1e-30));
    all += row * static_cast<double>(std::cos(top) - std::cos(top + step));
    rows_[y] = static_cast<float>(all);
  }
  for (float& r : rows_) r /= static_cast<float>(std::max(all, 1e-30));
}

DistantLight Environment::sample(float u, float v) const {
  const size_t w = static_cast<size_t>(picture_.width), h = static_cast<size_t>(picture_.height);
  const size_t y = pick(rows_.data(), h, v), x = pick(&columns_[y * w], w, u);
  const auto chance = [](const float* sums, size_t at) { return sums[at] - (at > 0 ? sums[at - 1] : 0); };
  const float by = chance(rows_.data(), y) * chance(&columns_[y * w], x);
  const float step = kPi / static_cast<float>(h), top = static_cast<float>(y) * step;
  const float covers = (std::cos(top) - std::cos(top + step)) * 2 * kPi / static_cast<float>(w);
  const glm::vec3 bright = texel(y * w + x) - capped(texel(y * w + x));
  const glm::vec3 towards = environment_direction((static_cast<float>(x) + 0.5f) / static_cast<float>(w),
                                                  (static_cast<float>(y) + 0.5f) / static_cast<float>(h));
  return {towards, by > 0 ? bright * (covers / by) : glm::vec3(0), 0.5f * step};
}

glm::vec3 Environment::texel(size_t at) const {
  const float* t = &picture_.texels[3 * at];
  return {t[0], t[1], t[2]};
}

glm::vec3 Environment::capped(glm::vec3 radiance) const { return glm::min(radiance, mean_); }

glm::vec3 Environment::capped_radiance(glm::vec3 d) const {
  const float across = std::atan2(d.x, -d.z) / (2 * kPi) + 0.5f, down = std::acos(std::clamp(d.y, -1.0f, 1.0f)) / kPi;
  const int x = std::clamp(static_cast<int>(across * static_cast<float>(picture_.width)), 0, picture_.width - 1);
  const int y = std::clamp(static_cast<int>(down * static_cast<float>(picture_.height)), 0, picture_.height - 1);
  return capped(texel(static_cast<size_t>(y) * static_cast<size_t>(picture_.width) + static_cast<size_t>(x)));
}

glm::vec3 turned(glm::vec3 d, float degrees) {
  const float a = glm::radians(degrees), c = std::cos(a), s = std::sin(a);
  return {d.x * c + d.z * s, d.y, d.z * c - d.x * s};
}

/// Band 1 is a vector, band 2 a symmetric matrix without trace.
Harmonics turned(const Harmonics& sky, float degrees) {
  Harmonics out = sky;
  const glm::mat3 turn(turned(glm::vec3(1, 0, 0), degrees), glm::vec3(0, 1, 0), turned(glm::vec3(0, 0, 1), degrees));
  for (int k = 0; k < 3; ++k) {
    const auto c = [&](size_t i) { return sky[i][k]; };
    const glm::vec3 one = turn * glm::vec3(c(3), c(1), c(2));
    out[3][k] = one.x, out[1][k] = one.y, out[2][k] = one.z;
    const float xy = 0.546274f * c(4), yz = 0.546274f * c(5), xz = 0.546274f * c(7), zz = 0.315392f * c(6);
    const float even = 0.546274f * c(8);
    const glm::mat3 q = turn * glm::mat3(even - zz, xy, xz, xy, -even - zz, yz, xz, yz, 2 * zz) * glm::transpose(turn);
    out[4][k] = q[0][1] / 0.546274f, out[5][k] = q[1][2] / 0.546274f, out[7][k] = q[0][2] / 0.546274f;
    out[6][k] = q[2][2] / (2 * 0.315392f), out[8][k] = (q[0][0] - q[1][1]) / (2 * 0.546274f);
  }
  return out;
}

}  // namespace weftlight::scene
