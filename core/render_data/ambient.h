#pragma once
// How much of the sky each vertex of the cloth (both sides), each vertex of the body and each point of the
// ground sees: soft light in folds and the contact shadow. By rays; deterministic, for the worker thread.

#include <cstdint>
#include <string>
#include <vector>

#include "drape/mesh.h"
#include "render_data/camera.h"
#include "render_data/names.h"

namespace weftlight::render_data {

/// Share of the cosine-weighted sky that is seen, 0..1, on the side of the normal and behind it.
struct SkySeen {
  float front = 1, back = 1;
};

/// A mesh made ready for the renderer.
struct PreparedMesh {
  Mesh mesh, body;  // body: what the cloth hangs on; may be empty
  std::vector<SkySeen> sky, body_sky;
  // Triangles to draw: at rest all of them, or of very many as few as keep the weave in its place; fewer while the view
  // moves. Small triangles are what a software renderer spends its time on.
  std::vector<uint32_t> fine, coarse, body_fine;
  Bounds bounds;                    // of the cloth
  float ground_mm = 0;              // height of the ground
  float ground_half_mm = 0;         // half width of the square that ground_sky stands over, about the centre
  int ground_size = 0;              // texels a side
  std::vector<uint8_t> ground_sky;  // unorm8, row 0 at low z
};

/// kFew: by few rays, for a first picture.
enum class SkyRays { kFew, kAll };
PreparedMesh prepare_mesh(const Mesh& mesh, SkyRays rays = SkyRays::kAll);

/// What a shipped drape hangs on, a little thinner than the cloth found it, so that it never shows through; drawn and
/// traced alike. Empty for other meshes. `cloth`: the drape's bounds.
Mesh form_under(const std::string& drape, const Bounds& cloth);

}  // namespace weftlight::render_data
