#pragma once
// Versions and colourways of the draft, side by side as lit cloth at one scale.

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "session/jobs/cloth_pictures.h"
#include "ui/pixel_texture.h"
#include "views/common/panel.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using session::ClothPictures;
using ui::PixelTexture;

/// Lit pictures of designs as textures, made on another thread when first requested.
class VersionPictures {
 public:
  /// `wake`: called on the other thread when one is done.
  explicit VersionPictures(std::function<void()> wake) : pictures_(std::move(wake)) {}
  /// Null while it is made. Those of another size or scale are forgotten.
  const PixelTexture* picture(const std::shared_ptr<const Design>& design, int width, int height, float across_mm);
  /// True if there is something new to show. Call it on the window's thread.
  bool poll();
  bool busy() const { return pictures_.busy(); }

 private:
  struct Entry {
    std::shared_ptr<const Design> design;
    PixelTexture texture;
  };
  int width_ = 0, height_ = 0;
  float across_mm_ = 0;
  std::map<const Design*, Entry> entries_;
  ClothPictures pictures_;
};

struct VersionsPrompt {
  std::string name;  // to keep the draft under, or to give to the chosen version
  std::shared_ptr<VersionPictures> pictures;
  int chosen = -1;                      // version; -1: none
  int scale = 1;                        // of kSwatchWidths
  bool follow = false;                  // scroll to the chosen card
  std::shared_ptr<const Design> now{};  // the draft of `revision`, for its picture
  uint64_t revision = 0;
};

DialogResult draw_prompt(PanelContext& c, VersionsPrompt& p);

}  // namespace weftlight::views
