#pragma once
// The OpenGL renderer of the draped, lit cloth, the same for the window and for `render`.
// All calls need a current OpenGL 3.3+ core context (context.h, or the window's).

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "draft/design.h"
#include "drape/mesh.h"
#include "files/files.h"
#include "gl/names.h"
#include "light/formulas.h"
#include "light/lod_table.h"
#include "render_data/ambient.h"
#include "render_data/light_rig.h"
#include "render_data/map_patch.h"
#include "render_data/method_weights.h"
#include "render_data/packed_maps.h"

namespace weftlight::gl {

struct Frame {
  int width = 0, height = 0;  // pixels of the finished picture
  float render_scale = 1.0f;  // < 1: fewer pixels while something moves, upscaled
  float yarns_per_pixel =
      0;  // > 0: overrides the scene's distance so that the middle of the picture has this footprint
  Face front = Face::kFront;  // which face is shown on the front of the mesh
  bool ground = true;         // ground with the cloth's shadow
  bool cloth = true;          // false: everything but the cloth (the ray-traced one is laid over it)
  bool transparent = false;   // leave the background out (alpha 0)
  bool false_color_methods = false;
  // Samples a pixel of rung yarn: as many as the tolerance asks for, and no more than these. A picture may be the mean
  // of several passes, each with so many (pass < 0: this one alone); `share`: of this pass in the mean of those so far;
  // `all_samples`: of all of them.
  int samples = formulas::kMaxYarnSamples, pass = -1;
  float share = 1;
  int all_samples = formulas::kMaxYarnSamples;
  bool exact_samples = false;  // not by tolerance: the largest lattice of no more than `samples`
  bool timed = false;          // wait for the cloth on a software renderer, so that gpu_ms is measured there too
};

struct FrameStats {
  double gpu_ms = 0;  // the cloth's pass: timer query, or the clock of a timed frame
  double shaded_pixels = 0;
  float yarns_per_pixel = 0;      // footprint at the middle of the picture
  Method method = Method::kAuto;  // what was drawn
  size_t texture_bytes = 0;
  std::array<float, 4> method_weights{};  // of the cloth on screen under auto: yarn, cell, repeat, cloth
  double flyaway_ms = 0;                  // stray fibres, beside gpu_ms
  size_t flyaways = 0;                    // of them drawn
  float estimated_error = 0;              // by the ladder, of what was drawn, at the mean footprint
  float exposure_ev = 0;                  // that the picture is shown at; a scene-linear one has the look's alone
  std::string problem;                    // why the cloth is not there; empty: it is
};

class Renderer {
 public:
  /// Compiles the shaders of shaders/. Null with `error` set when they do not build.
  static std::unique_ptr<Renderer> create(std::string& error);
  ~Renderer();

  /// prepare_mesh (ambient.h) takes a fifth to two fifths of a second for a drape: the window does it on its worker.
  void set_mesh(PreparedMesh mesh);
  void set_mesh(const Mesh& mesh) { set_mesh(prepare_mesh(mesh)); }
  /// The studio until then.
  void set_lights(LightRig lights);
  /// What was set right in the picture of the light.
  const std::vector<std::string>& light_remarks() const;
  /// New maps of both faces, or patches of the maps that are there (packed_maps.h).
  void upload(const PackedCloth& cloth);
  /// The same; each map is given up as soon as the graphics library has it, so that a large one is not held twice.
  void upload(PackedCloth&& cloth);
  void upload(const ClothPatches& patches);
  void upload_lobes(const ClothLobes& lobes);

  /// Draws into the renderer's own target; texture() holds sRGB-encoded RGBA8 until the next draw.
  /// Costs in the result are those of the last frame whose queries are done, so that nothing waits.
  FrameStats draw(const Scene& scene, const Look& look, const Frame& frame);
  /// The costs of the last draw; waits for it.
  FrameStats measure();
  unsigned texture() const;
  /// The last picture, row 0 on top: sRGB-encoded RGBA (linear: scene-linear before tone mapping).
  Image read_back(bool linear = false) const;
  /// The last picture's bytes as the screen takes them: sRGB-encoded RGBA8, row 0 at the bottom.
  void read_pixels(std::vector<uint32_t>& pixels) const;

  /// The tolerance at which rung auto draws the last picture again within so many milliseconds of the cloth's pass, by
  /// what its own pass took; 0 where that was not measured. Waits for it.
  float tolerance_within(float budget_ms);
  /// What rung auto chooses by; the shipped ladder until then.
  void set_lod_table(const LodTable& lod_table);
  /// What the last picture showed of the cloth, at all its pixels.
  SeenPart seen() const;
  /// Drawn by the processor (Mesa's llvmpipe).
  bool is_software() const;
  /// What is wrong with the shipped ladder; the built-in one then chooses the methods.
  const std::string& lod_table_problem() const;
  /// Graphics card and driver.
  std::string device() const;

  /// Draws a flat patch of the cloth's front, key light alone: no sky, no ground, no shadow of folds. measure()
  /// gives its cost; read_patch() its scene-linear pixels, premultiplied by alpha.
  void draw_patch(const FlatPatch& patch, const Look& look);
  Image read_patch() const;

 private:
  Renderer();
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weftlight::gl
