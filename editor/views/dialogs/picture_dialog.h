#pragma once
// A picture becomes a draft: its part, size, colours and their weaves, beside a preview that follows.

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "session/jobs/picture_weaver.h"
#include "ui/pixel_texture.h"
#include "views/common/panel.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using draft::BitMatrix;
using session::PictureChoices, session::PictureResult, session::PictureWeaver;
using ui::PixelTexture;

inline constexpr int kMaxPictureColors = 16;
inline constexpr int kPicturePixels = 720;  // of the longer side of picture and preview

/// The picture and the preview as textures, and the thread that weaves.
struct PictureStage {
  PictureStage(std::string path, std::shared_ptr<const Design> base, std::function<void()> wake)
      : weaver(std::move(path), std::move(base), kPicturePixels, kPicturePixels, std::move(wake)) {}
  PictureWeaver weaver;
  PixelTexture source, woven;
  std::shared_ptr<const PictureResult> shown;  // in `woven`
  /// True if there is something new. Call it on the window's thread.
  bool poll();
};

/// The weave that stands for a colour: a row of the shelf, or typed.
struct ColorWeave {
  int shelf = 0;  // of picture_shelf()
  std::string typed{};
};

struct PicturePrompt {
  std::string name;  // of the picture
  std::shared_ptr<PictureStage> stage;
  BitMatrix own_weave;  // the repeat of the open draft; empty: too large for a colour
  PictureChoices choices{};
  bool proportions = true;  // picks follow ends
  std::array<ColorWeave, kMaxPictureColors> weaves{};
  std::string why{};      // what was typed for a weave and is none
  bool accepted = false;  // "Weave" was pressed; the dialog closes when the draft is made
  ImVec2 drag{-1, -1};    // where a drag over the picture began, in its pixels; negative: none
};

/// A weave that is offered for a colour, as a marked text, and its words for weaves::read_weave_words.
struct ShelfWeave {
  const char *label, *words;
};
/// The first is the shaded satin by the colour's place, the last the weaver's typed one, the one before it that of the
/// open draft.
std::span<const ShelfWeave> picture_shelf();
/// The choices with the weaves of the colours, or why one of them is none.
base::Result<PictureChoices> chosen_picture(const PicturePrompt& p);

DialogResult draw_prompt(PanelContext& c, PicturePrompt& p);

}  // namespace weftlight::views
