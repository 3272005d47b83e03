#include "texture_set/recolour.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"
#include "base/text.h"
#include "cloth/srgb_table.h"
#include "draft/hex_color.h"
#include "files/image_rows.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {

using base::arg, base::core_count, base::fill, base::for_each_job, base::tr;
using cloth::MapsSize, cloth::SrgbTable, cloth::ThreadBody, cloth::bake, cloth::linear_from_srgb,
    cloth::srgb_from_linear;
using design::Lobes;
using files::ImageRows, files::PixelType;

namespace {

using nlohmann::json;

// Half, so that fibres lighter than their thread are not cut off at white.
constexpr float kGrey = 0.5f;
constexpr float kGapWeight = 1e-4f;  // as in surface_texels.cpp
constexpr size_t kSharesPerImage = 3;
constexpr int kMaxPieceSide = 16384;  // of a window of the maps
constexpr int kThumbnailSide = 256;
constexpr int kMeasuredSide = 1024;  // to which white is measured before it is written

/// The first entry of the palette with this colour.
int palette_entry(const Design& design, const Linear& color) {
  const auto& palette = design.draft.palette;
  const auto at = std::ranges::find_if(palette, [&](const Rgb& c) { return linear_from_srgb(c) == color; });
  return at == palette.end() ? 0 : static_cast<int>(at - palette.begin());
}

ClothColor& color_in(std::vector<ClothColor>& colors, const Linear& linear) {
  const auto at = std::ranges::find_if(colors, [&](const ClothColor& c) { return c.linear == linear; });
  if (at != colors.end()) return *at;
  colors.push_back({linear, {}, 0, {}, 0, 0});
  return colors.back();
}

int index_of(const std::vector<ClothColor>& colors, const Linear& linear) {
  const auto at = std::ranges::find_if(colors, [&](const ClothColor& c) { return c.linear == linear; });
  return static_cast<int>(at - colors.begin());
}

std::string hex(const Rgb& c) { return fmt::format("#{:06x}", draft::packed_rgb(c)); }

size_t share_images(size_t colors) {
  return colors > kMaxSharedColors ? 0 : (colors + kSharesPerImage - 1) / kSharesPerImage;
}

/// Green and blue of an index, which set neighbours apart to the eye and to a picker: golden-ratio steps.
std::array<float, 2> marks_of(size_t index) {
  constexpr double kGolden = 0.6180339887, kOther = 0.7548776662;  // of one and of two dimensions
  const auto step = [index](double by) {
    const double turn = 0.5 + static_cast<double>(index) * by;
    return static_cast<float>(turn - std::floor(turn));
  };
  return {step(kGolden), step(kOther)};
}

}  // namespace

std::vector<ClothColor> colors_of(const Design& design, const Cloth& cloth) {
  std::vector<ClothColor> out;
  const auto count = [&](const std::vector<ThreadBody>& threads, int ClothColor::*number) {
    for (const ThreadBody& t : threads) {
      ClothColor& color = color_in(out, t.colour);
      const std::string& yarn = cloth.yarns[static_cast<size_t>(t.yarn)].name;
      color.*number += 1;
      if (std::ranges::find(color.yarns, yarn) == color.yarns.end()) color.yarns.push_back(yarn);
    }
  };
  count(cloth.ends, &ClothColor::ends);
  count(cloth.picks, &ClothColor::picks);
  for (ClothColor& c : out) {
    c.palette = palette_entry(design, c.linear);
    c.color = srgb_from_linear(c.linear);
    // Exactly as it was chosen; the mean colour of a dyed thread is in no palette.
    const auto& palette = design.draft.palette;
    if (!palette.empty() && linear_from_srgb(palette[static_cast<size_t>(c.palette)]) == c.linear)
      c.color = palette[static_cast<size_t>(c.palette)];
  }
  std::ranges::stable_sort(out, {}, &ClothColor::palette);
  return out;
}

