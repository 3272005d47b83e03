#include "session/editing/palette_deletion.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/text.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr, base::tr_n;
using design::closest_color, design::closest_yarn, design::uses_of_colors, design::uses_of_yarns, design::without_color,
    design::without_yarn;
using draft::Threads;

namespace {

template <class T>
void find_again(int& active, const std::vector<T>& list, const T& value) {
  const auto found = std::ranges::find(list, value);
  if (found != list.end()) active = static_cast<int>(found - list.begin());
}

Deletion deletion_of(const Design& design, std::vector<int> Threads::*column, int entry, int heir, int uses) {
  Deletion d{entry, heir};
  d.ends = static_cast<int>(std::ranges::count(design.draft.warp.*column, entry));
  d.picks = static_cast<int>(std::ranges::count(design.draft.weft.*column, entry));
  d.in_sections = uses - d.ends - d.picks;
  return d;
}

/// "It is used by 12 ends and 4 picks."
std::string uses_in_words(const Deletion& d) {
  const std::string ends = fill(tr_n("{count} end", "{count} ends", d.ends), arg("count", d.ends));
  const std::string picks = fill(tr_n("{count} pick", "{count} picks", d.picks), arg("count", d.picks));
  if (d.ends > 0 && d.picks > 0)
    return fill(tr("It is used by {ends} and {picks}."), arg("ends", ends), arg("picks", picks));
  if (d.ends + d.picks == 0) return tr("It is used in sections.");
  return fill(tr("It is used by {threads}."), arg("threads", d.ends > 0 ? ends : picks));
}

}  // namespace

void keeping_active(DrawingState& drawing, const Document& document, const std::function<void()>& edit) {
  const std::shared_ptr<const Design> was = document.snapshot();
  edit();
  const auto color = static_cast<size_t>(std::max(drawing.color, 0)),
             yarn = static_cast<size_t>(std::max(drawing.yarn, 0));
  const Design& now = document.now();
  if (color < was->draft.palette.size()) find_again(drawing.color, now.draft.palette, was->draft.palette[color]);
  if (yarn < was->yarns.size()) find_again(drawing.yarn, now.yarns, was->yarns[yarn]);
}

Deletion color_deletion(const Design& design, int color) {
  return deletion_of(design, &Threads::color, color, closest_color(design, color),
                     uses_of_colors(design).at(static_cast<size_t>(color)));
}

Deletion yarn_deletion(const Design& design, int yarn) {
  return deletion_of(design, &Threads::yarn, yarn, closest_yarn(design, yarn),
                     uses_of_yarns(design).at(static_cast<size_t>(yarn)));
}

std::string color_deletion_words(const Deletion& d) {
  return uses_in_words(d).append(" ").append(
      fill(tr("Colour {number}, the closest one, takes its place."), arg("number", d.heir + 1)));
}

std::string yarn_deletion_words(const Design& design, const Deletion& d) {
  return uses_in_words(d).append(" ").append(fill(tr("{yarn}, the most similar one, takes its place."),
                                                  arg("yarn", design.yarns.at(static_cast<size_t>(d.heir)).name)));
}

Edit delete_color_edit(const Deletion& d) {
  return {fill(tr("Delete colour {number}"), arg("number", d.entry + 1)),
          [d](Design design) { return without_color(std::move(design), d.entry, d.heir); }};
}

Edit delete_yarn_edit(const Design& design, const Deletion& d) {
  return {fill(tr("Delete yarn {name}"), arg("name", design.yarns.at(static_cast<size_t>(d.entry)).name)),
          [d](Design now) { return without_yarn(std::move(now), d.entry, d.heir); }};
}

}  // namespace weftlight::session
