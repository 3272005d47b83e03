// Rank-one factorisation of a BRDF's matrix by weighted alternating least squares. Differs from Kautz and McCool, who
// take the first pair of a singular value decomposition: pairs of directions below the horizon have no weight, instead
// of pulling the product towards zero.

#include "light/separable.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"

namespace weftlight::light {

using base::for_each_job;

namespace {

constexpr int kRounds = 6;  // the error has converged to three digits

struct Texel {
  int face, index;
  glm::vec3 direction;
};

/// Texels with their centre above the horizon.
std::vector<Texel> upper_texels(int size) {
  std::vector<Texel> texels;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < size * size; ++i) {
      const glm::vec3 d = glm::normalize(
          cube_direction(face, static_cast<float>(i % size) + 0.5f, static_cast<float>(i / size) + 0.5f, size));
      if (d.z > 0) texels.push_back({face, i, d});
    }
  return texels;
}

struct Pair {
  glm::vec3 wi, wo;
};

/// Inverse of vrst03_difference: rotates d from the frame of h and mirrors it.
Pair from_half_difference(const glm::vec3& h, const glm::vec3& d) {
  glm::vec3 t = glm::vec3(1, 0, 0) - h * h.x;
  const float t2 = glm::dot(t, t);
  t = t2 > 1e-8f ? t / std::sqrt(t2) : glm::vec3(0, 1, 0);
  const glm::vec3 wi = t * d.x + glm::cross(h, t) * d.y + h * d.z;
  return {wi, h * (2 * glm::dot(wi, h)) - wi};
}

/// The BRDF over rows x columns; `known` is 1 where both directions are above the horizon.
struct Matrix {
  int rows, cols;
  std::vector<float> known;
  std::array<std::vector<float>, 3> channel;
};

Matrix tabulate(const ClothBrdf& brdf, Split split, const std::vector<Texel>& texels, int threads) {
  const int n = static_cast<int>(texels.size());
  Matrix m{n, n, {}, {}};
  m.known.assign(static_cast<size_t>(n) * static_cast<size_t>(n), 0.0f);
  for (auto& c : m.channel) c.assign(m.known.size(), 0.0f);
  for_each_job(n, threads, [&](int row) {
    for (int col = 0; col < n; ++col) {
      const glm::vec3 &a = texels[static_cast<size_t>(row)].direction, &b = texels[static_cast<size_t>(col)].direction;
      const Pair p = split == Split::kRaw ? Pair{a, b} : from_half_difference(a, b);
      if (p.wi.z <= 0 || p.wo.z <= 0) continue;
      const size_t at = static_cast<size_t>(row) * static_cast<size_t>(n) + static_cast<size_t>(col);
      const glm::vec3 f = evaluate(brdf, p.wi, p.wo);
      m.known[at] = 1;
      for (int c = 0; c < 3; ++c) m.channel[static_cast<size_t>(c)][at] = f[c];
    }
  });
  return m;
}

struct Product {
  std::vector<float> u, v;
};

Product rank_one(const Matrix& m, const std::vector<float>& f) {
  const size_t rows = static_cast<size_t>(m.rows), cols = static_cast<size_t>(m.cols);
  Product p{std::vector<float>(rows), std::vector<float>(cols, 1.0f)};
  std::vector<float> above(cols), below(cols);
  for (int round = 0; round < kRounds; ++round) {
    std::fill(above.begin(), above.end(), 0.0f);
    std::fill(below.begin(), below.end(), 0.0f);
    for (size_t r = 0; r < rows; ++r) {
      const float *fr = f.data() + r * cols, *kr = m.known.data() + r * cols;
      float top = 0, bottom = 0;
      for (size_t c = 0; c < cols; ++c) top += fr[c] * p.v[c], bottom += kr[c] * p.v[c] * p.v[c];
      const float u = bottom > 0 ? top / bottom : 0.0f;
      p.u[r] = u;
      for (size_t c = 0; c < cols; ++c) above[c] += fr[c] * u, below[c] += kr[c] * u * u;
    }
    for (size_t c = 0; c < cols; ++c) p.v[c] = below[c] > 0 ? above[c] / below[c] : 0.0f;
  }
  return p;
}

struct Misfit {
  double off = 0, all = 0;
};
Misfit misfit(const Matrix& m, const std::vector<float>& f, const Product& p) {
  Misfit e;
  const size_t cols = p.v.size();
  for (size_t r = 0; r < p.u.size(); ++r) {
    float off = 0, all = 0;
    for (size_t c = 0; c < cols; ++c) {
      const size_t at = r * cols + c;
      const float d = m.known[at] * (f[at] - p.u[r] * p.v[c]);
      off += d * d;
      all += f[at] * f[at];
    }
    e.off += static_cast<double>(off);
    e.all += static_cast<double>(all);
  }
  return e;
}

/// Mirrors the upper half into the lower, so that filtering has no edge at the horizon.
void mirror_below(CubeMap& map) {
  const int n = map.size;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < n * n; ++i) {
      glm::vec3 d = cube_direction(face, static_cast<float>(i % n) + 0.5f, static_cast<float>(i / n) + 0.5f, n);
      if (d.z > 0) continue;
      d.z = -d.z;
      map.faces[static_cast<size_t>(face)][static_cast<size_t>(i)] = sample(map, d);
    }
}

