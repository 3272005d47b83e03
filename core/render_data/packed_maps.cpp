// Packing and prefiltering of the maps. Every level is made from the stored texels of the one below, so that a
// patch needs nothing but its own rectangle and gives the same bits as the whole.
// Colour is averaged premultiplied in linear light; since alpha is the plain average of coverage and is
// blended, not tested, coverage is kept through the mips (the loss that Castano, "Computing Alpha Mipmaps",
// 2010, repairs cannot arise). Normals are kept as first and second moments per thread system, since a woven
// distribution has two peaks; horizons as mean and spread per azimuth.

#include "render_data/packed_maps.h"

#include <cmath>

#include "base/loops.h"
#include "cloth/srgb_table.h"

namespace weftlight::render_data {

using base::for_each_job;
using cloth::Linear, cloth::Plane, cloth::Slope, cloth::SrgbTable, cloth::shadow_map;

namespace {

uint8_t unorm(float v) { return static_cast<uint8_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f); }
uint8_t snorm(float v) {
  return static_cast<uint8_t>(static_cast<int8_t>(std::lround(std::clamp(v, -1.0f, 1.0f) * 127.0f)));
}
/// A quarter, rounding halves to even: rounding up would add an eighth of a step at every level.
uint8_t quarter(int sum) { return static_cast<uint8_t>((sum + 1 + ((sum >> 2) & 1)) / 4); }

void set_rgba(uint8_t* to, uint8_t r, uint8_t g, uint8_t b, uint8_t a) { to[0] = r, to[1] = g, to[2] = b, to[3] = a; }

void pack_surface(PackedFace& face, const Maps& maps, const TexelRect& r) {
  const SrgbTable& srgb = SrgbTable::get();
  PackedTexture& color = face.textures[static_cast<size_t>(PackedKind::kColor)];
  PackedTexture& relief = face.textures[static_cast<size_t>(PackedKind::kRelief)];
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      const int system = maps.system.at(x, y) ? 1 : 0;
      const float w = std::clamp(maps.coverage.at(x, y), 0.0f, 1.0f);
      const float shade = w * maps.groove.at(x, y);
      const Linear& c = maps.colour.at(x, y);
      const Slope& s = maps.slope.at(x, y);
      const float z2 = 1 / (1.0f + s.x * s.x + s.y * s.y), scale = w * std::sqrt(z2);
      set_rgba(color.texel(0, system, x, y), srgb.encoded_byte(c.r * shade), srgb.encoded_byte(c.g * shade),
               srgb.encoded_byte(c.b * shade), unorm(w));
      set_rgba(color.texel(0, 1 - system, x, y), 0, 0, 0, 0);
      set_rgba(relief.texel(0, system, x, y), snorm(s.x * scale), snorm(s.y * scale), snorm(w * s.x * s.x * z2),
               snorm(w * s.y * s.y * z2));
      set_rgba(relief.texel(0, 1 - system, x, y), 0, 0, 0, 0);
    }
  }
}

/// The four texels of the finer level under one texel of `level`.
struct Below {
  std::array<const uint8_t*, 4> at;
};
Below below(const PackedTexture& t, int level, int layer, int x, int y) {
  const int w = t.level_width(level - 1), h = t.level_height(level - 1);
  const int x0 = std::min(2 * x, w - 1), x1 = std::min(2 * x + 1, w - 1);
  const int y0 = std::min(2 * y, h - 1), y1 = std::min(2 * y + 1, h - 1);
  return {{t.texel(level - 1, layer, x0, y0), t.texel(level - 1, layer, x1, y0), t.texel(level - 1, layer, x0, y1),
           t.texel(level - 1, layer, x1, y1)}};
}

void filter_color(PackedTexture& color, int level, int layer, int x, int y) {
  const SrgbTable& srgb = SrgbTable::get();
  std::array<float, 3> sum{};
  int alpha = 0;
  for (const uint8_t* p : below(color, level, layer, x, y).at) {
    for (size_t c = 0; c < 3; ++c) sum[c] += srgb.decoded(p[c]);
    alpha += p[3];
  }
  set_rgba(color.texel(level, layer, x, y), srgb.encoded_byte(sum[0] / 4), srgb.encoded_byte(sum[1] / 4),
           srgb.encoded_byte(sum[2] / 4), quarter(alpha));
}

