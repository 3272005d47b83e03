#pragma once
// What the worker of the pipeline derives from a design, kept between designs so that only what an edit
// touched is computed again. Knows no thread and no OpenGL.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cloth/maps.h"
#include "draft/design.h"
#include "preview/ambient.h"
#include "preview/packed_maps.h"

namespace weftlight {

/// What one step changed, ready for the renderer; empty parts did not change.
struct StageResult {
  std::optional<PreparedMesh> mesh;
  bool all_maps = false;               // packed() is new as a whole
  std::vector<PackedPatch> patches;
  std::vector<float> lobes;
  std::string problem;
};

/// What the maps hold: the whole draft where its threads get enough texels, else one repeat.
Period choose_period(const Design& design, const BitMatrix& cells);

class Stages {
 public:
  StageResult update(std::shared_ptr<const Design> design);
  const PackedCloth& packed() const { return packed_; }

 private:
  struct FaceState {
    Cloth cloth;
    Maps maps;
  };
  void bake_all(const Design& design, bool shadows);
  bool bake_cells(const Design& design, const CellRect& dirty, StageResult& result);
  void take_lobes(const Design& design, StageResult& result);

  std::shared_ptr<const Design> done_;
  std::string mesh_name_;
  BitMatrix cells_;
  Period period_ = Period::kWholeDraft;
  FaceState front_, back_;
  PackedCloth packed_;
  bool shadows_ = false;
};

}  // namespace weftlight
