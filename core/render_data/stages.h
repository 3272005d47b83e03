#pragma once
// The stages that the worker derives from a design, cached so that only what an edit affects is computed again.
// Without threads and OpenGL.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cloth/maps.h"
#include "design/design.h"
#include "render_data/ambient.h"
#include "render_data/method_weights.h"
#include "render_data/names.h"
#include "render_data/packed_maps.h"
#include "scene/light_rig.h"

namespace weftlight::render_data {

/// Changes of one update for the renderer; empty parts did not change.
struct StageResult {
  std::optional<PreparedMesh> mesh;
  std::optional<LightRig> lights;
  bool all_maps = false;  // packed() is new as a whole
  ClothPatches patches;
  std::optional<ClothLobes> lobes;
  std::string problem;
};

/// The period of the maps: the whole draft if its threads get enough texels, else one repeat.
Period choose_period(const Design& design, const BitMatrix& cells);
/// Whether its yarns are so uneven that a repeat of a few threads is not representative.
bool is_uneven(const Design& design);

/// The cloth of one face. The back is mapped in the front's (u, v) and seen mirrored, so the twist of its yarns is
/// reversed there, to be the same in space.
Cloth face_cloth(const Design& design, const BitMatrix& cells, Face face, Period period);

/// kQuick: for the next frame. Full bakes use few texels and threads; painted cells update only the front, and of many
/// only the visible part; the far-field response is kept; sky visibility uses few rays. kFull brings everything up to
/// date. kOnce: like kFull for a single picture; only packed() is kept, and the next design is computed from scratch.
enum class Effort { kQuick, kFull, kOnce };

class Stages {
 public:
  /// The visible part, for quick updates.
  void set_visible_part(const VisiblePart& part) { visible_ = part; }
  StageResult update(std::shared_ptr<const Design> design, Effort effort = Effort::kFull);
  const PackedCloth& packed() const { return packed_; }
  /// Moves the result out, after kOnce.
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
  VisiblePart visible_;
  bool few_rays_ = false;   // the sky visibility of the mesh is from few rays
  bool previewed_ = false;  // preview patches were sent that packed_ does not contain
  std::string mesh_name_, mesh_problem_, lights_name_, lights_problem_;
  BitMatrix cells_;
  Period period_ = Period::kWholeDraft;
  FaceState front_, back_;
  PackedCloth packed_;
  bool shadows_ = false;
  bool engine_ = false;        // the exported material is computed, for method `engine`
  float top_mm_ = 0;           // bound of the threads' heights
  bool coarse_ = false;        // the maps are from a quick bake
  bool old_back_ = false;      // the back's maps are of an earlier draft
  bool old_response_ = false;  // the far-field response is of an earlier design
};

}  // namespace weftlight::render_data
