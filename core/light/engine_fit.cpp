// Linear least squares over pairs of views and lights, relative to what is sent and to the mean of the view; the
// sheen's roughness by trial; what couples the parts (Fresnel, and what sheen leaves) is taken from the round before.

#include "light/engine_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

using formulas::EngineMaterial;
using formulas::EngineParts;

constexpr int kSide = 8;            // texels as fine as the maps: so many squared
constexpr float kMostSlope = 4.0f;  // 76 degrees: one grazing facet is not a wide lobe
constexpr int kRounds = 3;
constexpr float kMostSpecular = 2.0f;  // of the dielectric reflectance; engines end there
constexpr float kMostShift = 0.15f;    // of base colour, for the sake of the sum alone
constexpr float kMostScale = 4.0f;     // of base colour and of sheen
constexpr size_t kUnknowns = 5;        // base r, g, b, specular, sheen
constexpr std::array<float, 7> kSheenRoughness{0.25f, 0.35f, 0.45f, 0.55f, 0.7f, 0.85f, 1.0f};

glm::vec3 vec(const Linear& c) { return {c.r, c.g, c.b}; }

/// Axes over a normal: the first lies along the texture's x, seen from above.
struct Axes {
  glm::vec3 t, b;
};
Axes axes_over(const glm::vec3& n) {
  glm::vec3 t = glm::vec3(1, 0, 0) - n * n.x;
  t = glm::dot(t, t) > 1e-12f ? glm::normalize(t) : glm::vec3(0, 0, -1);
  return {t, glm::cross(n, t)};
}

/// Density of a slope's angle, between the middles of the bins, as a texture unit reads it.
float density_at(const std::array<float, kSlopeBins>& bins, float slope) {
  const float at = std::clamp(formulas::slope_coord(slope) * kSlopeBins - 0.5f, 0.0f, kSlopeBins - 1.001f);
  const size_t k = static_cast<size_t>(at);
  return bins[k] + (bins[k + 1] - bins[k]) * (at - static_cast<float>(k));
}

/// Warp and weft as rung `cloth` takes them.
std::array<formulas::YarnLobes, 2> mean_yarns(const Cloth& cloth, const ClothResponse& response) {
  std::array<formulas::YarnLobes, 2> out;
  for (size_t s = 0; s < 2; ++s) {
    out[s] = formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), vec(response.systems[s].colour));
  }
  return out;
}

/// What the whole cloth sends from light node to view node for a unit of irradiance at right angles.
glm::vec3 cloth_answer(const std::array<formulas::YarnLobes, 2>& yarns, const ClothResponse& response, size_t view,
                       size_t light) {
  static const std::array<glm::vec3, kResponseViews> w = response_views();
  const glm::vec3 v = w[view], l = w[view_of_light(light)];
  const glm::vec2 h = formulas::half_slopes(l, v);
  glm::vec3 sum(0);
  for (size_t s = 0; s < 2; ++s) {
    const SystemResponse& system = response.systems[s];
    const float* broad = &system.broad[4 * (view * kResponseLights + light)];
    const glm::vec2 slopes{density_at(system.slopes[0], h.x), density_at(system.slopes[1], h.y)};
    sum +=
        formulas::system_answer(yarns[s], {broad[0], broad[1], broad[2], broad[3]}, slopes, system.share, 1, l, v).key;
  }
  return sum;
}

/// A node of the grid of views or of lights, and its share of the hemisphere.
struct Node {
  size_t index = 0;  // view or light
  glm::vec3 w{0, 0, 1};
  float share = 0;
};

/// Down to an elevation node, `azimuths` a ring of the `of` that there are.
std::vector<Node> nodes(size_t lowest, size_t azimuths, size_t of) {
  static const std::array<glm::vec3, kResponseViews> w = response_views();
  std::vector<Node> out;
  const auto edge = [](size_t k) {
    return k >= 7 ? 1.0f : 0.5f * (w[k * kViewAzimuths].z + w[(k + 1) * kViewAzimuths].z);
  };
  for (size_t k = lowest; k < static_cast<size_t>(kResponseElevations); ++k) {
    const size_t ring = k == 7 ? 1 : azimuths;
    const float below = k == 0 ? 0.0f : edge(k - 1), share = (edge(k) - below) / static_cast<float>(ring);
    for (size_t a = 0; a < ring; ++a) {
      const size_t at = a * (of / azimuths);
      out.push_back({k * of + at, w[k * kViewAzimuths + at * (kViewAzimuths / of)], share});
    }
  }
  return out;
}

