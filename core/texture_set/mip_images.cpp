// Based on: Castano, Computing Alpha Mipmaps, 2010 (coverage of masks); surface_texels.cpp for normals and roughness.

#include "texture_set/mip_images.h"

#include <algorithm>
#include <filesystem>

#include "base/loops.h"

namespace weftlight::texture_set {

using base::Result;
using files::MipFormat, files::PixelType, files::extension_of;

namespace {

constexpr float kCut = 0.5f;  // threshold of a mask
constexpr float kMaxScale = 4;

std::vector<float> coverages(const SurfaceTexels& surface) {
  std::vector<float> out;
  for (const SurfaceTexel& t : surface.texels.at_) out.push_back(t.coverage);
  return out;
}

}  // namespace

std::vector<float> mask_scales(const SurfaceTexels& small, TextureSize size) {
  std::vector<float> out;
  for (int width = size.width, height = size.height; width > small.texels.width || height > small.texels.height;
       width /= 2, height /= 2)
    out.push_back(1);
  SurfaceTexels level{small.width_mm, small.depth_mm, small.texels};
  const std::vector<float> finest = coverages(level);
  const auto above = std::count_if(finest.begin(), finest.end(), [](float c) { return c >= kCut; });
  const double wanted = static_cast<double>(above) / static_cast<double>(finest.size());
  for (bool first = true;; first = false) {
    std::vector<float> all = coverages(level);
    std::sort(all.begin(), all.end(), std::greater<>());
    const auto kept = static_cast<size_t>(wanted * static_cast<double>(all.size()) + 0.5);
    const float last = kept > 0 ? all[kept - 1] : 1.0f;  // the smallest coverage that stays above the threshold
    out.push_back(first || kept == 0 ? 1.0f
                                     : std::clamp(kCut / std::max(last, 1e-3f) * 1.001f, 1 / kMaxScale, kMaxScale));
    if (level.texels.width == 1 && level.texels.height == 1) return out;
    level = half_of(level);
  }
}

MipChoice mips_for(const ExportTarget& target, std::optional<MipFormat> requested) {
  if (requested) return {requested, false};
  return {target.color_mips, true};
}

std::optional<MipFormat> mip_format_of(const ImageRow& row, const MipChoice& choice) {
  if (!choice.format || row.type != PixelType::kU8 || (!row.srgb && choice.colors_only)) return std::nullopt;
  const MipFormat format = holds_directions(row) ? without_blocks(*choice.format) : *choice.format;
  return holds(format, channels_of(row)) ? std::optional(format) : std::nullopt;
}

MipImages::MipImages(std::span<const ImageRow> rows, const FaceSource& source, const MipChoice& choice, bool cut_out)
    : source_(source), choice_(choice), all_rows_(rows), cascade_(source.size()) {
  if (choice.format && cut_out) scales_ = mask_scales(source.small(), source.size());
}

Result<void> MipImages::open(const std::vector<std::string>& stems) {
  if (!choice_.format) return {};
  const TextureSize size = source_.size();
  for (size_t i = 0; i < all_rows_.size(); ++i) {
    names_.emplace_back();
    const ImageRow& row = all_rows_[i];
    const std::optional<MipFormat> format = mip_format_of(row, choice_);
    if (!format) continue;
    const std::string path = stems[i] + extension_of(*format);
    auto file = MipFile::open(path, *format, size.width, size.height, channels_of(row), row.srgb);
    if (!file) return base::failed(file);
    files_.push_back(std::move(*file));
    rows_.push_back(row), names_.back() = std::filesystem::path(path).filename().string();
  }
  return {};
}

std::vector<Image> MipImages::packed_level(const SurfaceTexels& raw, int level, int y0) const {
  SurfaceTexels surface = source_.finished(raw, y0, std::max(source_.size().height >> level, 1));
  if (static_cast<size_t>(level) < scales_.size())
    for (SurfaceTexel& t : surface.texels.at_)
      t.coverage = std::min(t.coverage * scales_[static_cast<size_t>(level)], 1.0f);
  std::vector<Image> out;
  for (const ImageRow& row : rows_) out.push_back(pack(row, surface, 1));
  return out;
}

MipImages::Band MipImages::packed(SurfaceTexels raw, int y0) const {
  Band out;
  for (int level = 0;; ++level) {
    out.levels.push_back(packed_level(raw, level, y0 >> level));
    if (raw.texels.height == 1) break;
    raw = half_of(raw, 1);
  }
  out.rest = std::move(raw);
  return out;
}

Result<void> MipImages::write(int level, const std::vector<Image>& images) {
  for (size_t i = 0; i < files_.size(); ++i)
    if (Result<void> added = files_[i]->add(level, images[i]); !added) return added;
  return {};
}

RowCascade::Done MipImages::written() {
  return [this](int level, int y, const SurfaceTexels& rows) { return write(level, packed_level(rows, level, y)); };
}

Result<void> MipImages::add(Band band) {
  for (size_t k = 0; k < band.levels.size(); ++k)
    if (Result<void> written = write(static_cast<int>(k), band.levels[k]); !written) return written;
  return cascade_.add(static_cast<int>(band.levels.size()) - 1, std::move(band.rest), written());
}

Result<void> MipImages::close() {
  if (files_.empty()) return {};
  if (Result<void> finished = cascade_.finish(written()); !finished) return finished;
  for (const std::unique_ptr<MipFile>& file : files_)
    if (Result<void> closed = file->close(); !closed) return closed;
  return {};
}

}  // namespace weftlight::texture_set