/// Moments are averaged directly, rounding halves to even as in quarter().
void filter_relief(PackedTexture& relief, int level, int layer, int x, int y) {
  const Below values = below(relief, level, layer, x, y);
  uint8_t* to = relief.texel(level, layer, x, y);
  for (size_t c = 0; c < 4; ++c) {
    int sum = 0;
    for (const uint8_t* p : values.at) sum += static_cast<int8_t>(p[c]);
    to[c] = static_cast<uint8_t>(static_cast<int8_t>(std::nearbyint(0.25f * static_cast<float>(sum))));
  }
}

void filter_horizon(PackedTexture& horizon, int level, int layer, int x, int y) {
  float mean = 0, square = 0;
  for (const uint8_t* p : below(horizon, level, layer, x, y).at) {
    const float m = static_cast<float>(p[0]) / 255.0f, s = static_cast<float>(p[1]) / 510.0f;
    mean += m / 4, square += (m * m + s * s) / 4;
  }
  uint8_t* to = horizon.texel(level, layer, x, y);
  to[0] = unorm(mean);
  to[1] = unorm(2 * std::sqrt(std::max(0.0f, square - mean * mean)));
}

void filter_shadow(PackedTexture& shadow, int level, int layer, int x, int y) {
  int sum = 0;
  for (const uint8_t* p : below(shadow, level, layer, x, y).at) sum += *p;
  *shadow.texel(level, layer, x, y) = quarter(sum);
}

/// Level 0 of the horizon texture covers two by two texels of the maps.
void pack_horizon(PackedTexture& horizon, const Maps& maps, const TexelRect& r) {
  const int w = maps.height_mm.width, h = maps.height_mm.height;
  for (int layer = 0; layer <= maps.azimuths; ++layer) {
    const Plane<uint8_t>* plane = layer < maps.azimuths ? &maps.horizon[static_cast<size_t>(layer)] : nullptr;
    for (int y = r.y0; y < r.y1; ++y) {
      for (int x = r.x0; x < r.x1; ++x) {
        int sum = 0, square = 0;
        for (int i = 0; i < 4; ++i) {
          const int tx = std::min(2 * x + (i & 1), w - 1), ty = std::min(2 * y + (i >> 1), h - 1);
          const int v = plane ? plane->at(tx, ty) : unorm(maps.occlusion.at(tx, ty));
          sum += v, square += v * v;
        }
        uint8_t* to = horizon.texel(0, layer, x, y);
        to[0] = static_cast<uint8_t>((sum + 2) / 4);
        const float variance = static_cast<float>(4 * square - sum * sum) / 16.0f;
        to[1] = static_cast<uint8_t>(std::min(255.0f, 2 * std::sqrt(variance) + 0.5f));
      }
    }
  }
}

void pack_shadow(PackedTexture& shadow, const Maps& maps, const TexelRect& r) {
  int layer = 0;
  for (const float elevation : kShadowElevations) {
    for (int k = 0; k < kShadowAzimuths; ++k, ++layer) {
      const float azimuth = 2.0f * 3.14159265f * static_cast<float>(k) / kShadowAzimuths;
      const Plane<uint8_t> lit = shadow_map(maps, azimuth, elevation);
      for (int y = r.y0; y < r.y1; ++y) {
        for (int x = r.x0; x < r.x1; ++x) *shadow.texel(0, layer, x, y) = lit.at(x, y) ? 255 : 0;
      }
    }
  }
}

void filter_level(PackedFace& face, PackedKind kind, int level, const TexelRect& r) {
  PackedTexture& t = face.textures[static_cast<size_t>(kind)];
  for (int layer = 0; layer < t.layers; ++layer) {
    for (int y = r.y0; y < r.y1; ++y) {
      for (int x = r.x0; x < r.x1; ++x) {
        switch (kind) {
          case PackedKind::kColor:
            filter_color(t, level, layer, x, y);
            break;
          case PackedKind::kRelief:
            filter_relief(t, level, layer, x, y);
            break;
          case PackedKind::kHorizon:
            filter_horizon(t, level, layer, x, y);
            break;
          case PackedKind::kShadow:
            filter_shadow(t, level, layer, x, y);
            break;
        }
      }
    }
  }
}

TexelRect halved(const TexelRect& r, int width, int height) {
  return {std::min(r.x0 / 2, width - 1), std::min(r.y0 / 2, height - 1), std::min((r.x1 + 1) / 2, width),
          std::min((r.y1 + 1) / 2, height)};
}

