#include "session/loom/cloth_so_far.h"

#include <algorithm>

#include "design/dye.h"
#include "files/files.h"

namespace weftlight::session {

using draft::BitMatrix, draft::Rgb;
using files::Image;

namespace {

constexpr int kEnds = 128, kPicks = 96, kBarePicks = 12, kPixels = 4;

/// A crossing of 4 x 4 pixels, darker where the thread on top goes under its neighbours.
void draw_crossing(Image& image, int column, int row, Rgb color, bool warp_up, bool bare) {
  for (int y = 0; y < kPixels; ++y)
    for (int x = 0; x < kPixels; ++x) {
      const int across = warp_up || bare ? x : y;
      const float shade = across == kPixels - 1 ? (bare ? 0.35f : 0.72f) : across == 0 ? 0.9f : 1.0f;
      const size_t at = (static_cast<size_t>(row * kPixels + y) * static_cast<size_t>(image.width) +
                         static_cast<size_t>(column * kPixels + x)) *
                        3;
      image.texels[at] = color.r * shade;
      image.texels[at + 1] = color.g * shade;
      image.texels[at + 2] = color.b * shade;
    }
}

}  // namespace

std::string cloth_so_far_png(const AtLoom& at, const Design& design, const BitMatrix& cells) {
  const draft::Draft& draft = design.draft;
  const loom::WeavingState place = place_of(at, design);
  const bool whole = at.section.first >= at.section.end;
  const int first = whole ? 0 : std::min(at.section.first, draft.picks());
  const int of = whole ? draft.picks() : std::min(at.section.end, draft.picks()) - first;
  if (draft.ends() == 0 || of <= 0) return {};
  const int ends = std::min(kEnds, draft.ends());
  // What lies before the place in the draft, or more if it was woven round.
  const int woven = static_cast<int>(std::clamp<int64_t>(place.woven, place.next_pick - first, kPicks));
  Image image{ends * kPixels, (kBarePicks + std::min(woven, kPicks)) * kPixels, 3, {}};
  image.texels.resize(static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 3);
  const design::DyedThreads dyed(design);
  for (int row = 0; row < image.height / kPixels; ++row) {
    const int back = row - kBarePicks + 1;  // picks before the next one
    const int pick = first + (((place.next_pick - first - back) % of) + of) % of;
    for (int end = 0; end < ends; ++end) {
      const bool bare = back < 1, warp_up = bare || cells.get(pick, end);
      const Rgb& color = color_on_top(draft, dyed, warp_up, end, pick);
      draw_crossing(image, ends - 1 - end, row, color, warp_up, bare);
    }
  }
  const std::vector<unsigned char> png = files::encode_png(image);
  return {png.begin(), png.end()};
}

}  // namespace weftlight::session
