// Linear least squares over pairs of views and lights, relative to the reflected light and the mean of the view, and
// over those means. The widths of the lobe and the sheen's roughness are found by descent. Coupling between the parts
// (Fresnel, and what the sheen leaves) is taken from the previous round.

#include "light/engine_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "light/yarn_lobes.h"

namespace weftlight::light {

using cloth::Linear;

namespace {

using formulas::EngineMaterial;
using formulas::EngineParts;

constexpr int kRounds = 3;  // rounds of least squares, for the coupling between the parts
constexpr float kMinBase = 0.25f;
constexpr float kMaxScale = 4.0f;                            // of base colour and sheen
constexpr size_t kUnknowns = 6;                              // base r, g, b, f0, f90, sheen
constexpr float kFirstStep = 0.7f, kLastStep = 0.06f;        // of the descent, in logarithms
constexpr float kNarrowestLobe = 0.02f, kWidestLobe = 4.0f;  // factors of the variances, at footprint weight 1
// From here the descent finds the better of the two minima of cotton denim and cotton twill, which from 1 it does not.
constexpr float kFirstLobe = 0.15f;
constexpr float kSmoothestSheen = 0.2f, kRoughestSheen = 1.0f;
constexpr float kHighlightWeight =
    0.2f;  // weight of the pair itself in the scale of an error; the rest is the mean of the view
constexpr float kMeanPull = 4.0f;  // weight of the mean of a view, over that of all its pairs
constexpr float kHue = 0.05f;      // pull of the base colour factors to their mean: a dark channel is poorly determined
constexpr float kSteepView = 0.26f, kSteepViewWeight = 0.3f;  // weight of views past 75 degrees

glm::vec3 vec(const Linear& c) { return {c.r, c.g, c.b}; }

/// Mean yarns of warp and weft, as in method `cloth`.
std::array<formulas::YarnLobes, 2> mean_yarns(const Cloth& cloth, const ClothResponse& response) {
  std::array<formulas::YarnLobes, 2> out;
  for (size_t s = 0; s < 2; ++s) {
    out[s] = formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), vec(response.systems[s].colour));
  }
  return out;
}

/// Radiance of the cloth from light node to view node, for unit irradiance at normal incidence.
glm::vec3 cloth_radiance(const std::array<formulas::YarnLobes, 2>& yarns, const ClothResponse& response, size_t view,
                         size_t light) {
  static const std::array<glm::vec3, kResponseViews> w = response_views();
  const glm::vec3 v = w[view], l = w[view_of_light(light)];
  const glm::vec2 h = formulas::half_slopes(l, v);
  glm::vec3 sum(0);
  for (size_t s = 0; s < 2; ++s) {
    const SystemResponse& system = response.systems[s];
    const float* reflected = &system.reflected[4 * (view * kResponseLights + light)];
    const glm::vec2 slopes{density_at(system.slopes[0], h.x), density_at(system.slopes[1], h.y)};
    sum += formulas::system_radiance(yarns[s], {reflected[0], reflected[1], reflected[2], reflected[3]}, slopes,
                                     system.fraction, glm::vec4(0), l, v)
               .key;
  }
  return sum;
}

/// A node of the grid of views or lights, and its fraction of the hemisphere.
struct Node {
  size_t index = 0;  // view or light
  glm::vec3 w{0, 0, 1};
  float fraction = 0;
};

/// Nodes down to elevation `lowest`, `azimuths` of the `of` in each ring.
std::vector<Node> nodes(size_t lowest, size_t azimuths, size_t of) {
  static const std::array<glm::vec3, kResponseViews> w = response_views();
  std::vector<Node> out;
  const auto edge = [](size_t k) {
    return k >= 7 ? 1.0f : 0.5f * (w[k * kViewAzimuths].z + w[(k + 1) * kViewAzimuths].z);
  };
  for (size_t k = lowest; k < static_cast<size_t>(kResponseElevations); ++k) {
    const size_t ring = k == 7 ? 1 : azimuths;
    const float below = k == 0 ? 0.0f : edge(k - 1), fraction = (edge(k) - below) / static_cast<float>(ring);
    for (size_t a = 0; a < ring; ++a) {
      const size_t at = a * (of / azimuths);
      out.push_back({k * of + at, w[k * kViewAzimuths + at * (kViewAzimuths / of)], fraction});
    }
  }
  return out;
}