struct Pair {
  size_t view = 0, light = 0;  // among the nodes
  glm::vec3 wanted{0};
  float weight = 0;  // of the squares: over what is sent and the mean of the view, so that no highlight rules
  float share = 0;
};

struct Problem {
  std::vector<Node> views, lights;
  std::vector<Pair> pairs;
};

Problem problem_of(const Cloth& cloth, const ClothResponse& response) {
  Problem out{nodes(4, 8, kViewAzimuths), nodes(3, 8, kLightAzimuths), {}};
  const std::array<formulas::YarnLobes, 2> yarns = mean_yarns(cloth, response);
  for (size_t v = 0; v < out.views.size(); ++v) {
    const size_t first = out.pairs.size();
    float sum = 0, shares = 0;
    for (size_t l = 0; l < out.lights.size(); ++l) {
      const glm::vec3 wanted = cloth_answer(yarns, response, out.views[v].index, out.lights[l].index);
      const float share = out.views[v].share * out.lights[l].share;
      out.pairs.push_back({v, l, wanted, 0, share});
      sum += share * (wanted.r + wanted.g + wanted.b), shares += share;
    }
    const float mean = std::max(sum / std::max(shares, 1e-9f), 1e-4f);
    for (size_t i = first; i < out.pairs.size(); ++i) {
      const glm::vec3& wanted = out.pairs[i].wanted;
      const float size = 0.5f * (mean + wanted.r + wanted.g + wanted.b);
      out.pairs[i].weight = out.pairs[i].share / (size * size);
    }
  }
  return out;
}

/// What the texels send for each pair, part by part, for factors of one.
struct Sent {
  glm::vec3 body{0}, fuzz{0};
  float gloss = 0;
};

EngineMaterial fitted(EngineMaterial m, const EngineFit& fit) {
  m.base = glm::min(m.base * fit.base, glm::vec3(1));
  m.sheen = glm::min(m.sheen * fit.sheen, glm::vec3(1));
  m.sheen_roughness = fit.sheen_roughness, m.specular = fit.specular;
  return m;
}

/// What a channel of a part is for a factor of one.
glm::vec3 over(const glm::vec3& part, const glm::vec3& factor) { return part / glm::max(factor, glm::vec3(1e-3f)); }

std::vector<Sent> sent_by(std::span<const EngineTexel> texels, const Problem& problem, const EngineFit& fit,
                          int sheen) {
  std::vector<Sent> out(problem.pairs.size());
  float total = 0;
  for (const EngineTexel& t : texels) total += t.weight;
  for (const EngineTexel& t : texels) {
    const EngineMaterial m = fitted(t.material, fit);
    const formulas::LobeFrame f = formulas::lobe_frame(t.normal, {t.wide_axis, 0});
    std::vector<glm::vec3> wi, wo;
    for (const Node& n : problem.lights) wi.push_back(formulas::lobe_local(f, n.w));
    for (const Node& n : problem.views) wo.push_back(formulas::lobe_local(f, n.w));
    const float share = t.weight / std::max(total, 1e-9f);
    for (size_t i = 0; i < out.size(); ++i) {
      const Pair& pair = problem.pairs[i];
      const EngineParts p = formulas::engine_parts(m, sheen, wi[pair.light], wo[pair.view]);
      out[i].body += over(p.body * (p.kept * share), fit.base);
      out[i].fuzz += p.fuzz * (share / std::max(fit.sheen, 1e-3f));
      out[i].gloss += p.gloss.r * p.kept * share;
    }
  }
  return out;
}

