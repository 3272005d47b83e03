#pragma once
// What the worker of the pipeline derives from a design, kept between designs so that only what an edit
// touched is computed again. Knows no thread and no OpenGL.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cloth/maps.h"
#include "draft/design.h"
#include "render_data/ambient.h"
#include "render_data/light_rig.h"
#include "render_data/method_weights.h"
#include "render_data/names.h"
#include "render_data/packed_maps.h"

namespace weftlight::render_data {

/// What one step changed, ready for the renderer; empty parts did not change.
struct StageResult {
  std::optional<PreparedMesh> mesh;
  std::optional<LightRig> lights;
  bool all_maps = false;  // packed() is new as a whole
  ClothPatches patches;
  std::optional<ClothLobes> lobes;
  std::string problem;
};

/// What the maps hold: the whole draft where its threads get enough texels, else one repeat.
Period choose_period(const Design& design, const BitMatrix& cells);
/// Whether its yarn is so thick and thin that a repeat of a few threads does not stand for the cloth.
bool is_uneven(const Design& design);

/// The cloth of one face. The back is mapped in the front's (u, v) and seen mirrored, so its yarns are handed the other
/// way there to be handed the same way in space.
Cloth face_cloth(const Design& design, const BitMatrix& cells, Face face, Period period);

/// kQuick: the next frame's answer. Whole bakes are made with few texels and few threads; painted cells reach the front
/// alone, and of many only what is seen; light from afar keeps the answer that it had; a mesh has its share of the sky
/// from few rays. kFull brings all of it up to date.
/// kOnce: as kFull, for one picture: only packed() is kept, and the next design is computed anew.
enum class Effort { kQuick, kFull, kOnce };

class Stages {
 public:
  /// What quick answers are made for.
  void look(const SeenPart& seen) { seen_ = seen; }
  StageResult update(std::shared_ptr<const Design> design, Effort effort = Effort::kFull);
  const PackedCloth& packed() const { return packed_; }
  /// After kOnce: what nobody asks for again.
  PackedCloth release_packed() { return std::exchange(packed_, {}); }

 private:
  struct FaceState {
    Cloth cloth;
    Maps maps;
  };
  void update_cloth(const std::shared_ptr<const Design>& design, Effort effort, StageResult& result);
  void bake_all(const Design& design, bool shadows, Effort effort);
  Maps bake_quick(const Cloth& cloth, const MapsSize& size, const TexelRect& window) const;
  bool can_bake_preview(const Design& design) const;
  bool preview_bake(const Design& design, StageResult& result);
  void bake_preview_maps(const Cloth& cloth, StageResult& result) const;
  void bake_preview_crossings(const Cloth& cloth, StageResult& result) const;
  bool bake_cells(const Design& design, const CellRect& dirty, Effort effort, StageResult& result);
  void update_lobes(const Design& design, Effort effort, StageResult& result);
  void update_threads();
  void update_crossings(const CellRect& dirty, StageResult& result);
  void update_scene(const Design& design, Effort effort, StageResult& result);

  std::shared_ptr<const Design> done_;
  SeenPart seen_;
  bool few_rays_ = false;   // the mesh has its share of the sky from few rays
  bool previewed_ = false;  // quick patches were sent that packed_ knows nothing of
  std::string mesh_name_, mesh_problem_, lights_name_, lights_problem_;
  BitMatrix cells_;
  Period period_ = Period::kWholeDraft;
  FaceState front_, back_;
  PackedCloth packed_;
  bool shadows_ = false;
  bool engine_ = false;        // the exported material is known, for rung `engine`
  float top_mm_ = 0;           // bound of the threads' heights
  bool coarse_ = false;        // the maps are of a quick bake
  bool old_back_ = false;      // the back's maps are of an earlier draft
  bool old_response_ = false;  // the answer from afar is of an earlier design
};

}  // namespace weftlight::render_data
