#include "light/engine_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "cloth/layers.h"

namespace weftlight::light {

using cloth::Direction, cloth::Linear, cloth::Slope, cloth::ThreadBody, cloth::layer_count, cloth::linear_from_srgb;

namespace {

constexpr float kMaxSlope = 4.0f;  // 76 degrees, so that one grazing facet does not make a wide lobe
// Samples a side:
constexpr int kFacets = 4;  // of a pixel's facets
// Of its means. Fewer leave normals that differ by chance: 4 made the highlight of silk satin half as wide again, so
// that its images had to be narrower than the fit knew.
constexpr int kPixelSamples = 24;
constexpr int kLobeFacets = 48;  // of a window of lobes: what shows between floats is a thin strip
constexpr int kTexels = 16;      // where a pixel is one texel
constexpr int kMeans = 64;       // for the means of the whole face

glm::vec3 vec(const Linear& c) { return {c.r, c.g, c.b}; }

/// Tangent frame of a normal: t along the texture's x, seen from above.
struct Axes {
  glm::vec3 t, b;
};
Axes axes_over(const glm::vec3& n) {
  glm::vec3 t = glm::vec3(1, 0, 0) - n * n.x;
  t = glm::dot(t, t) > 1e-12f ? glm::normalize(t) : glm::vec3(0, 0, -1);
  return {t, glm::cross(n, t)};
}

/// The thread of a system closest to a position, mm; the map of threads may be freed already.
const ThreadBody& closest_thread(const std::vector<ThreadBody>& threads, float at_mm) {
  const auto after = std::lower_bound(threads.begin(), threads.end(), at_mm,
                                      [](const ThreadBody& t, float at) { return t.centre_mm < at; });
  if (after == threads.begin()) return *after;
  if (after == threads.end() || at_mm - std::prev(after)->centre_mm < after->centre_mm - at_mm)
    return *std::prev(after);
  return *after;
}

/// One texel of the maps: material without alphas, and its facets without the spread of the normals.
struct Sample {
  formulas::EngineMaterial material{};
  glm::vec3 normal{0, 0, 1};
  glm::vec2 grain{0.5f};
  EngineFacet facet;
};

const Lobes& lobes_at(const Cloth& cloth, const Maps& maps, int x, int y) {
  const bool weft = maps.system.at(x, y) != 0;
  if (!cloth.layers.empty() && !maps.thread.at_.empty()) {
    const ThreadBody& seen = (weft ? cloth.picks : cloth.ends)[maps.thread.at(x, y)];
    return cloth.yarns[static_cast<size_t>(seen.yarn)].lobes;
  }
  const float u_mm = (static_cast<float>(x) + 0.5f) / static_cast<float>(maps.coverage.width) * maps.width_mm;
  const float v_mm = (static_cast<float>(y) + 0.5f) / static_cast<float>(maps.coverage.height) * maps.depth_mm;
  const ThreadBody& body = weft ? closest_thread(cloth.picks, v_mm) : closest_thread(cloth.ends, u_mm);
  return cloth.yarns[static_cast<size_t>(body.yarn)].lobes;
}

glm::vec3 base_of(const Lobes& lobes, const glm::vec3& colour) {
  return lobes.metallic ? colour * vec(linear_from_srgb(lobes.specular_tint)) * lobes.specular : colour * lobes.body;
}

Sample sample(const Cloth& cloth, const Maps& maps, int x, int y) {
  const Lobes& lobes = lobes_at(cloth, maps, x, y);
  const glm::vec3 dye = vec(maps.colour.at(x, y));
  const Slope slope = maps.slope.at(x, y);
  const Direction fibre = maps.tangent.at(x, y);
  const glm::vec3 along{fibre.x, fibre.y, fibre.z};
  Sample out;
  out.normal = glm::normalize(glm::vec3(slope.x, slope.y, 1));
  out.material.base = base_of(lobes, dye * maps.groove.at(x, y));
  out.material.metal = lobes.metallic ? 1.0f : 0.0f;
  out.material.sheen = glm::sqrt(dye) * lobes.fuzz;
  out.material.occlusion = maps.occlusion.at(x, y);
  out.facet.covariance = facet_covariance(out.normal, along, lobes);
  out.grain = out.facet.grain = grain_of(along);
  out.facet.weft = maps.system.at(x, y) != 0;
  out.facet.weight = maps.coverage.at(x, y);
  return out;
}

/// Position 0..1 of one of side x side samples. Rows and columns are offset by the golden ratio, since threads are as
/// regular as a grid.
glm::vec2 sample_position(int i, int j, int side) {
  const auto along = [side](int a, int b) {
    return (static_cast<float>(a) + std::fmod(0.5f + 0.618034f * static_cast<float>(b), 1.0f)) /
           static_cast<float>(side);
  };
  return {along(i, j), along(j, i)};
}

Sample sample_at(const Cloth& cloth, const Maps& maps, glm::vec2 at) {
  const int x = static_cast<int>((at.x - std::floor(at.x)) * static_cast<float>(maps.coverage.width));
  const int y = static_cast<int>((at.y - std::floor(at.y)) * static_cast<float>(maps.coverage.height));
  return sample(cloth, maps, std::min(x, maps.coverage.width - 1), std::min(y, maps.coverage.height - 1));
}

glm::vec3 mean_normal(const std::vector<Sample>& samples) {
  glm::vec3 sum(0, 0, 1e-6f);
  for (const Sample& s : samples) sum += s.facet.weight * s.normal;
  return glm::normalize(sum);
}

/// Means of the images' values.
EngineTexel pixel_of(const std::vector<Sample>& samples) {
  EngineTexel out;
  float total = 1e-9f;
  for (const Sample& s : samples) {
    const float w = s.facet.weight;
    total += w;
    out.material.base += w * s.material.base, out.material.sheen += w * s.material.sheen;
    out.material.metal += w * s.material.metal, out.material.occlusion += w * s.material.occlusion;
  }
  out.material.base /= total, out.material.sheen /= total, out.material.metal /= total, out.material.occlusion /= total;
  out.normal = mean_normal(samples);
  out.weight = total;
  return out;
}

std::vector<EngineFacet> facets_of(const std::vector<Sample>& samples) {
  std::vector<EngineFacet> out;
  for (const Sample& s : samples)
    if (s.facet.weight > 0) out.push_back(s.facet);
  return out;
}

/// Samples of a box (sides in periods) of the face.
std::vector<Sample> samples_in(const Cloth& cloth, const Maps& maps, glm::vec2 middle, glm::vec2 box, int side) {
  std::vector<Sample> out;
  for (int l = 0; l < side; ++l) {
    for (int k = 0; k < side; ++k)
      out.push_back(
          sample_at(cloth, maps, middle + (sample_position(k, l, side) - 0.5f) * glm::min(box, glm::vec2(1))));
  }
  return out;
}

/// Lobes as textures hold them: of windows side by side over the period, interpolated between their centres.
class Windows {
 public:
  /// window: its sides in periods.
  Windows(const Cloth& cloth, const Maps& maps, glm::vec2 window)
      : cloth_(cloth), maps_(maps), count_(glm::exp2(glm::max(glm::round(-glm::log2(window)), glm::vec2(0)))) {}
  FootprintLobe at(glm::vec2 position) {
    const glm::vec2 low = glm::floor(position * count_ - 0.5f), t = position * count_ - 0.5f - low;
    FootprintLobe out{glm::vec3(0), glm::vec2(0)};
    for (int k = 0; k < 4; ++k) {
      const glm::vec2 step(static_cast<float>(k % 2), static_cast<float>(k / 2));
      const glm::vec2 part = glm::mix(1.0f - t, t, step);
      const FootprintLobe& lobe = window(glm::mod(low + step, count_));
      out.covariance += part.x * part.y * lobe.covariance, out.grain += part.x * part.y * lobe.grain;
    }
    return out;
  }

