#pragma once
// Sky visibility of each vertex of the cloth (both sides) and of the body, and of each point of the ground: ambient
// occlusion in folds and the contact shadow. Where cloth faces the body, what the body sends on of the sky's light
// counts as sky, so that the inside of a waistband or collar is not black. By rays; deterministic, for the worker
// thread.

#include <cstdint>
#include <string>
#include <vector>

#include "drape/mesh.h"
#include "scene/camera.h"

namespace weftlight::render_data {

using drape::Mesh;
using scene::Bounds;

/// Visible fraction of the cosine-weighted sky, with what the body sends on of it, 0..1, on the side of the normal and
/// on the other.
struct SkyVisibility {
  float front = 1, back = 1;
};

/// A mesh prepared for the renderer.
struct PreparedMesh {
  Mesh mesh, body;  // body: the form under the cloth; may be empty
  std::vector<SkyVisibility> sky, body_sky;
  // Triangles to draw: normally all of them, or of very many as few as keep the weave in place; `coarse` while the
  // view moves. A software renderer spends its time on small triangles.
  std::vector<uint32_t> fine, coarse, body_fine;
  Bounds bounds;                    // of the cloth
  float ground_mm = 0;              // height of the ground
  float ground_half_mm = 0;         // half width of the square of ground_sky, about the centre
  int ground_size = 0;              // texels a side
  std::vector<uint8_t> ground_sky;  // unorm8, row 0 at low z
};

/// kFew: few rays, for a first picture.
enum class SkyRays { kFew, kAll };
PreparedMesh prepare_mesh(const Mesh& mesh, SkyRays rays = SkyRays::kAll);

/// Reflectance of the form (FORM_REFLECTANCE of interop.h).
glm::vec3 form_reflectance();

/// The form under a shipped drape, where cloth lies over it slightly thinner than the one that it was draped on, so
/// that it never shows through; for renderer and ray tracer. Empty for other meshes. `cloth`: the drape.
Mesh form_under(const std::string& drape, const Mesh& cloth);

}  // namespace weftlight::render_data
