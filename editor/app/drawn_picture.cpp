#include "app/drawn_picture.h"

#include <algorithm>

#include "base/text.h"

namespace weftlight::app {

using base::arg, base::fill, base::message, base::tr;
using session::Compare, session::PictureComparison;

namespace {

constexpr size_t kMaxSubjects = 64;  // while no picture comes

}  // namespace

DrawnPicture drawn_picture(const PictureMaker& maker, const PictureRequest& request, bool with_pixels) {
  DrawnPicture made;
  if (with_pixels) {
    maker.read(made.width, made.height, made.pixels);
    made.of = maker.drawn_design();
  }
  const base::Result<PictureComparison>& traced = maker.comparison();
  const PictureComparison c = traced.value_or(PictureComparison{});
  const bool compared = request.compare != Compare::kOff && !c.reference.empty();
  if (compared) made.reference = request.compare == Compare::kSplit ? c.reference : c.difference;
  made.reference_width = c.width, made.reference_height = c.height;
  made.picture.stats = maker.stats();
  made.picture.tolerance = maker.tolerance();
  made.picture.budget_ms = request.budget_ms;
  made.picture.problem = maker.problem();
  made.picture.busy = maker.busy();
  made.picture.refining = maker.can_refine();
  made.picture.reference = {compared ? 1u : 0u, c.samples, c.relative_error, !c.finished, {}};
  if (!traced)
    made.picture.reference.problem =
        fill(tr("No ray-traced picture: {problem}"), arg("problem", message(traced.error())));
  if (!made.picture.busy) made.made = maker.design();
  return made;
}

DrawnPicture undrawn_picture(const base::Error& error) {
  DrawnPicture none;
  none.picture.problem = fill(tr("The cloth cannot be shown: {problem}"), arg("problem", message(error)));
  return none;
}

void ShownPicture::submit(const std::shared_ptr<const Design>& design, const ClothSubject& subject) {
  submitted_ = design;
  subject_ = subject;
  subjects_.emplace_back(design, subject);
  if (subjects_.size() > kMaxSubjects) subjects_.pop_front();
}

void ShownPicture::take(DrawnPicture drawn) {
  if (!drawn.pixels.empty()) {
    texture_.set(drawn.width, drawn.height, drawn.pixels);
    const auto is_of = [&](const auto& one) { return one.first == drawn.of; };
    const auto of = std::find_if(subjects_.begin(), subjects_.end(), is_of);
    if (of != subjects_.end()) {
      shown_subject_ = of->second;
      subjects_.erase(subjects_.begin(), of);  // earlier ones come no more
    }
  }
  if (!drawn.reference.empty()) reference_texture_.set(drawn.reference_width, drawn.reference_height, drawn.reference);
  picture_ = std::move(drawn.picture);
  shown_ = std::move(drawn.made);
}

PreviewPicture ShownPicture::picture() const {
  PreviewPicture p = picture_;
  p.texture = shown_subject_ == subject_ ? texture_.name() : 0;
  if (p.reference.texture != 0) p.reference.texture = reference_texture_.name();
  p.busy = p.problem.empty() && (p.busy || shown_ != submitted_);
  if (p.texture == 0 && p.problem.empty()) p.problem = tr("Weaving the cloth\xE2\x80\xA6");
  return p;
}

}  // namespace weftlight::app