std::vector<RecolourImage> recolour_images(size_t colors) {
  std::vector<RecolourImage> out{
      {"_white", true, {"base colour of white yarn, red", "the same, green", "the same, blue"}},
      {"_threads", false, {"share of the warp", "share of the weft", "coverage"}},
      {"_index", false, {"index of the colour", "mark of the index", "mark of the index"}, true}};
  for (size_t k = 0; k < share_images(colors); ++k) {
    RecolourImage image{"_shares" + std::to_string(k + 1), false, {}, false};
    for (size_t i = k * kSharesPerImage; i < (k + 1) * kSharesPerImage; ++i)
      image.channels.push_back(i < colors ? "share of the colour with index " + std::to_string(i) : "none");
    out.push_back(std::move(image));
  }
  return out;
}

std::string recolour_file(const ExportTarget& target, const RecolourImage& image, const std::string& name, Face face) {
  return target.images[0].prefix + name + face_suffix(target, face) + image.suffix + ".png";
}

RecolourSource::RecolourSource(const FaceSource& source, const std::vector<ClothColor>& colors)
    : source_(source), grey_(source.cloth()), colors_(colors.size()) {
  const auto take = [&](std::vector<ThreadBody>& threads, std::vector<int>& indices) {
    for (ThreadBody& t : threads) {
      indices.push_back(index_of(colors, t.colour));
      t.colour = {kGrey, kGrey, kGrey}, t.dye = -1;
    }
  };
  take(grey_.ends, color_[0]);
  take(grey_.picks, color_[1]);
  const TextureSize size = source.size();
  float most = most_white();
  if (most > 1 && std::max(size.width, size.height) <= kMeasuredSide) most = measured_white();
  white_scale_ = std::max(std::ceil(most * 1000) / 1000, 1.0f);
}

/// What a thread scatters of the light if its yarn is white, before the fit.
glm::vec3 RecolourSource::scattered(const ThreadBody& body) const {
  const Lobes& lobes = grey_.yarns[static_cast<size_t>(body.yarn)].lobes;
  if (!lobes.metallic) return glm::vec3(lobes.body);
  const Linear tint = linear_from_srgb(lobes.specular_tint);
  return lobes.specular * glm::vec3(tint.r, tint.g, tint.b);
}

/// A bound of white in any texel: the maps hold colours up to 1, and grooves only darken.
float RecolourSource::most_white() const {
  float most = 0;
  for (const std::vector<ThreadBody>* threads : {&grey_.ends, &grey_.picks})
    for (const ThreadBody& body : *threads) {
      const glm::vec3 white = scattered(body) * source_.fit().base / kGrey;
      most = std::max({most, white.r, white.g, white.b});
    }
  return most;
}

/// The largest white of the face. It takes as long as writing it.
float RecolourSource::measured_white() const {
  const TextureSize size = source_.size();
  const int band = source_.band();
  std::vector<float> most(static_cast<size_t>(size.height / band));
  for_each_job(static_cast<int>(most.size()), [&](int i) {
    float& here = most[static_cast<size_t>(i)];
    for_each_texel(size, i * band, (i + 1) * band, [&](const Texel& texel, size_t) {
      here = std::max({here, texel.white.r, texel.white.g, texel.white.b});
    });
  });
  return std::ranges::max(most);
}

void RecolourSource::sum_up(Texel& texel, const Maps& maps, int x, int y, int block) const {
  texel.white = glm::vec3(0), texel.warp = texel.coverage = 0;
  texel.shares.assign(colors_, 0.0f);
  float total = 0;
  for (int j = y * block; j < (y + 1) * block; ++j) {
    for (int i = x * block; i < (x + 1) * block; ++i) {
      const size_t system = maps.system.at(i, j), thread = maps.thread.at(i, j);
      const ThreadBody& body = (system == 0 ? grey_.ends : grey_.picks)[thread];
      const float w = maps.coverage.at(i, j) + kGapWeight,
                  shade = maps.colour.at(i, j).g / kGrey * maps.groove.at(i, j);
      texel.white += w * shade * scattered(body);
      texel.shares[static_cast<size_t>(color_[system][thread])] += w;
      texel.warp += system == 0 ? w : 0.0f;
      texel.coverage += maps.coverage.at(i, j);
      total += w;
    }
  }
  texel.white *= source_.fit().base / total;
  texel.warp /= total;
  texel.coverage /= static_cast<float>(block * block);
  for (float& share : texel.shares) share /= total;
}

