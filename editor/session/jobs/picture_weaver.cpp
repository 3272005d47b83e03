#include "session/jobs/picture_weaver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "design/edits.h"
#include "draft/drawdown.h"
#include "weaves/weaves.h"

namespace weftlight::session {

using analysis::longest_floats;
using base::TaskProgress, base::message, base::tr;
using design::Leading;
using draft::ClosestDraft, draft::Draft, draft::ShedControl, draft::closest_drawdown, draft::drawdown,
    draft::within_loom;
using files::Image, files::WovenPicture, files::woven_picture;

namespace {

/// width x height reduced to the proportions of a : b.
std::pair<int, int> fitted_size(int width, int height, int a, int b) {
  const double scale = std::min(static_cast<double>(width) / a, static_cast<double>(height) / b);
  const auto side = [scale](int n) { return std::max(1, static_cast<int>(std::lround(n * scale))); };
  return {side(a), side(b)};
}

/// On the loom of the choices, as close as it can.
void put_on_loom(Draft& draft, const PictureChoices& choices, int64_t& wrong, const TaskProgress& progress) {
  if (choices.jacquard) return;
  if (base::Result<Draft> fits = within_loom(draft, choices.loom)) {
    draft = std::move(*fits);
    return;
  }
  ClosestDraft closest = closest_drawdown(draft, drawdown(draft), choices.loom, progress);
  draft = std::move(closest.draft);
  wrong = closest.wrong;
}

/// The draft of a picture in another design.
Design with_draft(Design base, Draft draft, const PictureChoices& choices) {
  base.draft = std::move(draft);
  base.weaves.clear();
  base.warp_assembly = {}, base.weft_assembly = {};
  base.loom = {};
  base.loom.leading = base.draft.shed_control == ShedControl::kLiftplan ? Leading::kLiftplan : Leading::kThreading;
  if (!choices.jacquard) base.loom.shafts = choices.loom.shafts, base.loom.treadles = choices.loom.treadles;
  return weaves::with_sett(std::move(base));
}

}  // namespace

base::Result<PictureResult> picture_result(const Design& base, const Image& picture, const PictureChoices& choices,
                                           int width, int height, const TaskProgress& progress) {
  base::Result<WovenPicture> woven = woven_picture(picture, choices.draft, progress);
  if (!woven) return base::Failure(woven.error());
  PictureResult out;
  out.colors = std::move(woven->colors), out.portion = std::move(woven->portion);
  out.by_crossings = woven->by_crossings;
  Draft& draft = woven->design.draft;
  put_on_loom(draft, choices, out.wrong, progress);
  if (progress.stopped()) return base::failure(base::ErrorKind::kCancelled, tr("stopped"));
  auto design = std::make_shared<const Design>(with_draft(base, std::move(draft), choices));
  out.floats = longest_floats(drawdown(design->draft));
  out.shown = whole_draft(*design, width, height);
  out.design = std::move(design);
  return out;
}

Thumbnail small_picture(const Image& picture, int width, int height) {
  if (picture.width < 1 || picture.height < 1) return {};
  const auto [w, h] = fitted_size(width, height, picture.width, picture.height);
  Thumbnail out{w, h, {}};
  const auto channels = static_cast<size_t>(picture.channels);
  const size_t second = channels >= 3 ? 1 : 0, third = channels >= 3 ? 2 : 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const auto row = static_cast<size_t>((y + 0.5) * picture.height / h);
      const auto column = static_cast<size_t>((x + 0.5) * picture.width / w);
      const float* texel = &picture.texels[(row * static_cast<size_t>(picture.width) + column) * channels];
      const auto byte = [](float v) { return static_cast<uint32_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255)); };
      out.pixels.push_back(byte(texel[0]) | byte(texel[second]) << 8 | byte(texel[third]) << 16 | 0xFF000000u);
    }
  return out;
}

PictureWeaver::PictureWeaver(std::string path, std::shared_ptr<const Design> base, int width, int height,
                             std::function<void()> wake)
    : base_(std::move(base)), width_(width), height_(height), runner_(std::move(wake)) {
  struct Read {
    std::shared_ptr<const Image> picture;
    Thumbnail source;
  };
  base::Task task = base::task_with_result(
      [path = std::move(path), width, height](const base::RunningTask&) -> base::Result<Read> {
        base::Result<Image> image = files::read_picture(path);
        if (!image) return base::Failure(image.error());
        Thumbnail source = small_picture(*image, width, height);
        return Read{std::make_shared<const Image>(std::move(*image)), std::move(source)};
      },
      [this](base::Result<Read> read) {
        if (!read) {
          problem_ = message(read.error());
          return;
        }
        picture_ = std::move(read->picture), source_ = std::move(read->source);
        size_ = {picture_->width, picture_->height};
      });
  task.kind = "read";
  task.may_be_left = true;
  runner_.start(std::move(task));
}

void PictureWeaver::ask(const PictureChoices& choices) {
  if (!picture_ || (any_asked_ && choices == asked_)) return;
  asked_ = choices, any_asked_ = true;
  base::Task task = base::task_with_result(
      [base = base_, picture = picture_, choices, width = width_, height = height_](const base::RunningTask& running) {
        return picture_result(*base, *picture, choices, width, height, running);
      },
      [this, choices](base::Result<PictureResult> made) {
        problem_ = made ? std::string() : message(made.error());
        made_ = choices;
        result_ = made ? std::make_shared<const PictureResult>(std::move(*made)) : nullptr;
      });
  task.kind = "weave";
  runner_.start(std::move(task));
}

}  // namespace weftlight::session