struct Pair {
  size_t view = 0, light = 0;  // among the nodes
  glm::vec3 wanted{0};
  float weight = 0;  // of the square: over the reflected light and the mean of the view, so that no highlight dominates
  float fraction = 0;
};

struct Problem {
  std::vector<Node> views, lights;
  std::vector<Pair> pairs;
};

Problem problem_between(const Cloth& cloth, const ClothResponse& response, std::vector<Node> views,
                        std::vector<Node> lights) {
  Problem out{std::move(views), std::move(lights), {}};
  const std::array<formulas::YarnLobes, 2> yarns = mean_yarns(cloth, response);
  for (size_t v = 0; v < out.views.size(); ++v) {
    const size_t first = out.pairs.size();
    float sum = 0, total = 0;
    for (size_t l = 0; l < out.lights.size(); ++l) {
      const glm::vec3 wanted = cloth_radiance(yarns, response, out.views[v].index, out.lights[l].index);
      const float fraction = out.views[v].fraction * out.lights[l].fraction;
      out.pairs.push_back({v, l, wanted, 0, fraction});
      sum += fraction * (wanted.r + wanted.g + wanted.b), total += fraction;
    }
    const float mean = std::max(sum / std::max(total, 1e-9f), 1e-4f);
    for (size_t i = first; i < out.pairs.size(); ++i) {
      const glm::vec3& wanted = out.pairs[i].wanted;
      const float size = (1 - kHighlightWeight) * mean + kHighlightWeight * (wanted.r + wanted.g + wanted.b);
      out.pairs[i].weight =
          out.pairs[i].fraction / (size * size) * (out.views[v].w.z < kSteepView ? kSteepViewWeight : 1.0f);
    }
  }
  return out;
}

Problem problem_of(const Cloth& cloth, const ClothResponse& response, size_t lowest, size_t views_around,
                   size_t lights_around) {
  return problem_between(cloth, response, nodes(lowest, views_around, kViewAzimuths),
                         nodes(lowest, lights_around, kLightAzimuths));
}

constexpr size_t kLowestScored = 3;  // elevation of 11 degrees, 79 from the normal

/// The nodes of a grid in a plane, with the one at the normal.
std::vector<Node> nodes_in(EnginePlane plane, size_t of) {
  constexpr float kInPlane = 1e-3f;
  std::vector<Node> out = nodes(kLowestScored, 4, of);
  std::erase_if(out,
                [plane](const Node& n) { return std::abs(plane == EnginePlane::kWarp ? n.w.x : n.w.y) > kInPlane; });
  return out;
}

/// A pixel of the engine, with its lobe.
struct Shaded {
  EngineMaterial material;
  formulas::LobeFrame frame;
  float weight = 0;
};

std::vector<Shaded> shaded(const EngineTexels& texels, const EngineModel& model, const EngineFit& fit) {
  std::vector<Shaded> out;
  float total = 1e-9f;
  for (const EngineTexel& t : texels.texels) total += t.weight;
  for (const EngineTexel& t : texels.texels) {
    const EngineLobe lobe = engine_lobe(t, fit.lobe, texels.footprint_weight);
    EngineMaterial m = t.material;
    m.base = glm::min(m.base * fit.base, glm::vec3(1));
    m.sheen = glm::min(m.sheen * fit.sheen, glm::vec3(1));
    m.sheen_roughness = fit.sheen_roughness, m.f0 = fit.f0, m.f90 = fit.f90;
    m.alpha = model.anisotropic ? lobe.alpha() : glm::vec2(std::sqrt(lobe.alpha().x * lobe.alpha().y));
    out.push_back({m, formulas::lobe_frame(t.normal, {lobe.axis, 0}), t.weight / total});
  }
  return out;
}

