#include "gl/gpu_cloth.h"

#include <algorithm>

#include "light/tables.h"
#include "render_data/response_block.h"

namespace weftlight::gl {

using draft::Face;
using light::LightTables, light::kResponseViews, light::kSlopeBins, light::light_tables;
using opengl::kSmoothRg, opengl::kSmoothRgb, opengl::kSmoothRgba;
using render_data::CrossingPatch, render_data::PackedPatch, render_data::PackedTexture, render_data::StripPatch,
    render_data::kResponseHeight, render_data::kResponseWidth, render_data::kSlopeRows, render_data::kViewTableHeight,
    render_data::kViewTableWidth;

namespace {

struct Format {
  GLint internal;
  GLenum layout, type;
  Sampler slot;
};
constexpr std::array<Format, kPackedKinds> kFormats{{
    {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, kColorSlot},
    {GL_RGBA8_SNORM, GL_RGBA, GL_BYTE, kReliefSlot},
    {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, kHorizonSlot},
    {GL_R8, GL_RED, GL_UNSIGNED_BYTE, kThreadShadowSlot},
}};

size_t upload_face(const PackedTexture& t, const Format& format, int first_layer) {
  size_t bytes = 0;
  for (int level = 0; level < static_cast<int>(t.levels.size()); ++level) {
    const std::vector<uint8_t>& texels = t.levels[static_cast<size_t>(level)];
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, first_layer, t.level_width(level), t.level_height(level),
                    t.layers, format.layout, format.type, texels.data());
    bytes += texels.size();
  }
  return bytes;
}

/// Frees uploaded texels, if the caller gave them away.
void free_texels(PackedTexture& uploaded) { uploaded = {}; }
void free_texels(const PackedTexture&) {}

void filter_as_tile(int levels) {
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, levels - 1);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
}

/// Texels are fetched one by one.
void as_table(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

void clamp_to_edge(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

void upload_cube(GlTexture& texture, const std::vector<float>& texels, int size) {
  glBindTexture(GL_TEXTURE_CUBE_MAP, texture.get());
  const size_t face = static_cast<size_t>(size) * static_cast<size_t>(size) * 3;
  for (size_t i = 0; i < 6; ++i) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(i), 0, kSmoothRgb, size, size, 0, GL_RGB,
                 GL_FLOAT, texels.data() + i * face);
  }
  clamp_to_edge(GL_TEXTURE_CUBE_MAP);
}

}  // namespace

void GpuCloth::upload_tables() {
  if (albedo_.name()) return;
  const LightTables& tables = light_tables();
  glBindTexture(GL_TEXTURE_3D, albedo_.get());
  glTexImage3D(GL_TEXTURE_3D, 0, kSmoothRgba, tables.albedo.nx, tables.albedo.ny, tables.albedo.nz, 0, GL_RGBA,
               GL_FLOAT, tables.albedo.values.data());
  clamp_to_edge(GL_TEXTURE_3D);
  glBindTexture(GL_TEXTURE_2D, albedo_mean_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, kSmoothRg, tables.albedo_mean.nx, tables.albedo_mean.ny, 0, GL_RG, GL_FLOAT,
               tables.albedo_mean.values.data());
  clamp_to_edge(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, fuzz_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, kSmoothRgba, tables.fuzz.nx, tables.fuzz.ny, 0, GL_RGBA, GL_FLOAT,
               tables.fuzz.values.data());
  clamp_to_edge(GL_TEXTURE_2D);
}

template <class Texture>
void GpuCloth::upload_maps(size_t k, Texture& front, Texture& back) {
  layers_[k] = front.layers;
  if (!front.layers) return;
  glBindTexture(GL_TEXTURE_2D_ARRAY, textures_[k].get());
  for (int level = 0; level < static_cast<int>(front.levels.size()); ++level) {
    glTexImage3D(GL_TEXTURE_2D_ARRAY, level, kFormats[k].internal, front.level_width(level), front.level_height(level),
                 front.layers + back.layers, 0, kFormats[k].layout, kFormats[k].type, nullptr);
  }
  filter_as_tile(static_cast<int>(front.levels.size()));
  bytes_ += upload_face(front, kFormats[k], 0);
  free_texels(front);
  bytes_ += upload_face(back, kFormats[k], layers_[k]);
  free_texels(back);
}

void GpuCloth::upload_rest(const PackedCloth& cloth) {
  if (cloth.front.cube_size > 0) {
    upload_cube(cubes_[0], cloth.front.half_cube, cloth.front.cube_size);
    upload_cube(cubes_[1], cloth.front.difference_cube, cloth.front.cube_size);
    upload_cube(cubes_[2], cloth.back.half_cube, cloth.back.cube_size);
    upload_cube(cubes_[3], cloth.back.difference_cube, cloth.back.cube_size);
    opengl::use_seamless_cubes();
  }
  has_threads_ = cloth.has_threads();
  thread_kind_.computed = !cloth.strips.empty();
  if (!cloth.crossings.empty()) upload_crossings(cloth);
  if (!cloth.strips.empty()) upload_strips(cloth);
  if (has_threads_) bytes_ += cloth.lobes.threads.size() * sizeof(glm::uvec4);
  upload_lobes(cloth.lobes);
}

