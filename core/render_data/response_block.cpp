#include "render_data/response_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "base/loops.h"

namespace weftlight::render_data {

using base::for_each_job;
using light::ClothResponse, light::SystemResponse, light::kResponseLights, light::kResponseViews, light::kSlopeBins,
    light::kTransmissionElevations, light::kTransmissionLights, light::measure_response, light::response_views;

namespace {

using Faces = std::array<ClothResponse, 2>;

/// One elevation of lights for one view, on one side of the cloth.
struct LightRow {
  const std::vector<float>& values;  // [view][light]
  size_t view, elevation;
  int azimuths;
  size_t lights;

  /// Appends `width` texels; azimuths wrap around.
  void append(std::vector<glm::vec4>& out, int width) const {
    for (int a = 0; a < width; ++a) {
      const size_t light = elevation * static_cast<size_t>(azimuths) + static_cast<size_t>(a % azimuths);
      out.push_back(glm::make_vec4(&values[4 * (view * lights + light)]));
    }
  }
};

void append_view(std::vector<glm::vec4>& out, const Faces& faces, size_t view) {
  for (const ClothResponse& face : faces) {
    for (const SystemResponse& system : face.systems) {
      for (size_t e = 0; e < kResponseElevations; ++e) {
        LightRow{system.reflected, view, e, kLightAzimuths, kResponseLights}.append(out, kReflectionWidth);
        LightRow{system.gradient, view, e, kLightAzimuths, kResponseLights}.append(out,
                                                                                   kResponseWidth - kReflectionWidth);
      }
    }
  }
  for (const auto table : {&SystemResponse::transmitted, &SystemResponse::transmission_gradient}) {
    for (const ClothResponse& face : faces) {
      for (const SystemResponse& system : face.systems) {
        for (size_t e = 0; e < kTransmissionElevations; ++e)
          LightRow{system.*table, view, e, kTransmissionAzimuths, kTransmissionLights}.append(out, kResponseWidth);
      }
    }
  }
}

std::vector<glm::vec4> reflected_of(const Faces& faces) {
  std::vector<glm::vec4> out;
  out.reserve(size_t{kResponseWidth} * kResponseHeight * kResponseViews);
  for (size_t view = 0; view < kResponseViews; ++view) append_view(out, faces, view);
  return out;
}

std::vector<float> slopes_of(const Faces& faces) {
  std::vector<float> out;
  for (const ClothResponse& face : faces) {
    for (const SystemResponse& system : face.systems) {
      out.insert(out.end(), system.slopes.begin(), system.slopes.end());
      out.resize(out.size() + kSlopeBins * kSlopeBins - system.slopes.size());  // a system without threads
    }
  }
  return out;
}

/// Mean directions of the reflected sky light, by body and mirrored, each along the view and up.
glm::vec4 sky_from(const ClothResponse& face, size_t view, const glm::vec3& towards) {
  const glm::vec2 along = glm::vec2(towards) / std::max(glm::length(glm::vec2(towards)), 1e-6f);
  const auto [diffuse, glossy] = face.sky_from[view];
  return {glm::dot(glm::vec2(diffuse), along), diffuse.z, glm::dot(glm::vec2(glossy), along), glossy.z};
}

std::vector<glm::vec4> views_of(const Faces& faces) {
  const auto views = response_views();
  std::vector<glm::vec4> out;
  for (const ClothResponse& face : faces) {
    for (int table = 0; table < VIEW_TABLES / 2; ++table) {
      for (size_t e = 0; e < kResponseElevations; ++e) {
        for (size_t a = 0; a < kViewTableWidth; ++a) {
          const size_t view = e * kViewAzimuths + a % kViewAzimuths;
          if (table == 0)
            out.push_back({face.systems[0].seen[view], face.visible_rise[view], face.systems[0].height_mm[view],
                           face.systems[1].height_mm[view]});
          else if (table == 3) out.push_back(sky_from(face, view, views[view]));
          else if (table == 4) out.push_back(face.near_sky[view]);
          else if (table == 5) out.push_back(face.hidden[view]);
          else out.push_back(glm::make_vec4(&face.systems[static_cast<size_t>(table - 1)].sky[4 * view]));
        }
      }
    }
  }
  return out;
}

/// Contrast of a level: relative RMS of its colours about their mean, or of its systems' coverage times their possible
/// difference in shine. The blocks of a damask in one colour differ only by the system that shines towards the eye.
float contrast(const PackedTexture& color, int level) {
  // Reflected light of ends and picks of one yarn differs by this much and more.
  constexpr double kSheen = 0.25;
  const int w = color.level_width(level), h = color.level_height(level);
  std::array<double, 4> sum{}, square{};
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const auto warp = color.texel(level, 0, x, y), weft = color.texel(level, 1, x, y);
      std::array<double, 4> v{};
      for (size_t c = 0; c < 3; ++c) v[c] = std::pow(warp[c] / 255.0, 2.2) + std::pow(weft[c] / 255.0, 2.2);
      v[3] = kSheen * warp[3] / std::max(1.0, warp[3] + static_cast<double>(weft[3]));
      for (size_t c = 0; c < 4; ++c) sum[c] += v[c], square[c] += v[c] * v[c];
    }
  }
  const double n = static_cast<double>(w) * h;
  const auto spread2 = [&](size_t c) { return square[c] / n - sum[c] * sum[c] / n / n; };
  double variance = 0, mean2 = 0;
  for (size_t c = 0; c < 3; ++c) variance += spread2(c), mean2 += sum[c] * sum[c] / n / n;
  return static_cast<float>(std::sqrt(std::max({variance / std::max(mean2, 1e-9), spread2(3), 0.0})));
}

}  // namespace

