// Pairs are computed side by side by vectors, each with its directions in the frame of the pixel: to compute these anew
// costs less than to look them up.

#include "light/engine_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/loops.h"
#include "platform/vectors.h"

namespace weftlight::light {

using base::core_count, base::for_each_job;

namespace {

using formulas::EngineMaterial;
using formulas::EngineParts;

constexpr glm::vec3 kLeastSheen(1e-3f);  // in the equations: at 0 a factor would have none, and stay 0
constexpr size_t kBlock = 64;            // pairs at a time
constexpr size_t kLeastBlocks = 4;       // of a core

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
    m.sheen = glm::min(m.sheen * glm::max(fit.sheen, kLeastSheen), glm::vec3(1));
    m.sheen_roughness = fit.sheen_roughness, m.f0 = fit.f0, m.f90 = fit.f90;
    m.alpha = model.anisotropic ? lobe.alpha() : glm::vec2(std::sqrt(lobe.alpha().x * lobe.alpha().y));
    out.push_back({m, formulas::lobe_frame(flattened(t.normal, fit.relief), {lobe.axis, 0}), t.weight / total});
  }
  return out;
}

using Values = std::array<float, kBlock>;

/// Pairs by component.
struct PairBlock {
  std::array<Values, 3> light, view;
  Values shine, edge;  // factors of the reflectance at normal view, and at grazing view
};
struct RadianceBlock {
  std::array<Values, 3> body{}, gloss{}, grazing{}, fuzz{};
};

/// Pairs from `first` on; after the last, that one again.
PairBlock pair_block(const EngineDirections& directions, const EngineModel& model, const EngineFit& fit, size_t first) {
  PairBlock out;
  for (size_t i = 0; i < kBlock; ++i) {
    const EnginePair& pair = directions.pairs[std::min(first + i, directions.pairs.size() - 1)];
    const glm::vec3 &light = directions.lights[pair.light], &view = directions.views[pair.view];
    for (int c = 0; c < 3; ++c)
      out.light[static_cast<size_t>(c)][i] = light[c], out.view[static_cast<size_t>(c)][i] = view[c];
    out.shine[i] = fit.tint.shine_at(view) * (model.light_tinted ? fit.tint.shine_at(light) : 1);
    out.edge[i] = model.grazing ? out.shine[i] : 1;
  }
  return out;
}

/// kSheen: the model's, as a constant, so that the loop has no branch.
template <int kSheen>
void add_pixel(RadianceBlock& __restrict out, const PairBlock& __restrict pairs, const Shaded& pixel,
               const glm::vec3& over_base, const glm::vec3& over_sheen) {
  const Shaded t = pixel;  // local, so that the output cannot be part of it
  const glm::vec3 base = over_base, sheen = over_sheen;
  for (size_t i = 0; i < kBlock; ++i) {
    const float shine = pairs.shine[i], edge = pairs.edge[i];
    EngineMaterial m = t.material;
    m.f0 = t.material.f0 * shine;
    m.f90 = t.material.f90 * edge;
    const glm::vec3 light(pairs.light[0][i], pairs.light[1][i], pairs.light[2][i]);
    const glm::vec3 view(pairs.view[0][i], pairs.view[1][i], pairs.view[2][i]);
    const EngineParts p =
        formulas::engine_parts(m, kSheen, formulas::lobe_local(t.frame, light), formulas::lobe_local(t.frame, view));
    const glm::vec3 body = p.body * (p.kept * t.weight) / base, fuzz = p.fuzz * t.weight / sheen,
                    gloss = p.gloss * (shine * p.kept * t.weight), grazing = p.grazing * (edge * p.kept * t.weight);
    out.body[0][i] += body.x, out.body[1][i] += body.y, out.body[2][i] += body.z;
    out.gloss[0][i] += gloss.x, out.gloss[1][i] += gloss.y, out.gloss[2][i] += gloss.z;
    out.grazing[0][i] += grazing.x, out.grazing[1][i] += grazing.y, out.grazing[2][i] += grazing.z;
    out.fuzz[0][i] += fuzz.x, out.fuzz[1][i] += fuzz.y, out.fuzz[2][i] += fuzz.z;
  }
}

template <int kSheen>
void add_pixels(RadianceBlock& out, const PairBlock& pairs, const std::vector<Shaded>& pixels, const EngineFit& fit) {
  const glm::vec3 sheen = glm::max(fit.sheen, kLeastSheen);
  platform::with_widest_vectors([&] {
    for (const Shaded& t : pixels) add_pixel<kSheen>(out, pairs, t, fit.base, sheen);
  });
}

using AddPixels = void (*)(RadianceBlock&, const PairBlock&, const std::vector<Shaded>&, const EngineFit&);

AddPixels adder_for(int sheen) {
  switch (sheen) {
    case formulas::kSheenCharlie:
      return add_pixels<formulas::kSheenCharlie>;
    case formulas::kSheenZeltner:
      return add_pixels<formulas::kSheenZeltner>;
    case formulas::kSheenInverseGgx:
      return add_pixels<formulas::kSheenInverseGgx>;
    case formulas::kSheenDisney:
      return add_pixels<formulas::kSheenDisney>;
    case formulas::kSheenNoneDisney:
      return add_pixels<formulas::kSheenNoneDisney>;
    case formulas::kSheenNoneAdded:
      return add_pixels<formulas::kSheenNoneAdded>;
    default:
      return add_pixels<formulas::kSheenNone>;
  }
}

glm::vec3 at(const std::array<Values, 3>& of, size_t i) { return {of[0][i], of[1][i], of[2][i]}; }

}  // namespace

std::vector<PairRadiance> texel_radiance(const EngineTexels& texels, const EngineDirections& directions,
                                         const EngineModel& model, const EngineFit& fit) {
  std::vector<PairRadiance> out(directions.pairs.size());
  const std::vector<Shaded> pixels = shaded(texels, model, fit);
  const AddPixels add = adder_for(model.sheen);
  // On all cores, each with pairs of its own, to which the pixels are added in order.
  const size_t blocks = (out.size() + kBlock - 1) / kBlock,
               parts = std::min(static_cast<size_t>(core_count()), blocks / kLeastBlocks + 1);
  for_each_job(static_cast<int>(parts), [&](int part) {
    const size_t k = static_cast<size_t>(part);
    for (size_t b = blocks * k / parts; b < blocks * (k + 1) / parts; ++b) {
      RadianceBlock sums;
      add(sums, pair_block(directions, model, fit, b * kBlock), pixels, fit);
      for (size_t i = 0; i < std::min(kBlock, out.size() - b * kBlock); ++i)
        out[b * kBlock + i] = {at(sums.body, i), at(sums.gloss, i), at(sums.grazing, i), at(sums.fuzz, i)};
    }
  });
  for (size_t i = 0; i < out.size(); ++i) {
    out[i].body *= fit.tint.base_at(directions.views[directions.pairs[i].view]);
    if (model.light_tinted) out[i].body *= fit.tint.base_at(directions.lights[directions.pairs[i].light]);
  }
  return out;
}

}  // namespace weftlight::light