void GpuCloth::upload_crossings(const PackedCloth& cloth) {
  crossing_blocks_ = (cloth.ends + CROSSING_BLOCK - 1) / CROSSING_BLOCK;
  crossing_layers_ = crossing_blocks_ * ((cloth.picks + CROSSING_BLOCK - 1) / CROSSING_BLOCK);
  glBindTexture(GL_TEXTURE_2D_ARRAY, crossings_.get());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, std::min(cloth.ends, CROSSING_BLOCK),
               std::min(cloth.picks, CROSSING_BLOCK), crossing_layers_ * (cloth.asides.empty() ? 1 : 2), 0, GL_RGBA,
               GL_HALF_FLOAT, nullptr);
  as_table(GL_TEXTURE_2D_ARRAY);
  const CellRect all{0, cloth.ends, 0, cloth.picks};
  upload_crossings(all, cloth.crossings, 0);
  if (!cloth.asides.empty()) upload_crossings(all, cloth.asides, crossing_layers_);
  bytes_ += (cloth.crossings.size() + cloth.asides.size()) * sizeof(HalfCrossing);
}

void GpuCloth::upload_strips(const PackedCloth& cloth) {
  constexpr size_t kWidth = STRIP_MAP_WIDTH, kHeight = STRIP_MAP_HEIGHT;
  const size_t rows = (cloth.strips.size() + kWidth - 1) / kWidth, layers = (rows + kHeight - 1) / kHeight;
  glBindTexture(GL_TEXTURE_2D_ARRAY, crossings_.get());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32UI, STRIP_MAP_WIDTH, static_cast<GLsizei>(std::min(rows, kHeight)),
               static_cast<GLsizei>(layers), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  as_table(GL_TEXTURE_2D_ARRAY);
  upload_strips(0, cloth.strips);
  bytes_ += cloth.strips.size() * sizeof(uint32_t);
}

/// Uploads strips in the rows of their map: the rest of a begun row, whole rows of a layer, or the begin of a row.
void GpuCloth::upload_strips(size_t first, const std::vector<uint32_t>& strips) {
  constexpr size_t kWidth = STRIP_MAP_WIDTH, kHeight = STRIP_MAP_HEIGHT;
  glBindTexture(GL_TEXTURE_2D_ARRAY, crossings_.get());
  for (size_t done = 0; done < strips.size();) {
    const size_t x = (first + done) % kWidth, row = (first + done) / kWidth, left = strips.size() - done;
    const bool part = x > 0 || left < kWidth;
    const size_t columns = part ? std::min(kWidth - x, left) : kWidth;
    const size_t rows = part ? 1 : std::min(kHeight - row % kHeight, left / kWidth);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(x), static_cast<GLint>(row % kHeight),
                    static_cast<GLint>(row / kHeight), static_cast<GLsizei>(columns), static_cast<GLsizei>(rows), 1,
                    GL_RED_INTEGER, GL_UNSIGNED_INT, strips.data() + done);
    done += columns * rows;
  }
}

template <class Cloth>
void GpuCloth::upload_all(Cloth& cloth) {
  upload_tables();
  width_mm_ = cloth.width_mm, depth_mm_ = cloth.depth_mm, mean_spacing_mm_ = cloth.mean_spacing_mm;
  bytes_ = 0;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (GlTexture& texture : textures_) texture.reset();  // free the old ones' memory before allocating the new
  crossings_.reset();
  for (size_t k = 0; k < kPackedKinds; ++k) {
    upload_maps(k, cloth.front.textures[k], cloth.back.textures[k]);
  }
  upload_rest(cloth);
}

void GpuCloth::upload(const PackedCloth& cloth) { upload_all(cloth); }

void GpuCloth::upload(PackedCloth&& cloth) { upload_all(cloth); }