void RecolourSource::put(std::vector<Image>& images, size_t at, const Texel& texel) const {
  const SrgbTable& srgb = SrgbTable::get();
  const auto set = [&](size_t image, float r, float g, float b) {
    float* const out = images[image].texels.data() + 3 * at;
    out[0] = r, out[1] = g, out[2] = b;
  };
  const auto encoded = [&](float v) { return srgb.encoded(v / white_scale_); };
  set(0, encoded(texel.white.r), encoded(texel.white.g), encoded(texel.white.b));
  set(1, texel.warp, 1 - texel.warp, texel.coverage);
  const auto most = static_cast<size_t>(std::ranges::max_element(texel.shares) - texel.shares.begin());
  const std::array<float, 2> marks = marks_of(most);
  set(2, static_cast<float>(most) / 255.0f, marks[0], marks[1]);
  const auto share = [&](size_t i) { return i < texel.shares.size() ? texel.shares[i] : 0.0f; };
  for (size_t k = 0; k < share_images(colors_); ++k)
    set(3 + k, share(kSharesPerImage * k), share(kSharesPerImage * k + 1), share(kSharesPerImage * k + 2));
}

/// Calls use(texel, place) for all texels of rows [y0, y1); the place is that in an image of these rows.
template <class Use>
void RecolourSource::for_each_texel(TextureSize size, int y0, int y1, const Use& use) const {
  const int block = supersampling(grey_, size), step = std::min(size.width, kMaxPieceSide / block);
  const MapsSize whole{size.width * block, size.height * block, 0, 1};
  Texel texel;
  for (int x0 = 0; x0 < size.width; x0 += step) {
    const Maps maps = bake(grey_, whole, {x0 * block, y0 * block, (x0 + step) * block, y1 * block});
    for (int y = 0; y < y1 - y0; ++y) {
      for (int x = 0; x < step; ++x) {
        sum_up(texel, maps, x, y, block);
        const int column = size.width - 1 - (x0 + x);  // u to the left
        use(texel, static_cast<size_t>(y) * static_cast<size_t>(size.width) + static_cast<size_t>(column));
      }
    }
  }
}

std::vector<Image> RecolourSource::rows(TextureSize size, int y0, int y1) const {
  const auto texels = static_cast<size_t>(size.width) * static_cast<size_t>(y1 - y0);
  std::vector<Image> out(3 + share_images(colors_), {size.width, y1 - y0, 3, std::vector<float>(3 * texels)});
  for_each_texel(size, y0, y1, [&](const Texel& texel, size_t at) { put(out, at, texel); });
  return out;
}

namespace {

/// Band by band: first one band per core, then the bands in order.
base::Result<void> write_rows(const RecolourSource& made, TextureSize size, int band,
                              std::vector<std::unique_ptr<ImageRows>>& files) {
  const int bands = size.height / band, at_once = std::min(core_count(), bands);
  std::vector<std::vector<Image>> rows(static_cast<size_t>(at_once));
  for (int first = 0; first < bands; first += at_once) {
    const int count = std::min(at_once, bands - first);
    for_each_job(count, [&](int i) {
      const int y = (first + i) * band;
      rows[static_cast<size_t>(i)] = made.rows(size, y, y + band);
    });
    for (size_t i = 0; i < static_cast<size_t>(count); ++i)
      for (size_t k = 0; k < files.size(); ++k)
        if (base::Result<void> added = files[k]->add(rows[i][k]); !added) return added;
  }
  for (const std::unique_ptr<ImageRows>& file : files)
    if (base::Result<void> closed = file->close(); !closed) return closed;
  return {};
}

void record(SetImages& set, const RecolourImage& image, const std::string& file, TextureSize size, Face face) {
  constexpr const char* kLetters[] = {"R", "G", "B"};
  json channels = json::object();
  for (size_t c = 0; c < std::min(image.channels.size(), std::size(kLetters)); ++c)
    channels[kLetters[c]] = image.channels[c];
  set.maps.push_back({{"file", file},
                      {"face", face == Face::kFront ? "front" : "back"},
                      {"color_space", image.srgb ? "sRGB" : "linear"},
                      {"type", "8-bit"},
                      {"width", size.width},
                      {"height", size.height},
                      {"channels", std::move(channels)},
                      {"recolour", true}});
}

}  // namespace

