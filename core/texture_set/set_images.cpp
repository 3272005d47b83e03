#include "texture_set/set_images.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/loops.h"
#include "files/image_rows.h"
#include "texture_set/export_progress.h"
#include "texture_set/material_files.h"
#include "texture_set/row_cascade.h"

namespace weftlight::texture_set {

using base::core_count, base::for_each_job;
using files::Image, files::ImageRows, files::PixelType, files::extension_of, files::write_image;

namespace {

using nlohmann::json;

const char* type_name(PixelType type) {
  switch (type) {
    case PixelType::kU8:
      return "8-bit";
    case PixelType::kU16:
      return "16-bit";
    case PixelType::kHalf:
      return "half";
    case PixelType::kFloat:
      break;
  }
  return "float";
}

const char* face_name(Face face) { return face == Face::kFront ? "front" : "back"; }

void record(SetImages& set, const std::string& file, Face face, bool srgb, PixelType type, TextureSize size,
            json channels) {
  set.maps.push_back({{"file", file},
                      {"face", face_name(face)},
                      {"color_space", srgb ? "sRGB" : "linear"},
                      {"type", type_name(type)},
                      {"width", size.width},
                      {"height", size.height},
                      {"channels", std::move(channels)}});
}

/// Channel names of an .exr; empty for other formats.
std::vector<std::string> channel_names(const ImageRow& row) {
  std::vector<std::string> out;
  if (std::string_view(row.extension) != ".exr") return out;
  for (int c = 0; c < channels_of(row); ++c) out.emplace_back(exr_name(row.channels[static_cast<size_t>(c)]));
  return out;
}

json channel_list(const ImageRow& row) {
  constexpr const char* kLetters[] = {"R", "G", "B", "A"};
  const std::vector<std::string> names = channel_names(row);
  json out = json::object();
  for (size_t c = 0; c < static_cast<size_t>(channels_of(row)); ++c)
    out[names.empty() ? kLetters[c] : names[c]] = channel_description(row.channels[c]);
  return out;
}

/// Of an image whose texels are all the same.
TextureSize constant_size(TextureSize size) {
  constexpr int kSide = 16;
  return {std::min(size.width, kSide), std::min(size.height, kSide)};
}

/// Thumbnails show colours sRGB encoded, and every thread in a different colour.
Image thumbnail_of(const ImageRow& row, const SurfaceTexels& surface) {
  ImageRow encoded = row;
  if (row.channels[0] == Channel::kBaseR) encoded.srgb = true;
  const Image image = pack(encoded, surface);
  return row.channels[0] == Channel::kThreadLow ? thread_thumbnail(image) : thumbnail(image);
}

template <class Job>
void for_all(size_t count, const Job& job) {
  for_each_job(static_cast<int>(count), [&](int i) { job(static_cast<size_t>(i)); });
}

/// The mip levels of a raw set below the finest: normals and roughness, which belong together. Level 0 of their file is
/// half as large as the face.
class RawMips {
 public:
  explicit RawMips(TextureSize face)
      : size_{std::max(face.width / 2, 1), std::max(face.height / 2, 1)}, cascade_(face) {}
  base::Result<void> open(const SetImages& set, Face face) {
    file_ = set.name + face_suffix(set.target, face) + "_mips.exr";
    auto rows = ImageRows::open_mipmapped(set.folder + "/" + file_, size_.width, size_.height, names());
    if (!rows) return failed(rows);
    rows_ = std::move(*rows);
    return {};
  }
  bool wanted() const { return rows_ != nullptr; }
  base::Result<void> add(SurfaceTexels band) {
    int level = 0;
    for (; band.texels.height > 1; ++level) {
      band = half_of(band);
      if (base::Result<void> written = write(level + 1, band); !written) return written;
    }
    return cascade_.add(level, std::move(band), done());
  }
  /// The last levels, and the record of the file.
  base::Result<void> close(SetImages& set, Face face) {
    base::Result<void> closed = cascade_.finish(done()).and_then([this] { return rows_->close(); });
    json channels;
    for (const Channel c : kChannels) channels[exr_name(c)] = channel_description(c);
    record(set, file_, face, false, PixelType::kHalf, size_, std::move(channels));
    set.maps.back()["mip_levels"] = std::bit_width(static_cast<unsigned>(std::max(size_.width, size_.height)));
    return closed;
  }