/// Uploads a rectangle of crossings, block by block.
void GpuCloth::upload_crossings(const CellRect& cells, const std::vector<HalfCrossing>& texels, int first_layer) {
  glBindTexture(GL_TEXTURE_2D_ARRAY, crossings_.get());
  const int row = cells.end1 - cells.end0;
  glPixelStorei(GL_UNPACK_ROW_LENGTH, row);
  for (int p = cells.pick0; p < cells.pick1; p = (p / CROSSING_BLOCK + 1) * CROSSING_BLOCK) {
    const int picks = std::min(cells.pick1, (p / CROSSING_BLOCK + 1) * CROSSING_BLOCK) - p;
    for (int e = cells.end0; e < cells.end1; e = (e / CROSSING_BLOCK + 1) * CROSSING_BLOCK) {
      const int ends = std::min(cells.end1, (e / CROSSING_BLOCK + 1) * CROSSING_BLOCK) - e;
      const size_t first =
          static_cast<size_t>(p - cells.pick0) * static_cast<size_t>(row) + static_cast<size_t>(e - cells.end0);
      glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, e % CROSSING_BLOCK, p % CROSSING_BLOCK,
                      first_layer + p / CROSSING_BLOCK * crossing_blocks_ + e / CROSSING_BLOCK, ends, picks, 1, GL_RGBA,
                      GL_HALF_FLOAT, texels.data() + first);
    }
  }
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void GpuCloth::upload_threads(const std::vector<glm::uvec4>& records) {
  const bool computed = thread_kind_.computed;
  thread_kind_ = render_data::thread_kind(records);
  thread_kind_.computed = computed;
  glBindTexture(GL_TEXTURE_2D, threads_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, THREAD_MAP_WIDTH, static_cast<GLsizei>(records.size() / THREAD_MAP_WIDTH),
               0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, records.data());
  as_table(GL_TEXTURE_2D);
}

void GpuCloth::upload(const ClothPatches& patches) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (const CrossingPatch& p : patches.crossings) {
    upload_crossings(p.cells, p.texels, 0);
    if (!p.asides.empty()) upload_crossings(p.cells, p.asides, crossing_layers_);
  }
  for (const StripPatch& p : patches.strips) upload_strips(p.first, p.strips);
  for (const PackedPatch& p : patches.maps) {
    const size_t k = static_cast<size_t>(p.kind);
    if (!layers_[k] || p.width <= 0 || p.height <= 0) continue;
    glBindTexture(GL_TEXTURE_2D_ARRAY, textures_[k].get());
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, p.level, p.x, p.y, p.face == Face::kFront ? 0 : layers_[k], p.width, p.height,
                    layers_[k], kFormats[k].layout, kFormats[k].type, p.texels.data());
  }
}

void GpuCloth::upload_lobes(const ClothLobes& lobes) {
  data_ = lobes.data;
  errors_ = lobes.errors;
  glBindBuffer(GL_UNIFORM_BUFFER, block_.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof data_, &data_, GL_DYNAMIC_DRAW);
  if (!lobes.threads.empty()) upload_threads(lobes.threads);
  if (!lobes.response.empty()) upload_response(lobes.response);
}

void GpuCloth::upload_response(const ResponseTables& tables) {
  glBindTexture(GL_TEXTURE_2D_ARRAY, response_.get());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, kResponseWidth, kResponseHeight, kResponseViews, 0, GL_RGBA,
               GL_FLOAT, tables.reflected.data());
  clamp_to_edge(GL_TEXTURE_2D_ARRAY);
  glBindTexture(GL_TEXTURE_2D, slopes_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R16F, kSlopeBins, kSlopeRows, 0, GL_RED, GL_FLOAT, tables.slopes.data());
  clamp_to_edge(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, views_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, kViewTableWidth, kViewTableHeight, 0, GL_RGBA, GL_FLOAT,
               tables.views.data());
  clamp_to_edge(GL_TEXTURE_2D);
}

void GpuCloth::bind() {
  for (size_t k = 0; k < kPackedKinds; ++k) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(kFormats[k].slot));
    glBindTexture(GL_TEXTURE_2D_ARRAY, textures_[k].name());
  }
  const auto bind_to = [](int slot, GLenum target, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(slot));
    glBindTexture(target, texture.name());
  };
  bind_to(kThreadSlot, GL_TEXTURE_2D, threads_);
  bind_to(kCrossingSlot, GL_TEXTURE_2D_ARRAY, crossings_);
  bind_to(kAlbedoSlot, GL_TEXTURE_3D, albedo_);
  bind_to(kAlbedoMeanSlot, GL_TEXTURE_2D, albedo_mean_);
  bind_to(kFuzzSlot, GL_TEXTURE_2D, fuzz_);
  bind_to(kResponseSlot, GL_TEXTURE_2D_ARRAY, response_);
  bind_to(kSlopesSlot, GL_TEXTURE_2D, slopes_);
  bind_to(kViewSlot, GL_TEXTURE_2D, views_);
  for (int i = 0; i < 4; ++i) bind_to(kFrontHalfSlot + i, GL_TEXTURE_CUBE_MAP, cubes_[static_cast<size_t>(i)]);
  glBindBufferBase(GL_UNIFORM_BUFFER, kClothBinding, block_.get());
}

}  // namespace weftlight::gl