/// Non-negative least squares by coordinates; `held` unknowns stay as they are.
using Unknowns = std::array<float, kUnknowns>;
struct Normal {
  std::array<std::array<double, kUnknowns>, kUnknowns> a{};
  std::array<double, kUnknowns> b{};
  double wanted2 = 0;
  void add(const Unknowns& row, float wanted, float weight) {
    for (size_t i = 0; i < kUnknowns; ++i) {
      for (size_t j = 0; j < kUnknowns; ++j) a[i][j] += static_cast<double>(weight * row[i] * row[j]);
      b[i] += static_cast<double>(weight * row[i] * wanted);
    }
    wanted2 += static_cast<double>(weight * wanted * wanted);
  }
  void solve(Unknowns& x, const Unknowns& most, const std::array<bool, kUnknowns>& held) const {
    for (int round = 0; round < 400; ++round) {
      for (size_t i = 0; i < kUnknowns; ++i) {
        if (held[i] || a[i][i] <= 1e-12) continue;
        double rest = b[i];
        for (size_t j = 0; j < kUnknowns; ++j) rest -= j == i ? 0.0 : a[i][j] * static_cast<double>(x[j]);
        x[i] = std::clamp(static_cast<float>(rest / a[i][i]), 0.0f, most[i]);
      }
    }
  }
  float error(const Unknowns& x) const {
    double sum = wanted2;
    for (size_t i = 0; i < kUnknowns; ++i) {
      sum -= 2 * b[i] * static_cast<double>(x[i]);
      for (size_t j = 0; j < kUnknowns; ++j) sum += a[i][j] * static_cast<double>(x[i]) * static_cast<double>(x[j]);
    }
    return static_cast<float>(std::sqrt(std::max(sum, 0.0) / std::max(wanted2, 1e-30)));
  }
};

Normal normal_of(const Problem& problem, const std::vector<Sent>& sent) {
  Normal out;
  for (size_t i = 0; i < sent.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      Unknowns row{};
      row[static_cast<size_t>(c)] = sent[i].body[c], row[3] = sent[i].gloss, row[4] = sent[i].fuzz[c];
      out.add(row, problem.pairs[i].wanted[c], problem.pairs[i].weight);
    }
  }
  return out;
}

/// Sums over all views and lights become the measured ones, by the base colour.
void keep_sums(EngineFit& fit, const Problem& problem, const std::vector<Sent>& sent) {
  for (int c = 0; c < 3; ++c) {
    float wanted = 0, body = 0, rest = 0;
    for (size_t i = 0; i < sent.size(); ++i) {
      const float share = problem.pairs[i].share;
      wanted += share * problem.pairs[i].wanted[c], body += share * sent[i].body[c];
      rest += share * (sent[i].gloss * fit.specular + sent[i].fuzz[c] * fit.sheen);
    }
    // A highlight that the model lacks is not to be spread over all directions.
    const float base = std::max(fit.base[c], 0.02f);
    if (body > 1e-9f)
      fit.base[c] = std::clamp((wanted - rest) / body, (1 - kMostShift) * base, (1 + kMostShift) * base);
  }
}

EngineFit fit_with(std::span<const EngineTexel> texels, const Problem& problem, const EngineModel& model,
                   float sheen_roughness) {
  EngineFit fit;
  fit.sheen_roughness = sheen_roughness;
  if (model.sheen == formulas::kSheenNone) fit.sheen = 0;
  float most_sheen = 1e-3f;
  for (const EngineTexel& t : texels)
    most_sheen = std::max({most_sheen, t.material.sheen.r, t.material.sheen.g, t.material.sheen.b});
  const Unknowns most{kMostScale, kMostScale, kMostScale, kMostSpecular, std::min(kMostScale, 1 / most_sheen)};
  const std::array<bool, kUnknowns> held{false, false, false, !model.specular, model.sheen == formulas::kSheenNone};
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Sent> sent = sent_by(texels, problem, fit, model.sheen);
    const Normal normal = normal_of(problem, sent);
    Unknowns x{fit.base.r, fit.base.g, fit.base.b, fit.specular, fit.sheen};
    normal.solve(x, most, held);
    fit.base = {x[0], x[1], x[2]}, fit.specular = x[3], fit.sheen = x[4];
    keep_sums(fit, problem, sent);
    fit.error = normal.error({fit.base.r, fit.base.g, fit.base.b, fit.specular, fit.sheen});
  }
  return fit;
}

/// The thread nearest to a place across its system, mm; the maps' own may be gone.
const ThreadBody& nearest_thread(const std::vector<ThreadBody>& threads, float at_mm) {
  return *std::min_element(threads.begin(), threads.end(), [at_mm](const ThreadBody& a, const ThreadBody& b) {
    return std::abs(a.centre_mm - at_mm) < std::abs(b.centre_mm - at_mm);
  });
}

