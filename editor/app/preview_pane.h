#pragma once
// The preview of the cloth. It is drawn on its own thread with its own GL context, so that painting never waits for it.
// The window requests a picture and is woken when there is something new to show.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/drawn_picture.h"
#include "app/picture_maker.h"
#include "gl/headless_context.h"
#include "gl/reset_watch.h"

namespace weftlight::app {

using gl::HeadlessContext;

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
  PreviewPicture picture() const { return shown_.picture(); }

 private:
  std::shared_ptr<const Design> first_design(gl::Pipeline& pipeline);
  void work();
  /// Draws in one context after another, until the pane is left: one that was lost is made anew.
  void weave_and_draw();
  /// Opens `context_` and draws. True if it was lost, false if there is nothing more to do.
  bool draw_in_context();
  /// On the drawing thread: waits until the window's thread has opened one.
  HeadlessContext::Opened ask_for_hidden_window();
  void open_hidden_window_if_asked();
  /// True if the context was lost, false if the pane is left.
  bool draw_while_there(class PictureMaker& maker, const gl::ResetWatch& watch);
  /// Shows an exception in place of the picture; the next picture is drawn in full.
  void fail(const base::Error& error);
  void make(PictureMaker& maker, const PictureRequest& request, bool moving);
  void hand_over(const PictureMaker& maker, const PictureRequest& request, bool drawn);

  std::function<void()> wake_window_;
  std::mutex mutex_;
  std::condition_variable wake_;
  // Guarded by the mutex.
  std::shared_ptr<const Design> design_;
  uint64_t draft_ = 0;  // that it is of
  bool new_design_ = false, new_request_ = false, moving_ = false, leaving_ = false;
  std::optional<PictureRequest> request_;
  std::optional<DrawnPicture> drawn_;
  bool asks_for_window_ = false;
  std::optional<HeadlessContext::Opened> hidden_window_;  // the answer
  bool failed_ = false;  // used by the drawing thread: the last picture was not handed over
  // Opened and used by the drawing thread; destroyed by the window's, which alone may destroy windows.
  std::unique_ptr<HeadlessContext> context_;
  std::vector<std::unique_ptr<HeadlessContext>> lost_;  // earlier ones, a few
  ShownPicture shown_;                                  // used by the window's thread
  std::thread thread_;
};

}  // namespace weftlight::app
