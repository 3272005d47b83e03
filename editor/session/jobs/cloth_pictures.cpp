#include "session/jobs/cloth_pictures.h"

#include <algorithm>
#include <cmath>

#include "texture_set/set_preview.h"

namespace weftlight::session {

using draft::Face;
using files::Image;

Thumbnail lit_picture(const Design& design, int width, int height, float across_mm, const std::stop_token& stop) {
  const Image image = texture_set::flat_swatch(design, Face::kFront, width, height, across_mm, stop);
  Thumbnail out{image.width, image.height, {}};
  out.pixels.reserve(image.texels.size() / 3);
  for (size_t at = 0; at + 2 < image.texels.size(); at += 3) {
    const auto byte = [&](size_t i) {
      return static_cast<uint32_t>(std::lround(std::clamp(image.texels[at + i], 0.0f, 1.0f) * 255));
    };
    out.pixels.push_back(byte(0) | byte(1) << 8 | byte(2) << 16 | 0xFF000000u);
  }
  return out;
}

void ClothPictures::ask(const std::shared_ptr<const Design>& design, int width, int height, float across_mm) {
  if (width != width_ || height != height_ || across_mm != across_mm_) {
    runner_.stop();
    made_.clear();
    width_ = width, height_ = height, across_mm_ = across_mm;
  }
  base::Task task = base::task_with_result(
      [design, width, height, across_mm](const base::RunningTask& running) {
        return lit_picture(*design, width, height, across_mm, running.stop());
      },
      [this, design](base::Result<Thumbnail> made) {
        made_.emplace_back(design, std::move(made).value_or(Thumbnail{}));
      });
  task.kind = std::to_string(reinterpret_cast<uintptr_t>(design.get()));  // each design has a picture
  runner_.start(std::move(task));
}

std::vector<ClothPictures::Picture> ClothPictures::take() {
  runner_.take();
  return std::exchange(made_, {});
}

}  // namespace weftlight::session