 private:
  static constexpr std::array kChannels{Channel::kNormalX, Channel::kNormalY, Channel::kNormalZ,
                                        Channel::kRoughnessAlong, Channel::kRoughnessAcross};
  static std::vector<std::string> names() {
    std::vector<std::string> out;
    for (const Channel c : kChannels) out.emplace_back(exr_name(c));
    return out;
  }
  RowCascade::Done done() {
    return [this](int level, int, const SurfaceTexels& rows) { return write(level, rows); };
  }
  /// level: of the face.
  base::Result<void> write(int level, const SurfaceTexels& rows) {
    constexpr std::array kNormal{kChannels[0], kChannels[1], kChannels[2], Channel::kNone};
    constexpr std::array kRough{kChannels[3], kChannels[4], Channel::kNone, Channel::kNone};
    const Image a = pack({"", "", "", PixelType::kHalf, false, kNormal}, rows);
    const Image b = pack({"", "", "", PixelType::kHalf, false, kRough}, rows);
    Image both{a.width, a.height, 5, {}};
    for (size_t i = 0; i < static_cast<size_t>(a.width) * static_cast<size_t>(a.height); ++i) {
      both.texels.insert(both.texels.end(), {a.texels[3 * i], a.texels[3 * i + 1], a.texels[3 * i + 2], b.texels[2 * i],
                                             b.texels[2 * i + 1]});
    }
    return rows_->add(both, level - 1);
  }

  TextureSize size_;
  RowCascade cascade_;
  std::string file_;
  std::unique_ptr<ImageRows> rows_;
};

/// The horizons of a face in rows of an image. `spread`: their standard deviations; otherwise their means.
Image horizon_band(const FaceSource& source, bool spread, int y0, int y1) {
  const TextureSize size = source.horizon_size();
  const HorizonTexels rows = horizon_rows(source.horizons(), size.width, size.height, y0, y1);
  return pack_planes(spread ? rows.spread : rows.mean);
}

base::Result<void> write_horizon(SetImages& set, const FaceSource& source, bool spread, Face face) {
  if (source.horizons().empty()) return {};
  const std::string what = spread ? "spread" : "mean";
  const std::string file = set.name + face_suffix(set.target, face) + "_horizon_" + what + ".exr";
  const int count = static_cast<int>(source.horizons().size());
  json channels = json::object();
  std::vector<std::string> names;
  for (int k = 0; k < count; ++k) {
    char name[32];
    std::snprintf(name, sizeof name, "azimuth.%05.1f", 360.0 * k / count);
    names.emplace_back(name);
    channels[name] = "sine of the horizon's elevation, " + what + ", towards this azimuth in degrees, from right to up";
  }
  const TextureSize size = source.horizon_size();
  auto out = ImageRows::open(set.folder + "/" + file, size.width, size.height, count, PixelType::kHalf, names);
  if (!out) return failed(out);
  constexpr int kBandRows = 64;
  Image few{size.width, size.height, 3, {}};  // azimuths, for the thumbnail
  few.texels.reserve(static_cast<size_t>(size.width) * static_cast<size_t>(size.height) * 3);
  for (int y = 0; y < size.height; y += kBandRows) {
    const Image band = horizon_band(source, spread, y, std::min(y + kBandRows, size.height));
    if (base::Result<void> added = (*out)->add(band); !added) return added;
    for (auto at = band.texels.begin(); at != band.texels.end(); at += count)
      few.texels.insert(few.texels.end(), at, at + 3);
  }
  record(set, file, face, false, PixelType::kHalf, size, std::move(channels));
  set.sheet.push_back({"horizon_" + what + face_suffix(set.target, face), thumbnail(few, true)});
  return (*out)->close();
}

/// Rows of the face in every image, and the surface itself if it is needed later.
struct PackedBand {
  std::vector<Image> images;
  SurfaceTexels surface;
  MipImages::Band mips;
};

PackedBand packed_band(std::span<const ImageRow> rows, const FaceSource& source, int y0, const MipImages& mips,
                       bool keep) {
  PackedBand out;
  SurfaceTexels surface = source.raw_rows(y0, y0 + source.band());
  if (mips.wanted()) out.mips = mips.packed(surface, y0);
  surface = source.finished(std::move(surface), y0, source.size().height);
  for (const ImageRow& row : rows) out.images.push_back(pack(row, surface, 1));
  if (keep) out.surface = std::move(surface);
  return out;
}

/// Whether an image has one value all over, in the steps that its file can store.
class ConstantCheck {
 public:
  explicit ConstantCheck(PixelType type)
      : steps_(type == PixelType::kU8    ? 255.0f
               : type == PixelType::kU16 ? 65535.0f
                                         : 0.0f) {}
  void add(const Image& rows) {
    const auto channels = static_cast<size_t>(rows.channels);
    if (first_.empty()) first_.assign(rows.texels.begin(), rows.texels.begin() + rows.channels);
    for (size_t i = 0; constant_ && i < rows.texels.size(); ++i) constant_ = same(rows.texels[i], first_[i % channels]);
  }
  bool constant() const { return constant_ && !first_.empty(); }
  const std::vector<float>& values() const { return first_; }