PackedTexture make_texture(PackedKind kind, int width, int height, int layers, int channels) {
  PackedTexture t{kind, width, height, layers, channels, {}};
  for (int w = width, h = height;; w = std::max(1, w / 2), h = std::max(1, h / 2)) {
    t.levels.emplace_back(static_cast<size_t>(w) * h * layers * channels);
    if (w == 1 && h == 1) return t;
  }
}

/// Calls visit(kind, level, rect) for every level that a rectangle of the maps touches, finest first.
template <class Visit>
void for_levels(PackedFace& face, const TexelRect& maps_rect, Visit visit) {
  for (PackedTexture& t : face.textures) {
    if (t.layers == 0) continue;
    TexelRect r = maps_rect;
    if (t.kind == PackedKind::kHorizon) r = halved(r, t.width, t.height);
    for (int level = 0; level < static_cast<int>(t.levels.size()); ++level) {
      if (level) r = halved(r, t.level_width(level), t.level_height(level));
      visit(t.kind, level, r);
    }
  }
}

/// Runs over bands of rows, in parallel for a large rectangle.
template <class Job>
void for_each_band(const TexelRect& r, const Job& job) {
  constexpr int kBandRows = 64;
  constexpr int64_t kWorthAThread = 1 << 14;  // texels
  const int64_t texels = int64_t{r.x1 - r.x0} * (r.y1 - r.y0);
  for_each_job((r.y1 - r.y0 + kBandRows - 1) / kBandRows, texels < kWorthAThread ? 1 : 0, [&](int i) {
    const int y0 = r.y0 + i * kBandRows;
    job(TexelRect{r.x0, y0, r.x1, std::min(r.y1, y0 + kBandRows)});
  });
}

void fill_rect(PackedFace& face, const Maps& maps, const TexelRect& rect) {
  for_each_band(rect, [&](const TexelRect& band) { pack_surface(face, maps, band); });
  for_levels(face, rect, [&](PackedKind kind, int level, const TexelRect& r) {
    PackedTexture& t = face.textures[static_cast<size_t>(kind)];
    if (level) return for_each_band(r, [&](const TexelRect& band) { filter_level(face, kind, level, band); });
    if (kind == PackedKind::kHorizon) for_each_band(r, [&](const TexelRect& band) { pack_horizon(t, maps, band); });
    if (kind == PackedKind::kShadow) pack_shadow(t, maps, r);
  });
}

PackedPatch copy_patch(const PackedFace& face, Face which, PackedKind kind, int level, const TexelRect& r) {
  const PackedTexture& t = face.textures[static_cast<size_t>(kind)];
  PackedPatch patch{which, kind, level, r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0, {}};
  const size_t bytes = static_cast<size_t>(patch.width) * t.channels;
  patch.texels.reserve(bytes * patch.height * t.layers);
  for (int layer = 0; layer < t.layers; ++layer) {
    for (int y = r.y0; y < r.y1; ++y) {
      const uint8_t* row = t.texel(level, layer, r.x0, y);
      patch.texels.insert(patch.texels.end(), row, row + bytes);
    }
  }
  return patch;
}

}  // namespace

PackedFace pack(const Maps& maps, bool shadows) {
  const int w = maps.height_mm.width, h = maps.height_mm.height;
  PackedFace face;
  face.textures[0] = make_texture(PackedKind::kColor, w, h, 2, 4);
  face.textures[1] = make_texture(PackedKind::kRelief, w, h, 2, 4);
  face.textures[2] = make_texture(PackedKind::kHorizon, std::max(1, w / 2), std::max(1, h / 2), maps.azimuths + 1, 2);
  if (shadows) {
    face.textures[3] =
        make_texture(PackedKind::kShadow, w, h, kShadowAzimuths * static_cast<int>(kShadowElevations.size()), 1);
  } else {
    face.textures[3].kind = PackedKind::kShadow;
  }
  fill_rect(face, maps, {0, 0, w, h});
  return face;
}

std::vector<PackedPatch> repack(PackedFace& face, Face which, const Maps& maps, const std::vector<TexelRect>& rects) {
  std::vector<PackedPatch> patches;
  for (const TexelRect& rect : rects) {
    fill_rect(face, maps, rect);
  }
  for (const TexelRect& rect : rects) {
    for_levels(face, rect, [&](PackedKind kind, int level, const TexelRect& r) {
      patches.push_back(copy_patch(face, which, kind, level, r));
    });
  }
  return patches;
}

}  // namespace weftlight::render_data