/// Radiance of the texels for a pair, by part, for factors of one.
struct PairRadiance {
  glm::vec3 body{0}, fuzz{0};
  glm::vec2 gloss{0};
};

std::vector<PairRadiance> texel_radiance(const EngineTexels& texels, const Problem& problem, const EngineModel& model,
                                         const EngineFit& fit) {
  std::vector<PairRadiance> out(problem.pairs.size());
  std::vector<glm::vec3> wi(problem.lights.size()), wo(problem.views.size());
  for (const Shaded& t : shaded(texels, model, fit)) {
    for (size_t i = 0; i < wi.size(); ++i) wi[i] = formulas::lobe_local(t.frame, problem.lights[i].w);
    for (size_t i = 0; i < wo.size(); ++i) wo[i] = formulas::lobe_local(t.frame, problem.views[i].w);
    for (size_t i = 0; i < out.size(); ++i) {
      const Pair& pair = problem.pairs[i];
      const EngineParts p = formulas::engine_parts(t.material, model.sheen, wi[pair.light], wo[pair.view]);
      out[i].body += p.body * (p.kept * t.weight) / fit.base;
      out[i].fuzz += p.fuzz * (t.weight / std::max(fit.sheen, 1e-3f));
      out[i].gloss += p.gloss * (p.kept * t.weight);
    }
  }
  return out;
}

glm::vec3 whole(const PairRadiance& radiance, const EngineFit& fit) {
  return radiance.body * fit.base + glm::vec3(glm::dot(radiance.gloss, glm::vec2(fit.f0, fit.f90))) +
         radiance.fuzz * fit.sheen;
}