base::Result<void> write_recolour_images(SetImages& set, const FaceSource& source,
                                         const std::vector<ClothColor>& colors, Face face) {
  if (colors.size() > kMaxIndexedColors)
    return base::failure(
        base::ErrorKind::kInput,
        fill(tr("--masks: the threads have {count} colours, and an image of indices holds {most}; give "
                "them fewer colours, or leave --masks out"),
             arg("count", colors.size()), arg("most", kMaxIndexedColors)));
  const TextureSize size = source.size();
  const std::vector<RecolourImage> images = recolour_images(colors.size());
  const RecolourSource made(source, colors);
  set.white_scale[face == Face::kFront ? 0 : 1] = std::round(1000 * static_cast<double>(made.white_scale())) / 1000;
  std::vector<std::unique_ptr<ImageRows>> files;
  for (const RecolourImage& image : images) {
    auto opened = ImageRows::open(set.folder + "/" + recolour_file(set.target, image, set.name, face), size.width,
                                  size.height, 3, PixelType::kU8, {});
    if (!opened) return failed(opened);
    files.push_back(std::move(*opened));
  }
  if (base::Result<void> done = write_rows(made, size, source.band(), files); !done) return done;
  const TextureSize small{std::min(size.width, kThumbnailSide), std::min(size.height, kThumbnailSide)};
  const std::vector<Image> seen = made.rows(small, 0, small.height);
  for (size_t k = 0; k < images.size(); ++k) {
    record(set, images[k], recolour_file(set.target, images[k], set.name, face), size, face);
    set.sheet.push_back({images[k].suffix.substr(1) + face_suffix(set.target, face), thumbnail(seen[k])});
  }
  return {};
}

json recolour_json(const std::vector<ClothColor>& colors, const SetImages& set) {
  constexpr const char* kLetters[] = {"R", "G", "B"};
  const std::vector<RecolourImage> images = recolour_images(colors.size());
  json list = json::array();
  for (size_t i = 0; i < colors.size(); ++i) {
    const ClothColor& c = colors[i];
    std::string name = hex(c.color);
    for (const std::string& yarn : c.yarns) name += " " + yarn;
    json entry{{"index", i},
               {"name", name},
               {"color", hex(c.color)},
               {"linear", {c.linear.r, c.linear.g, c.linear.b}},
               {"palette", c.palette + 1},
               {"yarns", c.yarns},
               {"ends", c.ends},
               {"picks", c.picks}};
    if (const size_t k = 3 + i / kSharesPerImage; k < images.size()) {
      for (const Face face : {Face::kFront, Face::kBack})
        entry["share"][face == Face::kFront ? "front" : "back"] = recolour_file(set.target, images[k], set.name, face);
      entry["share"]["channel"] = kLetters[i % kSharesPerImage];
    }
    list.push_back(std::move(entry));
  }
  return {{"formula", "base colour = white_scale x white x sum over the colours of share x linear, in linear light"},
          {"white_scale", {{"front", set.white_scale[0]}, {"back", set.white_scale[1]}}},
          {"colors", std::move(list)}};
}

}  // namespace weftlight::texture_set