CubeMap empty_map(int size) {
  CubeMap map;
  map.size = size;
  for (auto& f : map.faces) f.assign(static_cast<size_t>(size) * static_cast<size_t>(size), glm::vec3(0));
  return map;
}

struct FacePoint {
  int face;
  float x, y;  // 0..1
};
FacePoint face_point(const glm::vec3& d) {
  const glm::vec3 a = glm::abs(d);
  float s = 0, t = 0, m = 0;
  int face = 0;
  if (a.x >= a.y && a.x >= a.z) face = d.x > 0 ? 0 : 1, m = a.x, s = d.x > 0 ? -d.z : d.z, t = -d.y;
  else if (a.y >= a.z) face = d.y > 0 ? 2 : 3, m = a.y, s = d.x, t = d.y > 0 ? d.z : -d.z;
  else face = d.z > 0 ? 4 : 5, m = a.z, s = d.z > 0 ? d.x : -d.x, t = -d.y;
  m = std::max(m, 1e-20f);
  return {face, 0.5f * (s / m + 1), 0.5f * (t / m + 1)};
}

}  // namespace

glm::vec3 cube_direction(int face, float x, float y, int size) {
  const float s = 2 * x / static_cast<float>(size) - 1, t = 2 * y / static_cast<float>(size) - 1;
  switch (face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

glm::vec3 sample(const CubeMap& map, const glm::vec3& direction) {
  const FacePoint p = face_point(direction);
  const float last = static_cast<float>(map.size - 1), n = static_cast<float>(map.size);
  const float x = std::clamp(p.x * n - 0.5f, 0.0f, last), y = std::clamp(p.y * n - 0.5f, 0.0f, last);
  const int i = std::min(static_cast<int>(x), map.size - 2), j = std::min(static_cast<int>(y), map.size - 2);
  const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
  const glm::vec3* at = map.faces[static_cast<size_t>(p.face)].data() + j * map.size + i;
  return glm::mix(glm::mix(at[0], at[1], s), glm::mix(at[map.size], at[map.size + 1], s), t);
}

Separable factorise(const ClothBrdf& brdf, Split split, int size, int threads) {
  size = std::clamp(size, 4, 64);
  const std::vector<Texel> texels = upper_texels(size);
  const Matrix m = tabulate(brdf, split, texels, threads);
  Separable result{split, empty_map(size), empty_map(size), 0};
  std::array<Misfit, 3> errors;
  for_each_job(3, threads, [&](int c) {
    const std::vector<float>& f = m.channel[static_cast<size_t>(c)];
    const Product p = rank_one(m, f);
    errors[static_cast<size_t>(c)] = misfit(m, f, p);
    for (size_t k = 0; k < texels.size(); ++k) {
      const Texel& t = texels[k];
      result.first.faces[static_cast<size_t>(t.face)][static_cast<size_t>(t.index)][c] = p.u[k];
      result.second.faces[static_cast<size_t>(t.face)][static_cast<size_t>(t.index)][c] = p.v[k];
    }
  });
  mirror_below(result.first);
  mirror_below(result.second);
  double off = 0, all = 0;
  for (const Misfit& e : errors) off += e.off, all += e.all;
  result.error = all > 0 ? static_cast<float>(std::sqrt(off / all)) : 0.0f;
  return result;
}

glm::vec3 evaluate(const Separable& separable, const glm::vec3& wi, const glm::vec3& wo) {
  if (wi.z <= 0 || wo.z <= 0) return glm::vec3(0);
  if (separable.split == Split::kRaw) return sample(separable.first, wi) * sample(separable.second, wo);
  return sample(separable.first, wi + wo) * sample(separable.second, formulas::vrst03_difference(wi, wo));
}

}  // namespace weftlight::light
