#pragma once
// Maps as the GPU reads them: packed texels with prefiltered mips, made on the CPU by the worker, so that
// the thread with the GL context only uploads.

#include <cstdint>
#include <vector>

#include "cloth/maps.h"

namespace weftlight {

/// One texture: `levels[0]` is the finest; rows tightly packed.
struct PackedTexture {
  int width = 0, height = 0, layers = 1, channels = 4;
  bool half = false;  // false: unorm8, true: half float (two bytes a channel)
  std::vector<std::vector<uint8_t>> levels;
};

struct PackedFace {
  std::vector<PackedTexture> textures;  // slots as in shaders/interop.h
};

/// Everything of a design that the renderer needs beside mesh, scene and look.
struct PackedCloth {
  float width_mm = 0, depth_mm = 0;
  float mean_spacing_mm = 0;  // of a yarn, both systems: what "yarns a pixel" counts
  PackedFace front, back;
  std::vector<float> lobes;   // std140 block of the yarns' lobes and tables (shaders/interop.h)
};

/// A rectangle of one level of one texture of one face.
struct PackedPatch {
  Face face = Face::kFront;
  int texture = 0, level = 0;
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<uint8_t> texels;  // all layers, layer by layer
};

}  // namespace weftlight