/// Bounded least squares by coordinates; an unknown whose bounds meet stays as it is.
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
  void solve(Unknowns& x, const Unknowns& least, const Unknowns& most) const {
    const double pull = static_cast<double>(kHue) * std::max({a[0][0], a[1][1], a[2][2]});
    for (int round = 0; round < 200; ++round) {
      const double mean = static_cast<double>(x[0] + x[1] + x[2]) / 3;
      for (size_t i = 0; i < kUnknowns; ++i) {
        double rest = b[i], own = a[i][i];
        // A channel that the threads have nothing of tells nothing at all, and is pulled all the same.
        if (i < 3) rest += pull * mean, own += pull;
        if (own <= 1e-12) continue;
        for (size_t j = 0; j < kUnknowns; ++j) rest -= j == i ? 0.0 : a[i][j] * static_cast<double>(x[j]);
        x[i] = std::clamp(static_cast<float>(rest / own), least[i], most[i]);
        if (i == kF90)
          x[i] = std::max(x[i], std::min(x[kF0], most[i]));  // Fresnel reflectance does not fall towards grazing
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
  static constexpr size_t kF0 = 3, kF90 = 4;
};

/// Coefficients of the unknowns for one pair and channel.
Unknowns row_of(const PairRadiance& radiance, int channel) {
  Unknowns row{0, 0, 0, radiance.gloss.x, radiance.gloss.y, radiance.fuzz[channel]};
  row[static_cast<size_t>(channel)] = radiance.body[channel];
  return row;
}

/// The mean over the pairs of a view, as one more equation: errors that cancel over lights still conserve the energy
/// of the cloth.
void add_mean(Normal& to, std::span<const Pair> pairs, std::span<const PairRadiance> radiance, int channel) {
  Unknowns sum{};
  float wanted = 0, total = 1e-9f, weights = 0;
  for (size_t i = 0; i < pairs.size(); ++i) {
    const Unknowns row = row_of(radiance[i], channel);
    for (size_t k = 0; k < kUnknowns; ++k) sum[k] += pairs[i].fraction * row[k];
    wanted += pairs[i].fraction * pairs[i].wanted[channel], total += pairs[i].fraction, weights += pairs[i].weight;
  }
  for (float& x : sum) x /= total;
  to.add(sum, wanted / total, kMeanPull * weights);
}

Normal normal_of(const Problem& problem, const std::vector<PairRadiance>& radiance) {
  Normal out;
  const size_t lights = problem.lights.size();
  for (int c = 0; c < 3; ++c) {
    for (size_t i = 0; i < radiance.size(); ++i)
      out.add(row_of(radiance[i], c), problem.pairs[i].wanted[c], problem.pairs[i].weight);
    for (size_t first = 0; first < radiance.size(); first += lights)
      add_mean(out, std::span(problem.pairs).subspan(first, lights), std::span(radiance).subspan(first, lights), c);
  }
  return out;
}

/// Bounds of the unknowns: base colour and sheen up to white, and what the model can do.
struct Bounds {
  Unknowns least{}, most{};
};
Bounds bounds_of(const EngineTexels& texels, const EngineModel& model) {
  float most_sheen = 1e-3f;
  for (const EngineTexel& t : texels.texels)
    most_sheen = std::max({most_sheen, t.material.sheen.r, t.material.sheen.g, t.material.sheen.b});
  const bool fixed = model.most_f0 <= formulas::kEngineF0,
             plain = model.sheen == formulas::kSheenNone || model.sheen == formulas::kSheenNoneDisney;
  return {{kMinBase, kMinBase, kMinBase, fixed ? formulas::kEngineF0 : 0, model.grazing ? 0.0f : 1.0f, 0},
          {kMaxScale, kMaxScale, kMaxScale, model.most_f0, 1, plain ? 0 : std::min(kMaxScale, 1 / most_sheen)}};
}

/// Best factors for the given lobe widths and sheen roughness.
void solve(EngineFit& fit, const EngineTexels& texels, const Problem& problem, const EngineModel& model,
           const Bounds& bounds, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const Normal normal = normal_of(problem, texel_radiance(texels, problem, model, fit));
    Unknowns x{fit.base.r, fit.base.g, fit.base.b, fit.f0, fit.f90, fit.sheen};
    normal.solve(x, bounds.least, bounds.most);
    fit.base = {x[0], x[1], x[2]}, fit.f0 = x[3], fit.f90 = x[4], fit.sheen = x[5];
    fit.error = normal.error(x);
  }
}

/// Searched parameters: the lobe's two factors and the sheen's roughness.
float* searched(EngineFit& fit, int which) {
  return which == 0 ? &fit.lobe.x : which == 1 ? &fit.lobe.y : &fit.sheen_roughness;
}

/// Only these models have a sheen roughness of their own.
bool own_roughness(int sheen) { return sheen == formulas::kSheenCharlie || sheen == formulas::kSheenZeltner; }

}  // namespace

EngineFit fit_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                     const EngineModel& model) {
  if (texels.texels.empty()) return {};
  const Problem problem = problem_of(cloth, response, 3, 8, 8);
  const Bounds bounds = bounds_of(texels, model);
  const float narrowest = std::pow(kNarrowestLobe, texels.footprint_weight),
              widest = std::pow(kWidestLobe, texels.footprint_weight);
  EngineFit best;
  best.lobe = glm::vec2(std::clamp(kFirstLobe, narrowest, widest));
  if (model.sheen == formulas::kSheenNone) best.sheen = 0;
  solve(best, texels, problem, model, bounds, kRounds);
  for (int halved = 0; std::ldexp(kFirstStep, -halved) > kLastStep; ++halved) {
    const float step = std::ldexp(kFirstStep, -halved);
    for (bool better = true; better;) {
      better = false;
      const bool fuzzy = own_roughness(model.sheen) && (best.sheen > 0 || step == kFirstStep);
      for (int which = 0; which < (fuzzy ? 3 : 2); ++which) {
        for (const float by : {-step, step}) {
          EngineFit other = best;
          float* const at = searched(other, which);
          const float before = *at;
          *at = which < 2 ? std::clamp(*at * std::exp(2 * by), narrowest, widest)
                          : std::clamp(*at * std::exp(by), kSmoothestSheen, kRoughestSheen);
          if (*at == before) continue;
          solve(other, texels, problem, model, bounds, 1);
          if (other.error >= best.error) continue;
          best = other, better = true;
          break;
        }
      }
    }
  }
  solve(best, texels, problem, model, bounds, kRounds);
  return best;
}

