#pragma once
// The preview of the cloth where there is one GL context and one thread that may use it, as in a browser: the same
// pictures as PreviewPane's, drawn by poll() in the window's own context, a pass at a time. Maps are computed on the
// pipeline's thread as ever. Where the context was lost and is there again, the next poll() begins anew.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "app/drawn_picture.h"
#include "app/picture_maker.h"
#include "gl/pipeline.h"
#include "gl/reset_watch.h"

namespace weftlight::app {

class PreviewSlices {
 public:
  /// `wake` is not needed: the window asks poll() before each frame. Needs the window's GL context.
  explicit PreviewSlices(const std::function<void()>& wake);
  PreviewSlices(const PreviewSlices&) = delete;
  PreviewSlices& operator=(const PreviewSlices&) = delete;

  void submit(std::shared_ptr<const Design> design, const ClothSubject& subject = {});
  /// Replaces the earlier request.
  void ask(const PictureRequest& request, bool moving);
  /// Draws what is due, for the time of one pass; true if there is something to show. Needs the window's GL context.
  bool poll();
  PreviewPicture picture() const { return shown_.picture(); }

 private:
  bool make();
  /// False if the context is lost again and again.
  bool begin_anew();

  gl::ResetWatch watch_;
  gl::LostContexts lost_;
  double begun_s_;
  bool given_up_ = false;
  std::optional<gl::Pipeline> pipeline_;
  std::unique_ptr<PictureMaker> maker_;  // once the window has shown itself
  std::shared_ptr<const Design> design_;
  uint64_t draft_ = 0;  // that it is of
  bool new_design_ = false, new_request_ = false, moving_ = false, failed_ = false;
  std::optional<PictureRequest> request_;
  double next_s_ = 0;  // when there is more to do; negative: when it is asked for
  ShownPicture shown_;
};

}  // namespace weftlight::app
