#include "session/jobs/thumbnail.h"

#include <algorithm>
#include <cmath>

#include "design/dye.h"
#include "draft/drawdown.h"

namespace weftlight::session {

using draft::BitMatrix, draft::Draft, draft::Rgb, draft::System, draft::Threads, draft::drawdown;

namespace {

constexpr int kMinAcross = 48;   // least number of ends shown; smaller drafts repeat
constexpr int kMaxSamples = 4;   // along each side of a pixel that covers several crossings
constexpr float kRound = 0.34f;  // darkening at the edges of a thread
constexpr float kDip = 0.30f;    // darkening where it goes under the next thread

constexpr float kAlike = 0.12f;  // if mean warp and weft colour differ by less in each channel,
constexpr float kTone = 0.84f;   // the weft is darkened by this factor, so that white damask shows its figure

Rgb mean_color(const Draft& draft, System system) {
  Rgb sum;
  const Threads& threads = draft.threads(system);
  for (const int color : threads.color) {
    const Rgb& c = draft.palette[static_cast<size_t>(color)];
    sum.r += c.r, sum.g += c.g, sum.b += c.b;
  }
  const float n = static_cast<float>(std::max(threads.size(), 1));
  return {sum.r / n, sum.g / n, sum.b / n};
}

float weft_tone(const Draft& draft) {
  const Rgb a = mean_color(draft, System::kWarp), b = mean_color(draft, System::kWeft);
  const float apart = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
  return apart < kAlike ? kTone : 1;
}

/// The threads sampled by the pixels along one side.
struct Side {
  int samples = 1;           // per pixel
  std::vector<int> threads;  // of the draft, sampled ones only, ascending
  std::vector<int> at;       // by sample: index into `threads`
  std::vector<float> place;  // by sample: position across its thread, -1..1
};

Side side_of(int pixels, float cell, int count) {
  Side side;
  side.samples = std::clamp(static_cast<int>(std::ceil(1 / cell)), 1, kMaxSamples);
  std::vector<int> seen;
  for (int i = 0; i < pixels * side.samples; ++i) {
    const float cells = (static_cast<float>(i) + 0.5f) / (static_cast<float>(side.samples) * cell);
    seen.push_back(static_cast<int>(cells) % count);
    side.place.push_back(2 * (cells - std::floor(cells)) - 1);
  }
  side.threads = seen;
  std::sort(side.threads.begin(), side.threads.end());
  side.threads.erase(std::unique(side.threads.begin(), side.threads.end()), side.threads.end());
  for (const int thread : seen)
    side.at.push_back(
        static_cast<int>(std::lower_bound(side.threads.begin(), side.threads.end(), thread) - side.threads.begin()));
  return side;
}

BitMatrix rows_of(const BitMatrix& all, const std::vector<int>& which) {
  BitMatrix some(static_cast<int>(which.size()), all.cols());
  for (size_t i = 0; i < which.size(); ++i) std::ranges::copy(all.row(which[i]), some.row(static_cast<int>(i)).begin());
  return some;
}

/// The crossings of those ends and picks only, so that a huge draft is not computed in full.
BitMatrix crossings_of(const Draft& draft, const std::vector<int>& ends, const std::vector<int>& picks) {
  Draft some;
  some.shafts = draft.shafts, some.treadles = draft.treadles;
  some.rising = draft.rising, some.shed_control = draft.shed_control;
  some.warp.resize(static_cast<int>(ends.size()));
  some.weft.resize(static_cast<int>(picks.size()));
  some.threading = rows_of(draft.threading, ends);
  some.tieup = draft.tieup;
  some.treadling = rows_of(draft.treadling, picks);
  some.liftplan = rows_of(draft.liftplan, picks);
  some.palette = draft.palette;
  return drawdown(some);
}

/// A round thread: darker at its edges, and where it dips under a neighbour.
float shade(float across, float along, bool dips, float strength) {
  const float edge = kRound * across * across, end = dips ? kDip * along * along * along * along : 0;
  return 1 - strength * (edge + end);
}

struct Picture {
  const Draft& draft;
  const Side &across, &down;
  const BitMatrix cells;
  float strength;  // of the shading: small cells are flat
  float tone;      // factor on weft colours
  design::DyedThreads dyed;

