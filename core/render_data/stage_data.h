#pragma once
// The outputs of all stages between a design and the renderer, and what changed for the renderer.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cloth/maps.h"
#include "design/design.h"
#include "draft/drawdown.h"
#include "light/measure_response.h"
#include "render_data/ambient.h"
#include "render_data/packed_maps.h"
#include "render_data/stage_list.h"
#include "render_data/thread_block.h"
#include "scene/light_rig.h"

namespace weftlight::render_data {

using cloth::Cloth, cloth::Maps, cloth::MapsSize, cloth::Period, cloth::TexelRect;
using design::Design;
using draft::BitMatrix, draft::CellRect, draft::Face;
using scene::LightRig;

/// Changes of one update for the renderer; empty parts did not change. Parts that do not depend on what failed are
/// there in spite of an error.
struct StageResult {
  std::optional<PreparedMesh> mesh;
  std::optional<LightRig> lights;
  bool all_maps = false;  // packed() is new as a whole
  ClothPatches patches;
  std::optional<ClothLobes> lobes;
  base::Result<void> made;  // or the first error
  bool stopped = false;     // nothing is handed over yet: the next update does it
};

/// How finely a full update works. Coarser ones are for tests of what is computed when, not of what is seen.
struct Fineness {
  int map_divisor = 1;  // of the sides of all maps
  int response_samples = light::kResponseSamples;
  int64_t kept_crossings = kMaxCrossings;  // of larger drafts no maps are kept: an edit bakes the windows that it needs
};

/// What stages read.
struct StageInput {
  Fineness fineness;
  std::shared_ptr<const Design> design;
  std::string drape;     // drape_key() of the design
  bool shadows = false;  // the maps of method vrst03 are wanted, from its first use on
  bool engine = false;   // the exported material is wanted, for method `engine`, from its first use on
};

/// One face of the cloth.
struct FaceData {
  Cloth cloth;
  std::optional<Cloth> mapped;  // what `maps` show, if some cells of `cloth` have changed since
  Maps maps;
  std::vector<TexelRect> rebaked;  // parts of `maps` that are not yet in the mips
  MapsSize size;                   // of the maps, which are empty once they are packed if they are not kept
  Maps means;                      // instead, some of their texels (subsampled())
};

/// What stages make.
struct StageData {
  std::shared_ptr<const Design> drawn;  // the design of `cells`
  BitMatrix cells;
  CellRect painted;  // cells that changed since the crossings were packed
  Period period = Period::kWholeDraft;
  std::array<FaceData, 2> faces;  // front, back
  bool coarse = false;            // the maps are from a quick bake
  float top_mm = 0;               // bound of the threads' heights
  PackedCloth packed;
};

/// One update, as the stages see it.
struct StageWork {
  const StageInput& input;
  Effort effort;
  StageData& data;
  StageResult& result;

  const Design& design() const { return *input.design; }
  FaceData& face(Face f) const { return data.faces[static_cast<size_t>(f)]; }
  PackedFace& packed(Face f) const { return f == Face::kFront ? data.packed.front : data.packed.back; }
  bool quick() const { return effort == Effort::kQuick; }
};

}  // namespace weftlight::render_data
