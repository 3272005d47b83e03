#pragma once
// A picture as a draft, woven anew on a thread of its own whenever the choices change.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/floats.h"
#include "base/tasks.h"
#include "design/design.h"
#include "draft/factor.h"
#include "files/picture_draft.h"
#include "session/jobs/thumbnail.h"

namespace weftlight::session {

using design::Design;
using draft::LoomSize, draft::Rgb;

struct PictureChoices {
  files::PictureDraft draft;
  bool jacquard = true;  // a shaft for each end; otherwise the loom below
  LoomSize loom{8, 10};
  bool operator==(const PictureChoices&) const = default;
};

/// A picture that became a draft.
struct PictureResult {
  std::shared_ptr<const Design> design;  // the base design with the picture as its draft
  std::vector<Rgb> colors;               // of the reduced picture, dark to light
  std::vector<float> portion;            // of each, 0..1
  bool by_crossings = false;             // its two colours are crossings, without weaves
  int64_t wrong = 0;                     // crossings that the loom cannot weave as the picture wants
  analysis::LongestFloats floats;
  Thumbnail shown;  // the whole draft in the colours of its threads
};
/// `base` with the woven picture as its draft: title, yarns, look and all else that is not the weave stay. The preview
/// has at most width x height pixels. Errors as files::woven_picture, or kCancelled.
base::Result<PictureResult> picture_result(const Design& base, const files::Image& picture,
                                           const PictureChoices& choices, int width, int height,
                                           const base::TaskProgress& progress = {});
/// The picture in at most width x height pixels.
Thumbnail small_picture(const files::Image& picture, int width, int height);

class PictureWeaver {
 public:
  /// Begins to read the picture. `wake` is called on the other thread when there is something new.
  PictureWeaver(std::string path, std::shared_ptr<const Design> base, int width, int height,
                std::function<void()> wake);
  /// Weaves with these choices unless they were asked for last; drops what is woven.
  void ask(const PictureChoices& choices);
  /// True if there is something new. Call it on the window's thread.
  bool poll() { return runner_.take(); }
  bool busy() const { return runner_.busy(); }
  /// Blocks until nothing is read or woven.
  void wait() const { runner_.wait(); }

  /// Size in pixels; 0 until the picture is read.
  files::ImageSize size() const { return size_; }
  const Thumbnail& source() const { return source_; }
  /// The last that was made; null before.
  const std::shared_ptr<const PictureResult>& result() const { return result_; }
  /// True if the result is that of the last choices.
  bool is_current() const { return result_ && made_ == asked_; }
  /// Why there is no picture, or none with the last choices; empty: there is one, or it is being made.
  const std::string& problem() const { return problem_; }

 private:
  std::shared_ptr<const Design> base_;
  int width_ = 0, height_ = 0;
  std::shared_ptr<const files::Image> picture_;
  files::ImageSize size_;
  Thumbnail source_;
  PictureChoices asked_, made_;
  bool any_asked_ = false;
  std::shared_ptr<const PictureResult> result_;
  std::string problem_;
  base::TaskRunner runner_;
};

}  // namespace weftlight::session
