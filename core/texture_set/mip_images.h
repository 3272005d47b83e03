#pragma once
// The images of a face with mips of our own, in KTX2 or DDS: what the normals of a level lose goes into its roughness,
// colours are averaged in linear light and by coverage, and cut-out cloth keeps the share of it that is cut out.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/mip_file.h"
#include "texture_set/face_source.h"
#include "texture_set/names.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

/// By how much the coverage of each level is to grow, so that as much of it as of the finest is above one half; from
/// the finest of `size` on. Levels finer than `small` keep theirs.
std::vector<float> mask_scales(const SurfaceTexels& small, TextureSize size);

class MipImages {
 public:
  /// Opens `folder`/stem.dds or .ktx2 for the rows of 8 bits; `problem`: what went wrong. `cut_out`: gaps are a mask.
  MipImages(std::span<const ImageRow> rows, const std::vector<std::string>& stems, const FaceSource& source,
            std::optional<MipContainer> container, bool cut_out, std::string& problem);
  bool wanted() const { return container_.has_value(); }
  int levels() const { return files_.empty() ? 0 : files_[0]->levels(); }
  /// Names of the files, an entry a row; empty: a row without one.
  const std::vector<std::string>& names() const { return names_; }

  /// A stretch of the face, its levels packed; `rest` is its coarsest row, from which those of the whole are made.
  struct Band {
    std::vector<std::vector<Image>> levels;  // by level, then by file
    SurfaceTexels rest;
  };
  /// Of FaceSource::raw_rows() from row y0 on. Any thread.
  Band packed(SurfaceTexels raw, int y0) const;
  /// Bands in their order. Empty: done; else what went wrong.
  std::string add(Band band);
  std::string close();

 private:
  std::vector<Image> packed_level(const SurfaceTexels& raw, int level, int y0) const;
  std::string write(int level, const std::vector<Image>& images);

  const FaceSource& source_;
  std::optional<MipContainer> container_;
  std::vector<ImageRow> rows_;  // that have a file
  std::vector<std::unique_ptr<MipFile>> files_;
  std::vector<std::string> names_;
  std::vector<float> scales_;  // of the coverage, by level
  std::vector<SurfaceTexels> rest_;
  int first_rest_ = 0;  // the level of `rest_`
};

}  // namespace weftlight::texture_set
