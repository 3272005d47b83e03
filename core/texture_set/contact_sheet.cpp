#include "texture_set/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/loops.h"
#include "base/text.h"

namespace weftlight::texture_set {

using base::for_each_job, base::tr;
using cloth::Linear, cloth::Plane, cloth::srgb_from_linear;
using draft::Rgb;
using files::draw_text;

namespace {

// Pixels of the sheet.
constexpr int kTile = 300, kGap = 24, kLabel = 34, kHead = 96, kMargin = 40;
constexpr int kCell = kTile + kLabel + kGap, kBig = 2 * kTile + kGap, kBigHeight = 2 * kCell - kGap - kLabel;
constexpr int kMostTaps = 8;  // of a pixel of the swatch, per side
constexpr std::array<float, 3> kPaper{0.965f, 0.961f, 0.949f}, kInk{0.16f, 0.16f, 0.17f}, kFaint{0.45f, 0.45f, 0.45f};

std::vector<float> ink(const std::array<float, 3>& c) { return {c.begin(), c.end()}; }

glm::vec3 unit(const glm::vec3& v) { return v / std::sqrt(std::max(glm::dot(v, v), 1e-12f)); }

/// Diffuse light, a highlight of the texel's anisotropic GGX, and a soft sky. An approximation for display only.
Linear shaded(const SurfaceTexel& t) {
  static const glm::vec3 light = unit({0.55f, -0.55f, 0.63f}), eye{0, 0, 1};
  static const glm::vec3 half = unit(light + eye);
  const GgxAlphas a = ggx_alphas(t);
  const float wide = std::max(a.wide, 0.05f), narrow = std::max(a.narrow, 0.05f);
  const glm::vec3 wx =
      unit({a.wide_axis[0], a.wide_axis[1],
            -(a.wide_axis[0] * t.normal[0] + a.wide_axis[1] * t.normal[1]) / std::max(t.normal[2], 0.2f)});
  const glm::vec3 wy = glm::cross(t.normal, wx);
  const float hx = dot(half, wx) / wide, hy = dot(half, wy) / narrow, hz = dot(half, t.normal);
  const float q = hx * hx + hy * hy + hz * hz;
  const float d = 1 / (3.14159265f * wide * narrow * q * q);
  const float cosine = std::max(dot(t.normal, light), 0.0f);
  const float shine = 0.25f * d * cosine;
  const float sky = 0.42f * t.occlusion * (0.6f + 0.4f * t.normal[2]);
  auto channel = [&](float base, float sheen) {
    const float f0 = 0.044f + (base - 0.044f) * t.metal;
    constexpr float kBackground = 0.30f;  // a grey wall behind the gaps
    return (1 - t.coverage) * kBackground +
           t.coverage * (base * (1 - t.metal) * (1.25f * cosine * (0.35f + 0.65f * t.occlusion) + sky) +
                         f0 * (shine + sky) + 0.15f * sheen * sky);
  };
  return {channel(t.base.r, t.sheen.r), channel(t.base.g, t.sheen.g), channel(t.base.b, t.sheen.b)};
}

void put(Image& image, int x, int y, float r, float g, float b) {
  float* at =
      image.texels.data() + (static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x)) * 3;
  at[0] = r, at[1] = g, at[2] = b;
}

/// Copies an RGB picture into the sheet.
void paste(Image& sheet, int left, int top, const Image& picture) {
  for (int y = 0; y < picture.height; ++y) {
    const float* from = picture.texels.data() + static_cast<size_t>(y) * static_cast<size_t>(picture.width) * 3;
    for (int x = 0; x < picture.width; ++x, from += 3) put(sheet, left + x, top + y, from[0], from[1], from[2]);
  }
}

/// The image scaled to a tile. Each pixel is the mean of `colour(texel)` over its area; an image smaller than the tile
/// keeps sharp texels.
template <class Colour>
Image shrink_to_tile(const Image& image, const Colour& colour) {
  const int longer = std::max(image.width, image.height);
  const int width = std::max(image.width * kTile / longer, 1), height = std::max(image.height * kTile / longer, 1);
  Image out{width, height, 3, std::vector<float>(static_cast<size_t>(width) * static_cast<size_t>(height) * 3)};
  for_each_job(height, [&](int y) {
    const int y0 = y * image.height / height, y1 = std::max((y + 1) * image.height / height, y0 + 1);
    for (int x = 0; x < width; ++x) {
      const int x0 = x * image.width / width, x1 = std::max((x + 1) * image.width / width, x0 + 1);
      glm::vec3 sum{};
      for (int j = y0; j < y1; ++j) {
        for (int i = x0; i < x1; ++i) {
          const glm::vec3 c = colour(image.texels.data() + (static_cast<size_t>(j) * static_cast<size_t>(image.width) +
                                                            static_cast<size_t>(i)) *
                                                               static_cast<size_t>(image.channels));
          for (size_t k = 0; k < 3; ++k) sum[k] += c[k];
        }
      }
      const float weight = 1.0f / static_cast<float>((y1 - y0) * (x1 - x0));
      put(out, x, y, sum[0] * weight, sum[1] * weight, sum[2] * weight);
    }
  });
  return out;
}

/// Four or five columns, whichever leaves fewer cells empty; the lit swatch covers two by two cells.
int columns_for(size_t entries) {
  auto empty = [n = static_cast<int>(entries) + 4](int columns) {
    return std::max((n + columns - 1) / columns, 2) * columns - n;
  };
  return empty(5) < empty(4) ? 5 : 4;
}

}  // namespace

