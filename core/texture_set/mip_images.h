#pragma once
// The images of a face with prefiltered mipmaps, in KTX2 or DDS, compressed or not. The variance of the normals that a
// level loses goes into its roughness, colours are averaged in linear light and by coverage, and a mask keeps its
// coverage.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/mip_file.h"
#include "texture_set/channels.h"
#include "texture_set/export_target.h"
#include "texture_set/face_source.h"
#include "texture_set/row_cascade.h"

namespace weftlight::texture_set {

using files::Image, files::MipFormat, files::MipFile;

/// Factors on the coverage of each level, from the finest of `size` on, so that the same fraction of texels as in the
/// finest is above one half. Levels finer than `small` have factor 1.
std::vector<float> mask_scales(const SurfaceTexels& small, TextureSize size);

/// Which images have files with mipmaps: none without a format.
struct MipChoice {
  std::optional<MipFormat> format{};
  bool colors_only = false;  // of sRGB images alone
};
/// The requested format for all images, or what the target needs.
MipChoice mips_for(const ExportTarget& target, std::optional<MipFormat> requested);
/// The format of the row's file; empty: it has none. Directions are never in blocks: where a thread has few texels,
/// those of a block lie on no line, and would be off by up to a tenth (docs/engines.md, Mips).
std::optional<MipFormat> mip_format_of(const ImageRow& row, const MipChoice& choice);
inline bool has_mips(const ImageRow& row, const MipChoice& choice) { return mip_format_of(row, choice).has_value(); }

class MipImages {
 public:
  /// `cut_out`: alpha is a mask.
  MipImages(std::span<const ImageRow> rows, const FaceSource& source, const MipChoice& choice, bool cut_out);
  /// Opens stem.dds or stem.ktx2 for the 8-bit rows; one stem per row.
  base::Result<void> open(const std::vector<std::string>& stems);
  bool wanted() const { return choice_.format.has_value(); }
  int levels() const { return files_.empty() ? 0 : files_[0]->levels(); }
  /// File names, one entry per row; empty for a row without a file.
  const std::vector<std::string>& names() const { return names_; }

  /// Rows of the face as packed levels. `rest`: the coarsest row, from which the coarser levels of the face are made.
  struct Band {
    std::vector<std::vector<Image>> levels;  // by level, then by file
    SurfaceTexels rest;
  };
  /// Packs rows of FaceSource::raw_rows() from row y0 on. Thread safe.
  Band packed(SurfaceTexels raw, int y0) const;
  /// Adds the bands in order.
  base::Result<void> add(Band band);
  base::Result<void> close();

 private:
  std::vector<Image> packed_level(const SurfaceTexels& raw, int level, int y0) const;
  base::Result<void> write(int level, const std::vector<Image>& images);
  RowCascade::Done written();

  const FaceSource& source_;
  MipChoice choice_;
  std::span<const ImageRow> all_rows_;
  std::vector<ImageRow> rows_;  // with a file
  std::vector<std::unique_ptr<MipFile>> files_;
  std::vector<std::string> names_;
  std::vector<float> scales_;  // factors on the coverage, by level
  RowCascade cascade_;
};

}  // namespace weftlight::texture_set
