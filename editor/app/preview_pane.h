#pragma once
// The picture of the cloth as the window sees it. It is made on a thread of its own, with a GL context of its own, so
// that no stroke waits for it: the window says what it wants to see and is woken when there is something new to show.

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/names.h"
#include "app/picture_maker.h"
#include "ui/pixel_texture.h"
#include "views/cloth/preview_panel.h"

namespace weftlight::app {

class PreviewPane {
 public:
  /// `wake`: called on the other thread when poll() has something.
  explicit PreviewPane(std::function<void()> wake);
  /// Waits for the picture that is being drawn.
  ~PreviewPane();
  PreviewPane(const PreviewPane&) = delete;
  PreviewPane& operator=(const PreviewPane&) = delete;

  void submit(std::shared_ptr<const Design> design);
  /// The newest request is the one that counts.
  void ask(const PictureRequest& request, bool moving);
  /// Takes what is new; true when there is something to show. Needs the window's GL context.
  bool poll();
  PreviewPicture picture() const;

 private:
  /// What the thread hands over. Pixels are left out where they are those of before.
  struct News {
    int width = 0, height = 0;
    std::vector<uint32_t> pixels;
    std::vector<uint32_t> reference;  // of the comparison that is shown
    int reference_width = 0, reference_height = 0;
    PreviewPicture picture;              // but for its textures
    std::shared_ptr<const Design> made;  // nothing of it is still to come
  };

  std::shared_ptr<const Design> first_design(gl::Pipeline& pipeline);
  void work();
  void draw_until_left(class PictureMaker& maker);
  /// What was thrown while a picture was made, told in its place; the next is made anew.
  void fail(const std::string& why);
  void make(PictureMaker& maker, const PictureRequest& request, bool moving);
  void hand_over(const PictureMaker& maker, const PictureRequest& request, bool drawn);

  std::function<void()> wake_window_;
  std::mutex mutex_;
  std::condition_variable wake_;
  // Guarded by the mutex.
  std::shared_ptr<const Design> design_;
  bool new_design_ = false, new_request_ = false, moving_ = false, leaving_ = false;
  std::optional<PictureRequest> request_;
  std::optional<News> news_;
  bool failed_ = false;  // the thread's: what was made last was not handed over
  // The window's.
  std::shared_ptr<const Design> submitted_, shown_;
  PreviewPicture picture_;
  PixelTexture texture_, reference_texture_;
  std::thread thread_;
};

}  // namespace weftlight::app