std::vector<EngineCheck> check_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit) {
  // From -v, the top of an image, and from u, its left.
  constexpr std::array<size_t, 2> kLights{6 * kLightAzimuths + kLightAzimuths / 4 * 3, 6 * kLightAzimuths};
  const std::array<formulas::YarnLobes, 2> yarns = mean_yarns(cloth, response);
  const std::array<glm::vec3, kResponseViews> w = response_views();
  Problem problem;
  for (size_t k = 3; k < static_cast<size_t>(kResponseElevations); ++k) {
    for (size_t a = 0; a < (k == 7 ? 1 : size_t{kViewAzimuths}); a += kViewAzimuths / 4)
      problem.views.push_back({k * kViewAzimuths + a, w[k * kViewAzimuths + a], 1});
  }
  for (size_t l = 0; l < kLights.size(); ++l) {
    problem.lights.push_back({kLights[l], w[view_of_light(kLights[l])], 1});
    for (size_t v = 0; v < problem.views.size(); ++v)
      problem.pairs.push_back({v, l, cloth_radiance(yarns, response, problem.views[v].index, kLights[l]), 1, 1});
  }
  const std::vector<PairRadiance> radiance = texel_radiance(texels, problem, model, fit);
  std::vector<EngineCheck> out;
  for (size_t i = 0; i < radiance.size(); ++i) {
    const Pair& pair = problem.pairs[i];
    out.push_back({problem.views[pair.view].w, problem.lights[pair.light].w, pair.wanted, whole(radiance[i], fit)});
  }
  return out;
}

namespace {

std::vector<EngineScore> scores_of(const EngineTexels& texels, const Problem& problem, const EngineModel& model,
                                   const EngineFit& fit) {
  constexpr glm::vec3 kLuminance{0.2126f, 0.7152f, 0.0722f};
  const std::vector<PairRadiance> radiance = texel_radiance(texels, problem, model, fit);
  std::vector<EngineScore> out;
  for (size_t k = kResponseElevations; k-- > kLowestScored;) {
    float engine = 0, wanted = 1e-9f, square = 0, squares = 1e-12f;
    for (size_t i = 0; i < radiance.size(); ++i) {
      const Pair& pair = problem.pairs[i];
      if (problem.views[pair.view].index / kViewAzimuths != k) continue;
      const float a = glm::dot(whole(radiance[i], fit), kLuminance), b = glm::dot(pair.wanted, kLuminance);
      engine += pair.fraction * a, wanted += pair.fraction * b;
      square += pair.fraction * (a - b) * (a - b), squares += pair.fraction * b * b;
    }
    const float z = response_views()[k * kViewAzimuths].z;
    out.push_back({std::acos(std::min(z, 1.0f)) * 57.29578f, engine / wanted, std::sqrt(square / squares)});
  }
  return out;
}

}  // namespace

std::vector<EngineScore> score_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit) {
  return scores_of(texels, problem_of(cloth, response, kLowestScored, kViewAzimuths / 2, kLightAzimuths), model, fit);
}

std::vector<EngineScore> score_plane(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                     const EngineModel& model, const EngineFit& fit, EnginePlane plane) {
  return scores_of(texels,
                   problem_between(cloth, response, nodes_in(plane, kViewAzimuths), nodes_in(plane, kLightAzimuths)),
                   model, fit);
}

}  // namespace weftlight::light