void keep_response(interop::ClothData& data, const interop::ClothData& earlier) {
  data.front_sky = earlier.front_sky, data.back_sky = earlier.back_sky;
  data.engine[0] = earlier.engine[0], data.engine[1] = earlier.engine[1];
  for (size_t s = 0; s < 4; ++s) {
    data.systems[s].color = earlier.systems[s].color;
    data.systems[s].fraction = earlier.systems[s].fraction;
    data.systems[s].facets = earlier.systems[s].facets;
  }
}

float even_from_yarns(const PackedFace& face, float width_mm, float spacing_mm) {
  constexpr float kEven = 0.02f;
  const PackedTexture& color = face.textures[static_cast<size_t>(PackedKind::kColor)];
  int level = static_cast<int>(color.levels.size()) - 1;
  while (level > 0 && contrast(color, level - 1) <= kEven) --level;
  // The last level is a single texel and always uniform: a pixel must then cover the period.
  const float texels = static_cast<float>(1 << level) / static_cast<float>(std::max(1, color.width));
  return texels * width_mm / std::max(spacing_mm, 1e-6f);
}

ResponseTables response_tables(interop::ClothData& data, const FaceInput& front, const FaceInput& back, int samples) {
  Faces faces;
  for_each_job(2, [&](int f) {
    const FaceInput& face = f == 0 ? front : back;
    faces[static_cast<size_t>(f)] = measure_response(face.cloth, face.maps, samples);
  });
  data.front_sky = faces[0].sky, data.back_sky = faces[1].sky;
  for (size_t f = 0; f < 2; ++f) {
    for (size_t s = 0; s < 2; ++s) {
      const SystemResponse& system = faces[f].systems[s];
      data.systems[f * 2 + s].color = {system.colour.r, system.colour.g, system.colour.b, 0};
      data.systems[f * 2 + s].fraction = system.fraction;
      data.systems[f * 2 + s].facets = glm::make_vec4(system.facets.data());
    }
  }
  return {reflected_of(faces), slopes_of(faces), views_of(faces)};
}

}  // namespace weftlight::render_data