/// Of one texel of the maps.
EngineTexel texel_of(const Cloth& cloth, const Maps& maps, glm::vec2 spread, int x, int y) {
  const bool weft = maps.system.at(x, y) != 0;
  const float u_mm = (static_cast<float>(x) + 0.5f) / static_cast<float>(maps.coverage.width) * maps.width_mm;
  const float v_mm = (static_cast<float>(y) + 0.5f) / static_cast<float>(maps.coverage.height) * maps.depth_mm;
  const ThreadBody& body = weft ? nearest_thread(cloth.picks, v_mm) : nearest_thread(cloth.ends, u_mm);
  const Lobes& lobes = cloth.yarns[static_cast<size_t>(body.yarn)].lobes;
  const glm::vec3 dye = vec(maps.colour.at(x, y)), colour = dye * maps.groove.at(x, y);
  const Slope slope = maps.slope.at(x, y);
  const Direction fibre = maps.tangent.at(x, y);
  EngineTexel out;
  out.weight = maps.coverage.at(x, y);
  out.normal = glm::normalize(glm::vec3(slope.x, slope.y, 1));
  out.material.base =
      lobes.metallic ? colour * vec(linear_from_srgb(lobes.specular_tint)) * lobes.specular : colour * lobes.body;
  out.material.metal = lobes.metallic ? 1.0f : 0.0f;
  out.material.sheen = glm::sqrt(dye) * lobes.fuzz;
  out.material.occlusion = maps.occlusion.at(x, y);
  const glm::vec3 covariance = facet_covariance(out.normal, {fibre.x, fibre.y, fibre.z}, lobes);
  const FacetAlphas alphas = facet_alphas(covariance + glm::vec3(spread.x, 0, spread.y));
  out.material.alpha = alphas.alpha, out.wide_axis = alphas.axis;
  return out;
}

/// One of side x side places; rows and columns are set off by the golden ratio, since threads are as regular as a grid.
glm::ivec2 place(const Maps& maps, int i, int j, int side) {
  const auto along = [side](int a, int b) {
    return (static_cast<float>(a) + std::fmod(0.5f + 0.618034f * static_cast<float>(b), 1.0f)) /
           static_cast<float>(side);
  };
  const int x = static_cast<int>(along(i, j) * static_cast<float>(maps.coverage.width));
  const int y = static_cast<int>(along(j, i) * static_cast<float>(maps.coverage.height));
  return {std::min(x, maps.coverage.width - 1), std::min(y, maps.coverage.height - 1)};
}

/// Variances of the slopes of the normals about their mean, over the period.
glm::vec2 spread_of(const Maps& maps) {
  constexpr int kPlaces = 64;
  glm::vec2 sum(0), squares(0);
  float total = 1e-6f;
  for (int j = 0; j < kPlaces; ++j) {
    for (int i = 0; i < kPlaces; ++i) {
      const glm::ivec2 at = place(maps, i, j, kPlaces);
      const Slope slope = maps.slope.at(at.x, at.y);
      const glm::vec2 s = glm::clamp(glm::vec2(slope.x, slope.y), -kMostSlope, kMostSlope);
      const float w = maps.coverage.at(at.x, at.y);
      total += w, sum += w * s, squares += w * s * s;
    }
  }
  const glm::vec2 mean = sum / total;
  return glm::max(squares / total - mean * mean, glm::vec2(0));
}

/// The last mip of an engine: means of what the images hold.
EngineTexel mean_of(std::span<const EngineTexel> texels) {
  EngineTexel out = texels[0];
  glm::vec3 base(0), sheen(0), normal(0);
  glm::vec2 roughness(0), axis(0);
  float total = 1e-9f, metal = 0, occlusion = 0;
  for (const EngineTexel& t : texels) {
    const float w = t.weight;
    total += w, base += t.material.base * w, sheen += t.material.sheen * w, normal += t.normal * w;
    metal += t.material.metal * w, occlusion += t.material.occlusion * w;
    roughness += glm::sqrt(t.material.alpha) * w;
    axis += (std::abs(t.wide_axis.x) > std::abs(t.wide_axis.y) ? glm::sign(t.wide_axis.x) : glm::sign(t.wide_axis.y)) *
            t.wide_axis * w;
  }
  out.material.base = base / total, out.material.sheen = sheen / total;
  out.material.metal = metal / total, out.material.occlusion = occlusion / total;
  out.normal = glm::normalize(normal + glm::vec3(0, 0, 1e-6f));
  out.material.alpha = roughness / total * (roughness / total);
  out.wide_axis = glm::dot(axis, axis) > 1e-9f ? glm::normalize(axis) : glm::vec2(1, 0);
  out.weight = total;
  return out;
}

}  // namespace

