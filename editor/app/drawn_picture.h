#pragma once
// The picture of the cloth on its way from where it is drawn to where it is shown.

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "app/picture_maker.h"
#include "ui/pixel_texture.h"
#include "views/cloth/preview_panel.h"

namespace weftlight::app {

using design::Design;
using ui::PixelTexture;
using views::PreviewPicture;

/// What is seen: a picture of one is never shown for another, whose camera it would have.
struct ClothSubject {
  uint64_t document = 0;
  bool flat = false;
  bool operator==(const ClothSubject&) const = default;
};

/// A result of drawing. Unchanged pixels are left out.
struct DrawnPicture {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;
  std::vector<uint32_t> reference;  // of the shown comparison
  int reference_width = 0, reference_height = 0;
  PreviewPicture picture;              // without its textures
  std::shared_ptr<const Design> made;  // the design, if its picture is complete
  std::shared_ptr<const Design> of;    // the design of the pixels
};
/// What a maker has drawn last; its pixels only if `with_pixels`.
DrawnPicture drawn_picture(const PictureMaker& maker, const PictureRequest& request, bool with_pixels);
/// The problem in place of a picture.
DrawnPicture undrawn_picture(const base::Error& error);

/// The picture that is shown, in textures of the window's GL context, while newer designs are on their way.
class ShownPicture {
 public:
  void submit(const std::shared_ptr<const Design>& design, const ClothSubject& subject);
  void take(DrawnPicture drawn);
  PreviewPicture picture() const;

 private:
  std::shared_ptr<const Design> submitted_, shown_;
  std::deque<std::pair<std::shared_ptr<const Design>, ClothSubject>>
      subjects_;  // of the designs that may be shown next
  ClothSubject subject_, shown_subject_;
  PreviewPicture picture_;
  PixelTexture texture_, reference_texture_;
};

}  // namespace weftlight::app