 private:
  bool same(float a, float b) const {
    const auto stored = [this](float v) { return std::floor(std::clamp(v, 0.0f, 1.0f) * steps_ + 0.5f); };
    return steps_ > 0 ? stored(a) == stored(b) : a == b;
  }
  float steps_;
  bool constant_ = true;
  std::vector<float> first_;
};

/// The image in few texels, or none if the material has factors for it.
base::Result<void> keep_constant(SetImages& set, const ImageRow& row, TextureSize size, Face face,
                                 const std::vector<float>& values) {
  const std::string file = image_file(set.target, row, set.name, face), path = set.folder + "/" + file;
  std::error_code ec;
  if (has_mips(row, set.mips)) {
    std::filesystem::path mipped(path);
    std::filesystem::remove(mipped.replace_extension(extension_of(*set.mips.format)), ec);
  }
  set.constants[file] = values;
  if (row.factor) {
    std::filesystem::remove(path, ec);
    set.factors.push_back({{"image", file},
                           {"face", face_name(face)},
                           {"color_space", row.srgb ? "sRGB" : "linear"},
                           {"channels", channel_list(row)},
                           {"values", values}});
    return {};
  }
  const TextureSize small = constant_size(size);
  Image image{small.width, small.height, channels_of(row), {}};
  for (int i = 0; i < small.width * small.height; ++i)
    image.texels.insert(image.texels.end(), values.begin(), values.end());
  return write_image(path, image, row.type, channel_names(row));
}

constexpr size_t kBandsPerCore = 4;  // at a time

/// Writes the images of the table and collects the mip levels.
base::Result<void> write_rows(SetImages& set, const FaceSource& source, TextureSize size, Face face, RawMips& mips,
                              MipImages& own) {
  const std::span<const ImageRow> rows = set.target.images;
  std::vector<std::unique_ptr<ImageRows>> images;
  for (const ImageRow& row : rows) {
    const std::string path = set.folder + "/" + image_file(set.target, row, set.name, face);
    auto opened = ImageRows::open(path, size.width, size.height, channels_of(row), row.type, channel_names(row));
    if (!opened) return failed(opened);
    images.push_back(std::move(*opened));
  }
  std::vector<ConstantCheck> checks;
  for (const ImageRow& row : rows) checks.emplace_back(row.type);
  std::vector<base::Result<void>> done(rows.size());  // by image
  const auto all_done = [&]() -> base::Result<void> {
    const auto not_done = std::ranges::find_if(done, [](const base::Result<void>& r) { return !r; });
    return not_done == done.end() ? base::Result<void>() : *not_done;
  };
  // First a few bands per core, since they take unequal time, then one image per core, which adds the bands in order.
  const size_t max_bands = static_cast<size_t>(core_count()) * kBandsPerCore;
  std::vector<PackedBand> bands;
  for (int y = 0; y < size.height; y += source.band() * static_cast<int>(bands.size())) {
    bands.resize(std::min(max_bands, static_cast<size_t>((size.height - y) / source.band())));
    for_all(bands.size(), [&](size_t b) {
      const int y0 = y + static_cast<int>(b) * source.band();
      bands[b] = packed_band(rows, source, y0, own, mips.wanted());
    });
    for_all(rows.size(), [&](size_t i) {
      for (const PackedBand& band : bands) {
        checks[i].add(band.images[i]);
        if (done[i]) done[i] = images[i]->add(band.images[i]);
      }
    });
    const int written = y + source.band() * static_cast<int>(bands.size());
    if (set.keep_going && !set.keep_going(static_cast<float>(written) / static_cast<float>(size.height)))
      return stopped();
    if (base::Result<void> all = all_done(); !all) return all;
    for (PackedBand& band : bands) {
      if (mips.wanted())
        if (base::Result<void> added = mips.add(std::move(band.surface)); !added) return added;
      if (!own.wanted()) continue;
      if (base::Result<void> added = own.add(std::move(band.mips)); !added) return added;
    }
  }
  for_all(rows.size(), [&](size_t i) { done[i] = images[i]->close(); });
  if (base::Result<void> all = all_done().and_then([&own] { return own.close(); }); !all) return all;
  for (size_t i = 0; i < rows.size() && !set.target.raw; ++i) {
    if (!checks[i].constant()) continue;
    if (base::Result<void> kept = keep_constant(set, rows[i], size, face, checks[i].values()); !kept) return kept;
  }
  return {};
}

/// Paths of a face's images without their extensions.
std::vector<std::string> stems_of(const SetImages& set, Face face) {
  std::vector<std::string> out;
  for (const ImageRow& row : set.target.images) {
    const std::string file = image_file(set.target, row, set.name, face);
    out.push_back(set.folder + "/" + file.substr(0, file.size() - std::string_view(row.extension).size()));
  }
  return out;
}

void record_mips(SetImages& set, const MipImages& own, TextureSize size, Face face) {
  const std::span<const ImageRow> rows = set.target.images;
  for (size_t i = 0; i < own.names().size(); ++i) {
    if (own.names()[i].empty() || set.constants.contains(image_file(set.target, rows[i], set.name, face))) continue;
    record(set, own.names()[i], face, rows[i].srgb, PixelType::kU8, size, channel_list(rows[i]));
    set.maps.back()["mip_levels"] = own.levels();
  }
}

}  // namespace

base::Result<void> write_face(SetImages& set, FaceSource& source, Face face) {
  for (const bool spread : {false, true})
    if (base::Result<void> done = write_horizon(set, source, spread, face); !done) return done;
  source.release_horizons();
  const TextureSize size = source.size();
  RawMips mips(size);
  if (set.target.raw)
    if (base::Result<void> opened = mips.open(set, face); !opened) return opened;
  const bool cut_out = alpha_for(set.target, set.alpha, source.coverage()) == Alpha::kMask;
  MipImages own(set.target.images, source, set.mips, cut_out);
  if (base::Result<void> opened = own.open(stems_of(set, face)); !opened) return opened;
  if (base::Result<void> rows = write_rows(set, source, size, face, mips, own); !rows) return rows;
  record_mips(set, own, size, face);
  for (const ImageRow& row : set.target.images) {
    const std::string file = image_file(set.target, row, set.name, face);
    const bool constant = set.constants.contains(file);
    if (!constant || !row.factor)
      record(set, file, face, row.srgb, row.type, constant ? constant_size(size) : size, channel_list(row));
    set.sheet.push_back(
        {std::string(row.suffix + 1) + face_suffix(set.target, face), thumbnail_of(row, source.small())});
  }
  return mips.wanted() ? mips.close(set, face) : base::Result<void>();
}

}  // namespace weftlight::texture_set