glm::vec3 facet_covariance(const glm::vec3& normal, const glm::vec3& fibre, const Lobes& lobes) {
  const Axes axes = axes_over(normal);
  const float x = glm::dot(fibre, axes.t), y = glm::dot(fibre, axes.b);
  const float length2 = std::max(x * x + y * y, 1e-12f);
  const float along2 = lobes.along_width * lobes.along_width / length2;
  const float across2 = lobes.across_width * lobes.across_width / length2;
  return {along2 * x * x + across2 * y * y, (along2 - across2) * x * y, along2 * y * y + across2 * x * x};
}

FacetAlphas facet_alphas(const glm::vec3& c) {
  const auto alpha = [](float variance) { return std::min(std::sqrt(2.0f * std::max(variance, 0.0f)), 1.0f); };
  const float middle = 0.5f * (c.x + c.z), half_gap = 0.5f * (c.x - c.z);
  const float root = std::sqrt(half_gap * half_gap + c.y * c.y);
  const float angle = root > 1e-9f ? 0.5f * std::atan2(c.y, half_gap) : 0.0f;
  return {{alpha(middle + root), alpha(middle - root)}, {std::cos(angle), std::sin(angle)}};
}

float spread_share(float footprint_mm, float spacing_mm) {
  return std::clamp(0.5f * footprint_mm / std::max(spacing_mm, 1e-6f), 0.0f, 1.0f);
}

EngineTexels engine_texels(const Cloth& cloth, const Maps& maps, float share) {
  EngineTexels out;
  if (cloth.ends.empty() || cloth.picks.empty() || maps.coverage.width < 1 || maps.coverage.height < 1) return out;
  out.spread = spread_of(maps) * share;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const glm::ivec2 at = place(maps, i, j, kSide);
      const EngineTexel t = texel_of(cloth, maps, out.spread, at.x, at.y);
      if (t.weight > 0) out.texels.push_back(t);
    }
  }
  if (!out.texels.empty()) out.texels.push_back(mean_of(out.texels));
  return out;
}

EngineFit fit_engine(std::span<const EngineTexel> texels, const Cloth& cloth, const ClothResponse& response,
                     const EngineModel& model) {
  if (texels.empty()) return {};
  const Problem problem = problem_of(cloth, response);
  EngineFit best;
  best.error = std::numeric_limits<float>::infinity();
  for (const float roughness : kSheenRoughness) {
    const EngineFit fit = fit_with(texels, problem, model, roughness);
    if (fit.error < best.error) best = fit;
    if (model.sheen == formulas::kSheenNone || model.sheen == formulas::kSheenDisney ||
        model.sheen == formulas::kSheenInverseGgx)
      break;  // their roughness is not the sheen's own
  }
  return best;
}

std::vector<EngineCheck> check_engine(std::span<const EngineTexel> texels, const Cloth& cloth,
                                      const ClothResponse& response, const EngineModel& model, const EngineFit& fit) {
  constexpr size_t kLight = 6 * kLightAzimuths + kLightAzimuths / 4 * 3;  // from -v, which is the top of an image
  const std::array<formulas::YarnLobes, 2> yarns = mean_yarns(cloth, response);
  const std::array<glm::vec3, kResponseViews> w = response_views();
  Problem problem{{}, {{kLight, w[view_of_light(kLight)], 1}}, {}};
  for (size_t k = 3; k < static_cast<size_t>(kResponseElevations); ++k) {
    for (size_t a = 0; a < (k == 7 ? 1 : size_t{kViewAzimuths}); a += kViewAzimuths / 4) {
      const size_t view = k * kViewAzimuths + a;
      problem.views.push_back({view, w[view], 1});
      problem.pairs.push_back({problem.views.size() - 1, 0, cloth_answer(yarns, response, view, kLight), 1, 1});
    }
  }
  const std::vector<Sent> sent = sent_by(texels, problem, fit, model.sheen);
  std::vector<EngineCheck> out;
  for (size_t i = 0; i < sent.size(); ++i) {
    const glm::vec3 engine =
        sent[i].body * fit.base + glm::vec3(sent[i].gloss * fit.specular) + sent[i].fuzz * fit.sheen;
    out.push_back({problem.views[i].w, problem.lights[0].w, problem.pairs[i].wanted, engine});
  }
  return out;
}

}  // namespace weftlight::light
