#pragma once
// The preview of the cloth. It is drawn on its own thread with its own GL context, so that painting never waits for it.
// The window requests a picture and is woken when there is something new to show.

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/picture_maker.h"
#include "gl/context.h"
#include "ui/pixel_texture.h"
#include "views/cloth/preview_panel.h"

namespace weftlight::app {

using design::Design;
using gl::HeadlessContext;
using ui::PixelTexture;
using views::PreviewPicture;

/// What is seen: a picture of one is never shown for another, whose camera it would have.
struct ClothSubject {
  uint64_t document = 0;
  bool flat = false;
  bool operator==(const ClothSubject&) const = default;
};

class PreviewPane {
 public:
  /// `wake` is called on the drawing thread when poll() has a result.
  explicit PreviewPane(std::function<void()> wake);
  /// Waits for the picture in progress.
  ~PreviewPane();
  PreviewPane(const PreviewPane&) = delete;
  PreviewPane& operator=(const PreviewPane&) = delete;

  void submit(std::shared_ptr<const Design> design, const ClothSubject& subject = {});
  /// Replaces the earlier request.
  void ask(const PictureRequest& request, bool moving);
  /// Takes the newest result; true if there is something to show. Needs the window's GL context and its thread, which
  /// opens the hidden window where the drawing thread asks for one.
  bool poll();
  PreviewPicture picture() const;

 private:
  /// A result of the drawing thread. Unchanged pixels are left out.
  struct Drawn {
    int width = 0, height = 0;
    std::vector<uint32_t> pixels;
    std::vector<uint32_t> reference;  // of the shown comparison
    int reference_width = 0, reference_height = 0;
    PreviewPicture picture;              // without its textures
    std::shared_ptr<const Design> made;  // the design, if its picture is complete
    std::shared_ptr<const Design> of;    // the design of the pixels
  };

  std::shared_ptr<const Design> first_design(gl::Pipeline& pipeline);
  void work();
  /// Opens `context_` and draws until the pane is left.
  void weave_and_draw();
  /// On the drawing thread: waits until the window's thread has opened one.
  HeadlessContext::Opened ask_for_hidden_window();
  void open_hidden_window_if_asked();
  void draw_until_left(class PictureMaker& maker);
  /// Shows an exception in place of the picture; the next picture is drawn in full.
  void fail(const base::Error& error);
  void make(PictureMaker& maker, const PictureRequest& request, bool moving);
  void hand_over(const PictureMaker& maker, const PictureRequest& request, bool drawn);

  std::function<void()> wake_window_;
  std::mutex mutex_;
  std::condition_variable wake_;
  // Guarded by the mutex.
  std::shared_ptr<const Design> design_;
  bool new_design_ = false, new_request_ = false, moving_ = false, leaving_ = false;
  std::optional<PictureRequest> request_;
  std::optional<Drawn> drawn_;
  bool asks_for_window_ = false;
  std::optional<HeadlessContext::Opened> hidden_window_;  // the answer
  bool failed_ = false;  // used by the drawing thread: the last picture was not handed over
  // Opened and used by the drawing thread; destroyed by the window's, which alone may destroy windows.
  std::unique_ptr<HeadlessContext> context_;
  // Used by the window's thread.
  std::shared_ptr<const Design> submitted_, shown_;
  std::deque<std::pair<std::shared_ptr<const Design>, ClothSubject>>
      subjects_;  // of the designs that may be shown next
  ClothSubject subject_, shown_subject_;
  PreviewPicture picture_;
  PixelTexture texture_, reference_texture_;
  std::thread thread_;
};

}  // namespace weftlight::app