 private:
  const FootprintLobe& window(glm::vec2 node) {
    const auto [at, made] = windows_.try_emplace({static_cast<int>(node.x), static_cast<int>(node.y)});
    if (!made) return at->second;
    std::vector<LobePart> parts;
    for (const Sample& s : samples_in(cloth_, maps_, (node + 0.5f) / count_, 1.0f / count_, kLobeFacets))
      parts.push_back({s.normal, s.facet.covariance, s.grain, s.facet.weight});
    return at->second = footprint_lobe(parts);
  }

  const Cloth& cloth_;
  const Maps& maps_;
  glm::vec2 count_;
  std::map<std::pair<int, int>, FootprintLobe> windows_;
};

/// Means of the whole face.
struct FaceMeans {
  glm::vec3 base{0}, sheen{0}, normal{0, 0, 1e-6f};
};

FaceMeans means_of(const Cloth& cloth, const Maps& maps) {
  FaceMeans out;
  float total = 1e-9f;
  for (int j = 0; j < kMeans; ++j) {
    for (int i = 0; i < kMeans; ++i) {
      const glm::vec2 at = sample_position(i, j, kMeans);
      const int x = std::min(static_cast<int>(at.x * static_cast<float>(maps.coverage.width)), maps.coverage.width - 1);
      const int y =
          std::min(static_cast<int>(at.y * static_cast<float>(maps.coverage.height)), maps.coverage.height - 1);
      const Lobes& lobes = lobes_at(cloth, maps, x, y);
      const glm::vec3 dye = vec(maps.colour.at(x, y));
      const Slope slope = maps.slope.at(x, y);
      const float w = maps.coverage.at(x, y);
      total += w, out.base += w * base_of(lobes, dye * maps.groove.at(x, y)),
          out.sheen += w * glm::sqrt(dye) * lobes.fuzz;
      out.normal += w * glm::normalize(glm::vec3(slope.x, slope.y, 1));
    }
  }
  out.base /= total, out.sheen /= total;
  return out;
}

/// Scales the colours of the pixels so that their means are those of the whole face, and turns the normals so that
/// their mean points straight out.
void keep_means(EngineTexels& out, const FaceMeans& means) {
  glm::vec3 base(1e-6f), sheen(1e-6f);
  float total = 1e-9f;
  for (const EngineTexel& t : out.texels)
    total += t.weight, base += t.weight * t.material.base, sheen += t.weight * t.material.sheen;
  out.lean = glm::vec2(means.normal) / means.normal.z;
  for (EngineTexel& t : out.texels) {
    t.material.base *= means.base * total / base, t.material.sheen *= means.sheen * total / sheen;
    t.normal = straightened(t.normal, out.lean);
  }
}

}  // namespace

glm::vec3 straightened(const glm::vec3& normal, const glm::vec2& lean) {
  return glm::normalize(glm::vec3(glm::vec2(normal) - normal.z * lean, normal.z));
}

glm::vec3 flattened(const glm::vec3& normal, const glm::vec2& relief) {
  return glm::normalize(glm::vec3(glm::vec2(normal) * relief, normal.z));
}

glm::vec2 grain_of(const glm::vec3& fibre) {
  const glm::vec2 squares{fibre.x * fibre.x, fibre.y * fibre.y};
  return squares / std::max(squares.x + squares.y, 1e-12f);
}

FootprintLobe footprint_lobe(std::span<const LobePart> parts) {
  FootprintLobe out{glm::vec3(0), glm::vec2(1e-9f)};
  glm::vec3 normal(0, 0, 1e-6f);
  for (const LobePart& p : parts) normal += p.weight * p.normal;
  normal = glm::normalize(normal);
  const Axes axes = axes_over(normal);
  float total = 1e-9f;
  for (const LobePart& p : parts) {
    const float up = std::max(glm::dot(p.normal, normal), 1 / kMaxSlope);
    const glm::vec2 slope =
        glm::clamp(glm::vec2(glm::dot(p.normal, axes.t), glm::dot(p.normal, axes.b)) / up, -kMaxSlope, kMaxSlope);
    out.covariance += p.weight * (p.covariance + glm::vec3(slope.x * slope.x, slope.x * slope.y, slope.y * slope.y));
    out.grain += p.weight * p.grain, total += p.weight;
  }
  out.covariance /= total, out.grain /= out.grain.x + out.grain.y;
  return out;
}

glm::vec3 scaled_covariance(const FootprintLobe& lobe, const LobeScale& scale) {
  const glm::vec2 root = glm::sqrt(glm::max(scale.fibre, glm::vec2(1e-6f)));  // of slopes
  const float alike = lobe.grain.x - lobe.grain.y, middle = std::sqrt(root.x * root.y);
  const float more = std::pow(root.x / root.y, 0.5f * alike);
  const float weft = std::sqrt(scale.weft);
  const glm::vec2 by{middle * more * weft, middle / (more * weft)};
  return lobe.covariance * glm::vec3(by.x * by.x, by.x * by.y, by.y * by.y);
}

FacetAlphas facet_alphas(const glm::vec3& c) {
  const auto alpha = [](float variance) { return std::min(std::sqrt(2.0f * std::max(variance, 0.0f)), 1.0f); };
  const float middle = 0.5f * (c.x + c.z), half_gap = 0.5f * (c.x - c.z);
  const float root = std::sqrt(half_gap * half_gap + c.y * c.y);
  // Half the angle of (half_gap, c.y), without leaving the roots.
  const float cosine = root > 1e-9f ? std::sqrt(std::max(0.5f + 0.5f * half_gap / root, 0.0f)) : 1.0f;
  const float sine = root > 1e-9f ? std::sqrt(std::max(0.5f - 0.5f * half_gap / root, 0.0f)) : 0.0f;
  return {{alpha(middle + root), alpha(middle - root)}, {cosine, c.y < 0 ? -sine : sine}};
}

glm::vec2 EngineLobe::alpha() const {
  const float narrow = roughness * roughness;
  return {narrow + (1 - narrow) * strength * strength, narrow};
}

EngineLobe engine_lobe(const EngineTexel& texel, const LobeScale& scale, float footprint_weight) {
  EngineLobe out{{0, 0}, 0, 0};
  float total = 1e-9f;
  const auto add = [&](const glm::vec3& covariance, bool weft, float w) {
    const FacetAlphas a = facet_alphas(covariance);
    // Both directions of an axis are the same: use +x across a warp, +y across a weft; for a footprint the sign of the
    // longer component.
    const bool up = footprint_weight > 0.5f ? std::abs(a.axis.y) > std::abs(a.axis.x) : weft;
    out.axis += ((up ? a.axis.y : a.axis.x) < 0 ? -w : w) * a.axis, total += w;
    out.roughness += w * std::sqrt(a.alpha.y);
    out.strength += w * (a.alpha.y < 1 ? std::sqrt(std::max(a.alpha.x - a.alpha.y, 0.0f) / (1 - a.alpha.y)) : 0.0f);
  };
  const glm::vec3 whole = scaled_covariance(texel.lobe, scale);
  if (texel.facets.empty()) add(whole, false, 1);
  for (const EngineFacet& f : texel.facets) {
    const glm::vec3 own = footprint_weight > 0 ? f.covariance : scaled_covariance({f.covariance, f.grain}, scale);
    add(glm::mix(own, whole, footprint_weight), f.weft, f.weight);
  }
  out.roughness /= total, out.strength /= total;
  out.axis = glm::dot(out.axis, out.axis) > 1e-12f ? glm::normalize(out.axis) : glm::vec2(1, 0);
  return out;
}

float thread_spacing_mm(const Cloth& cloth) {
  const float layers = static_cast<float>(layer_count(cloth));
  return 0.5f * layers *
         (cloth.width_mm / static_cast<float>(std::max<size_t>(1, cloth.ends.size())) +
          cloth.depth_mm / static_cast<float>(std::max<size_t>(1, cloth.picks.size())));
}

float lobe_window_mm(float footprint_mm, float spacing_mm) { return std::max(footprint_mm, 2 * spacing_mm); }

float footprint_weight(float footprint_mm, float spacing_mm) {
  return std::clamp(0.5f * footprint_mm / std::max(spacing_mm, 1e-6f), 0.0f, 1.0f);
}

EngineTexels engine_texels(const Cloth& cloth, const Maps& maps, float footprint_mm, int pixels) {
  EngineTexels out;
  if (cloth.ends.empty() || cloth.picks.empty() || maps.coverage.width < 1 || maps.coverage.height < 1) return out;
  const float spacing_mm = thread_spacing_mm(cloth);
  const glm::vec2 period(cloth.width_mm, cloth.depth_mm);
  const glm::vec2 pixel = footprint_mm / period, window = lobe_window_mm(footprint_mm, spacing_mm) / period;
  out.footprint_weight = footprint_weight(footprint_mm, spacing_mm);
  const bool single = footprint_mm <= cloth.width_mm / static_cast<float>(maps.coverage.width);
  const int side = single ? kTexels : pixels;
  const auto samples_of = [&](int of_pixel, const glm::vec2& middle) {
    return single ? std::vector{sample_at(cloth, maps, middle)} : samples_in(cloth, maps, middle, pixel, of_pixel);
  };
  Windows windows(cloth, maps, glm::clamp(window, glm::vec2(1e-4f), glm::vec2(1)));
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::vec2 middle = sample_position(i, j, side);
      EngineTexel seen = pixel_of(samples_of(kPixelSamples, middle));
      if (seen.weight <= 1e-6f) continue;
      if (out.footprint_weight < 1) seen.facets = facets_of(samples_of(kFacets, middle));
      if (out.footprint_weight > 0) seen.lobe = windows.at(middle);
      out.texels.push_back(std::move(seen));
    }
  }
  keep_means(out, means_of(cloth, maps));
  return out;
}

std::array<EngineLobe, 2> engine_lobes(const EngineTexels& texels, const LobeScale& scale, float weft_fraction) {
  // Linear fit over the pixels by the direction of their fibres.
  constexpr float kAlike = 1e-3f;  // below this variance there is nothing to fit
  glm::vec4 mean(0), both(0);
  float total = 1e-9f, at = 0, square = 0;
  for (const EngineTexel& t : texels.texels) {
    const EngineLobe lobe = engine_lobe(t, scale, texels.footprint_weight);
    const glm::vec4 v(lobe.axis, lobe.roughness, lobe.strength);
    const float x = t.lobe.grain.x, w = t.weight;
    total += w, mean += w * v, both += w * x * v, at += w * x, square += w * x * x;
  }
  mean /= total, both /= total, at /= total, square /= total;
  const float variance = square - at * at;
  const glm::vec4 rise = variance > kAlike ? (both - at * mean) / variance : glm::vec4(0);
  std::array<EngineLobe, 2> out;
  for (size_t s = 0; s < 2; ++s) {
    const glm::vec4 v = mean + rise * (static_cast<float>(s) - weft_fraction);
    out[s] = {{v.x, v.y}, v.z, v.w};
  }
  return out;
}

}  // namespace weftlight::light