Image thumbnail(const Image& image, bool stretched) {
  const auto [least, most] = std::minmax_element(image.texels.begin(), image.texels.end());
  const bool stretch = stretched || *least < 0 || *most > 1 || image.channels > 4;
  const float low = stretch ? *least : 0, scale = stretch ? 1 / std::max(*most - *least, 1e-6f) : 1;
  const int channels = image.channels;
  return shrink_to_tile(image, [=](const float* t) -> glm::vec3 {
    const float r = (t[0] - low) * scale;
    return channels < 3 ? glm::vec3{r, r, r} : glm::vec3{r, (t[1] - low) * scale, (t[2] - low) * scale};
  });
}

Image thread_thumbnail(const Image& image) {
  return shrink_to_tile(image, [](const float* t) -> glm::vec3 {
    // Hues in golden-ratio steps differ between neighbours; warp is dark, weft is light.
    const float turn = std::fmod((t[0] + t[1] * 65536.0f) * 65535.0f * 0.618034f + 0.37f * t[2], 1.0f) * 6.2831853f;
    const float level = t[2] > 0.5f ? 0.72f : 0.45f;
    return {level + 0.2f * std::cos(turn), level + 0.2f * std::cos(turn - 2.0944f),
            level + 0.2f * std::cos(turn + 2.0944f)};
  });
}

Image lit_swatch(const SurfaceTexels& surface, int width, int height, float repeats_across) {
  const int w = surface.texels.width, h = surface.texels.height;
  Plane<Linear> radiance(w, h);
  for_each_job(h, [&](int y) {
    for (int x = 0; x < w; ++x) radiance.at(x, y) = shaded(surface.texels.at(x, y));
  });
  Image out{width, height, 3, std::vector<float>(static_cast<size_t>(width) * static_cast<size_t>(height) * 3)};
  const float mm = repeats_across * surface.width_mm / static_cast<float>(width);  // size of a pixel of the swatch
  const float step_x = mm / surface.width_mm * static_cast<float>(w),
              step_y = mm / surface.depth_mm * static_cast<float>(h);
  const int taps = std::clamp(static_cast<int>(std::ceil(std::max(step_x, step_y))), 2, kMostTaps);
  // Of pixel k along a side, the texel of a tap.
  const auto tapped = [taps](int k, int tap, float step, int texels) {
    const float at = (static_cast<float>(k) + (static_cast<float>(tap) + 0.5f) / static_cast<float>(taps)) * step;
    return static_cast<int>(at) % texels;
  };
  std::vector<int> columns;
  for (int x = 0; x < width; ++x)
    for (int i = 0; i < taps; ++i) columns.push_back(tapped(width - 1 - x, i, step_x, w));
  for_each_job(height, [&](int y) {
    std::array<const Linear*, kMostTaps> rows{};
    for (int j = 0; j < taps; ++j) rows[static_cast<size_t>(j)] = radiance.row(tapped(y, j, step_y, h));
    for (int x = 0; x < width; ++x) {
      const int* const across = &columns[static_cast<size_t>(x) * static_cast<size_t>(taps)];
      Linear sum;
      for (int j = 0; j < taps; ++j) {
        for (int i = 0; i < taps; ++i) {
          const Linear& c = rows[static_cast<size_t>(j)][across[i]];
          sum.r += c.r, sum.g += c.g, sum.b += c.b;
        }
      }
      const float weight = 1.0f / static_cast<float>(taps * taps);
      const Rgb c = srgb_from_linear(
          {std::min(sum.r * weight, 1.0f), std::min(sum.g * weight, 1.0f), std::min(sum.b * weight, 1.0f)});
      put(out, x, y, c.r, c.g, c.b);
    }
  });
  return out;
}

Image sheet_swatch(const SurfaceTexels& front) {
  // Enough repeats for about thirty threads across.
  const float repeats = std::max(2.0f, std::ceil(24.0f / std::max(front.width_mm, 0.1f)));
  return lit_swatch(front, kBig, kBigHeight, std::min(repeats, 40.0f));
}

Image contact_sheet(const std::string& title, const std::string& facts, const Image& swatch,
                    const std::vector<SheetEntry>& entries) {
  const int columns = columns_for(entries.size());
  const int rows = std::max((static_cast<int>(entries.size()) + 4 + columns - 1) / columns, 2);
  Image sheet{2 * kMargin + columns * (kTile + kGap) - kGap, kMargin + kHead + rows * kCell, 3, {}};
  sheet.texels.resize(static_cast<size_t>(sheet.width) * static_cast<size_t>(sheet.height) * 3);
  for (size_t i = 0; i < sheet.texels.size(); ++i) sheet.texels[i] = kPaper[i % 3];
  draw_text(sheet, kMargin, kMargin + 30, 34, title, ink(kInk));
  draw_text(sheet, kMargin, kMargin + 62, 17, facts, ink(kFaint));

  paste(sheet, kMargin, kMargin + kHead, swatch);
  draw_text(sheet, kMargin, kMargin + kHead + kBigHeight + 22, 17, tr("lit, tiled"), ink(kInk));
  int slot = 0;
  for (const SheetEntry& entry : entries) {
    while (slot / columns < 2 && slot % columns < 2) ++slot;
    const int left = kMargin + (slot % columns) * (kTile + kGap), top = kMargin + kHead + (slot / columns) * kCell;
    paste(sheet, left, top, entry.image);
    draw_text(sheet, left, top + kTile + 22, 17, entry.label, ink(kInk));
    ++slot;
  }
  return sheet;
}

}  // namespace weftlight::texture_set