  Rgb color(int x, int y) const {
    const int end = across.at[static_cast<size_t>(x)], pick = down.at[static_cast<size_t>(y)];
    const float px = across.place[static_cast<size_t>(x)], py = down.place[static_cast<size_t>(y)];
    const bool warp = cells.get(pick, end);
    Rgb c = color_on_top(draft, dyed, warp, across.threads[static_cast<size_t>(end)],
                         down.threads[static_cast<size_t>(pick)]);
    if (!warp) c = {c.r * tone, c.g * tone, c.b * tone};
    if (strength <= 0) return c;
    // Neighbours within the sampled threads: cells of several pixels have their true neighbours.
    const int ends = cells.cols(), picks = cells.rows();
    const bool under = warp ? !cells.get((pick + (py < 0 ? picks - 1 : 1)) % picks, end)
                            : cells.get(pick, (end + (px < 0 ? ends - 1 : 1)) % ends);
    const float k = warp ? shade(px, py, under, strength) : shade(py, px, under, strength);
    return {c.r * k, c.g * k, c.b * k};
  }

  uint32_t pixel(int x, int y) const {
    float r = 0, g = 0, b = 0;
    for (int j = 0; j < down.samples; ++j)
      for (int i = 0; i < across.samples; ++i) {
        const Rgb c = color(x * across.samples + i, y * down.samples + j);
        r += c.r, g += c.g, b += c.b;
      }
    const float n = static_cast<float>(across.samples * down.samples);
    const auto byte = [n](float sum) { return static_cast<uint32_t>(std::clamp(sum / n, 0.0f, 1.0f) * 255 + 0.5f); };
    return byte(r) | byte(g) << 8 | byte(b) << 16 | 0xFF000000u;
  }
};

/// From end 1 and pick 1 on, repeated where there is room. cell: pixels a thread.
Thumbnail drawn(const Design& design, float cell, int width, int height) {
  const Draft& draft = design.draft;
  const Side across = side_of(width, cell, draft.ends()), down = side_of(height, cell, draft.picks());
  constexpr float kFlat = 2, kShaded = 6;  // pixels per cell
  const Picture picture{draft,
                        across,
                        down,
                        crossings_of(draft, across.threads, down.threads),
                        std::clamp((cell - kFlat) / (kShaded - kFlat), 0.0f, 1.0f),
                        weft_tone(draft),
                        design::DyedThreads(design)};
  Thumbnail out{width, height, {}};
  out.pixels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = width; x-- > 0;) out.pixels.push_back(picture.pixel(x, y));
  return out;
}

/// Cells of two pixels and more have whole ones.
float whole_pixels(float cell) { return cell >= 2 ? std::floor(cell) : cell; }

}  // namespace

Thumbnail thumbnail_of(const Design& design, int width, int height) {
  const Draft& draft = design.draft;
  if (draft.ends() == 0 || draft.picks() == 0 || width <= 0 || height <= 0) return {};
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  const float fits = std::min(static_cast<float>(draft.ends()), static_cast<float>(draft.picks()) * w / h);
  return drawn(design, whole_pixels(w / std::max(fits, static_cast<float>(kMinAcross))), width, height);
}

Thumbnail whole_draft(const Design& design, int width, int height) {
  const Draft& draft = design.draft;
  if (draft.ends() == 0 || draft.picks() == 0 || width <= 0 || height <= 0) return {};
  const auto ends = static_cast<float>(draft.ends()), picks = static_cast<float>(draft.picks());
  const float cell = whole_pixels(std::min(static_cast<float>(width) / ends, static_cast<float>(height) / picks));
  const auto side = [cell](float threads) { return std::max(static_cast<int>(threads * cell), 1); };
  return drawn(design, cell, side(ends), side(picks));
}

}  // namespace weftlight::session
