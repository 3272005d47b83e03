#pragma once
// The OpenGL renderer of the draped, lit cloth, the same for the window and for `render`.
// All calls need a current OpenGL 3.3+ core context (context.h, or the window's).

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "design/design.h"
#include "drape/mesh.h"
#include "files/files.h"
#include "light/formulas.h"
#include "light/lod_table.h"
#include "render_data/ambient.h"
#include "render_data/map_patch.h"
#include "render_data/method_weights.h"
#include "render_data/packed_maps.h"
#include "scene/light_rig.h"

namespace weftlight::gl {

using design::Look, design::Method, design::Scene;
using draft::Face;
using drape::Mesh;
using files::Image;
using light::LodTable;
using render_data::ClothLobes, render_data::ClothPatches, render_data::FlatPatch, render_data::PackedCloth,
    render_data::PreparedMesh, render_data::VisiblePart, render_data::prepare_mesh;
using scene::LightRig;

struct Frame {
  int width = 0, height = 0;  // pixels of the finished picture
  float render_scale = 1.0f;  // < 1: fewer pixels while the view moves, upscaled
  // > 0: overrides the scene's distance so that the centre of the picture has this footprint.
  float yarns_per_pixel = 0;
  Face front = Face::kFront;  // which face is shown on the front of the mesh
  bool ground = true;         // the ground with the cloth's shadow
  bool cloth = true;          // false: everything except the cloth, for the ray-traced one
  bool transparent = false;   // no background (alpha 0)
  bool false_color_methods = false;
  // Samples a pixel of method yarn: as many as the tolerance needs, at most `samples`. A picture may be the mean of
  // several passes with that many each (pass < 0: a single one); `pass_weight`: of this pass in the mean so far;
  // `all_samples`: in all passes.
  int samples = formulas::kMaxYarnSamples, pass = -1;
  float pass_weight = 1;
  int all_samples = formulas::kMaxYarnSamples;
  bool exact_samples = false;  // not by tolerance: the largest lattice of at most `samples`
  bool timed = false;          // wait for the cloth on a software renderer, to measure gpu_ms there, too
  // Wait for no shader: while the driver of a graphics card compiles the right program on threads of its own, a coarser
  // one draws.
  bool at_once = false;
  // On a software renderer the cloth is drawn in bands, and after each this is called with the part that is done, 0..1:
  // the first time when its program is compiled. A card needs no such thing, and does not call it. Empty: in one piece.
  std::function<void(float)> progress{};
};

struct FrameStats {
  double gpu_ms = 0;              // the cloth's pass: timer query, or the clock of a timed frame
  bool first_of_program = false;  // its program was drawn with for the first time: gpu_ms has the compiler's time, too
  bool compiling = false;         // a coarser program drew, and gpu_ms is its time
  double shaded_pixels = 0;
  float yarns_per_pixel = 0;      // footprint at the centre of the picture
  Method method = Method::kAuto;  // the method that was drawn
  size_t texture_bytes = 0;
  std::array<float, 4> method_weights{};  // of the visible cloth under auto: yarn, cell, repeat, cloth
  double flyaway_ms = 0;                  // flyaway fibres, not in gpu_ms
  size_t flyaways = 0;                    // number of flyaway fibres
  float estimated_error = 0;              // by the LOD table, at the mean footprint
  float exposure_ev = 0;                  // exposure of the picture; a scene-linear one has only that of the look
  base::Result<void> cloth;               // or why it is not drawn
};

class Renderer {
 public:
  /// Compiles the shaders of shaders/, but for the cloth's on a graphics card, of which each takes its driver seconds.
  static base::Result<std::unique_ptr<Renderer>> create();
  ~Renderer();

  /// prepare_mesh (ambient.h) takes 0.2 to 0.4 s for a drape; the window runs it on its worker.
  void set_mesh(PreparedMesh mesh);
  void set_mesh(const Mesh& mesh) { set_mesh(prepare_mesh(mesh)); }
  /// The studio until the first call.
  void set_lights(LightRig lights);
  /// Corrections that were made to the environment map.
  const std::vector<std::string>& light_remarks() const;
  /// New maps of both faces, or patches of the current maps (packed_maps.h).
  void upload(const PackedCloth& cloth);
  /// The same; each map is freed as soon as it is uploaded, so that a large one is not in memory twice.
  void upload(PackedCloth&& cloth);
  void upload(const ClothPatches& patches);
  void upload_lobes(const ClothLobes& lobes);

  /// Draws into the renderer's own target; texture() holds sRGB-encoded RGBA8 until the next draw. Costs in the result
  /// are of the last frame whose queries are available, so that nothing waits.
  FrameStats draw(const Scene& scene, const Look& look, const Frame& frame);
  /// Costs of the last draw; waits for it.
  FrameStats measure();
  unsigned texture() const;
  /// The last picture, row 0 on top: sRGB-encoded RGBA (linear: scene-linear before tone mapping).
  Image read_back(bool linear = false) const;
  /// The last picture as sRGB-encoded RGBA8, row 0 at the bottom.
  void read_pixels(std::vector<uint32_t>& pixels) const;

  /// The tolerance at which method auto would draw the last picture within a time budget for the cloth's pass, from
  /// what that pass took; 0 if that was not measured. Waits for it.
  float tolerance_within(float budget_ms);
  /// The LOD table of method auto; the shipped one until the first call.
  void set_lod_table(const LodTable& lod_table);
  /// The visible part of the cloth in the last picture, at full resolution.
  VisiblePart visible_part() const;
  /// Software rendering (Mesa's llvmpipe).
  bool is_software() const;
  /// For tests: as on a graphics card whose driver has not compiled what is drawn from now on.
  void hold_programs(bool held);
  /// Whether the shipped LOD table was read; without it the built-in one is used.
  const base::Result<void>& lod_table_read() const;
  /// Graphics card and driver.
  std::string device() const;

  /// Draws a flat patch of the cloth under the key light only: no sky, no ground, no shadow of folds. measure() gives
  /// its cost, read_patch() its scene-linear pixels, premultiplied by alpha.
  void draw_patch(const FlatPatch& patch, const Look& look);
  Image read_patch() const;

 private:
  Renderer();
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weftlight::gl
