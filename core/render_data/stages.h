#pragma once
// The way of the data from a design to the renderer: a list of stages (stages.cpp), of which an update runs those whose
// key changed. Without threads of its own and without OpenGL.

#include <memory>
#include <utility>

#include "design/design.h"
#include "render_data/method_weights.h"
#include "render_data/stage_data.h"
#include "scene/light_rig.h"

namespace weftlight::render_data {

using design::Design;

class Stages {
 public:
  explicit Stages(const Fineness& fineness = {}) : fineness_(fineness) {}
  /// The visible part, for quick updates.
  void set_visible_part(const VisiblePart& part) { visible_ = part; }
  /// Returns what changed for the renderer since the last update that was not stopped.
  StageResult update(std::shared_ptr<const Design> design, Effort effort = Effort::kFull, const StageWatch& watch = {});
  const PackedCloth& packed() const { return data_.packed; }
  /// Moves the result out, after kOnce.
  PackedCloth release_packed() { return std::exchange(data_.packed, {}); }

 private:
  StageInput next_input(std::shared_ptr<const Design> design) const;
  bool preview(Effort effort);
  StageResult hand_over(bool preview_only, Effort effort);

  Fineness fineness_;
  VisiblePart visible_;
  StageInput input_;                    // of the last update
  std::shared_ptr<const Design> done_;  // the last design that all stages showed; null after a problem
  StageKeys keys_;
  StageData data_;
  StageResult result_;      // not yet handed over
  bool previewed_ = false;  // the renderer shows a preview, which is not in packed()
};

}  // namespace weftlight::render_data
