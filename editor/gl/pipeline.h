#pragma once
// Design -> drawdown -> cloth -> maps -> packed maps -> renderer, on a worker thread. Each stage is keyed by its
// input: what an edit did not touch is not computed again, and a painted cell rebakes a rectangle. A full update stops
// for a newer design. The window shows the last good result and never waits.

#include <cstdint>
#include <memory>

#include "base/result.h"
#include "design/design.h"
#include "gl/renderer.h"
#include "render_data/stage_list.h"

namespace weftlight::gl {

using design::Design;
using render_data::StageWatch, render_data::VisiblePart;

class Pipeline {
 public:
  Pipeline();
  ~Pipeline();

  /// From the editing thread: the newest design is computed, those between are skipped. `draft`: which draft it is of.
  /// That of another begins anew, so that its first picture has nothing of the last one's cloth.
  void submit(std::shared_ptr<const Design> design, uint64_t draft = 0);
  /// The visible part, for quick updates after edits of many cells.
  void set_visible_part(const VisiblePart& visible);
  /// From the thread with the GL context: uploads what is finished (maps, patches, a new mesh). True if the picture
  /// must be drawn again, or is now that of another design.
  bool poll(Renderer& renderer);
  /// Waits until the last submitted design is computed; poll() then uploads it.
  void wait() const;
  /// Headless: waits until the last submitted design is ready and uploads it. An error if, for
  /// one, a mesh cannot be read.
  base::Result<void> finish(Renderer& renderer);
  /// The design that the renderer has, with its mesh and at least its quick maps; null before the first.
  std::shared_ptr<const Design> uploaded() const;
  /// Whether all of the last design could be made (the error is shown by the window).
  base::Result<void> made() const;
  /// Whether a submitted design is not yet computed and uploaded.
  bool busy() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// For a single picture, without a worker: computes and uploads, and keeps nothing else. Returns as finish(), or, where
/// it was stopped, an error of kCancelled. cloth: false for pictures without it, whose far field is coarse.
base::Result<void> upload_once(std::shared_ptr<const Design> design, Renderer& renderer, const StageWatch& watch = {},
                               bool cloth = true);

}  // namespace weftlight::gl
