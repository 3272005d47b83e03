#pragma once
// Design -> drawdown -> cloth -> maps -> packed maps -> renderer, on a worker thread. Each stage is keyed
// by its input: what an edit did not touch is not computed again, and a painted cell re-bakes a rectangle.
// The window shows the last good result and never waits.

#include <memory>
#include <string>

#include "draft/design.h"
#include "gl/names.h"
#include "gl/renderer.h"

namespace weftlight::gl {

class Pipeline {
 public:
  Pipeline();
  ~Pipeline();

  /// From the thread that edits: the newest design wins, those between are skipped.
  void submit(std::shared_ptr<const Design> design);
  /// What the picture shows: quick answers to edits of many cells are made for it.
  void set_visible_part(const VisiblePart& visible);
  /// From the thread with the GL context: uploads what is finished (maps, patches, a new mesh).
  /// True when the picture must be drawn again.
  bool poll(Renderer& renderer);
  /// Until the last submitted design is computed; poll() then uploads it.
  void wait() const;
  /// Headless: waits until the last submitted design is ready, then uploads it. Empty: done; else what
  /// went wrong (a mesh that cannot be read).
  std::string finish(Renderer& renderer);
  /// Problem of the last design, if any (shown by the window).
  std::string problem() const;
  /// Until the last of what was submitted is computed and taken up.
  bool busy() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Without a worker, for one picture: computes, uploads and keeps nothing but what was uploaded. Returns as finish().
std::string upload_once(std::shared_ptr<const Design> design, Renderer& renderer);

}  // namespace weftlight::gl
