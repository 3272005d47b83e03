#include "views/dialogs/picture_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "weaves/families.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::message, base::tr;
using draft::kMaxShafts, draft::kMaxThreads;
using files::ImageSize, files::PictureCrop;
using session::Edit, session::Thumbnail;
using ui::begin_combo, ui::begin_list, ui::draw_swatch, ui::end_combo, ui::fitted, ui::hit_area, ui::muted_text,
    ui::row_label, ui::segmented, ui::with_alpha;

bool PictureStage::poll() {
  if (!weaver.poll()) return false;
  const auto set = [](PixelTexture& texture, const Thumbnail& picture) {
    if (!picture.pixels.empty()) texture.set(picture.width, picture.height, picture.pixels, true);
  };
  if (source.empty()) set(source, weaver.source());
  if (shown != weaver.result() && weaver.result()) set(woven, weaver.result()->shown);
  shown = weaver.result();
  return true;
}

namespace {

constexpr ShelfWeave kShelf[] = {
    {mark("Shaded satin by lightness"), ""},
    {mark("Satin, 1 of 8 ends up"), "satin 8/1"},
    {mark("Satin, 2 of 8 ends up"), "satin 8/2"},
    {mark("Satin, 3 of 8 ends up"), "satin 8/3"},
    {mark("Satin, 4 of 8 ends up"), "satin 8/4"},
    {mark("Satin, 5 of 8 ends up"), "satin 8/5"},
    {mark("Satin, 6 of 8 ends up"), "satin 8/6"},
    {mark("Satin, 7 of 8 ends up"), "satin 8/7"},
    {mark("Plain weave"), "plain"},
    {mark("Twill 1/3"), "twill 1/3"},
    {mark("Twill 2/2"), "twill 2/2"},
    {mark("Twill 3/1"), "twill 3/1"},
    {mark("Weave of the open draft"), ""},
    {mark("Type a weave"), ""},
};
constexpr int kOwnWeave = static_cast<int>(std::size(kShelf)) - 2, kTyped = kOwnWeave + 1;
constexpr float kMaxBox = 300, kMinBox = 140, kColumn = 380;  // pixels at 96 dpi

/// Side of the squares for picture and preview: they and the column of choices fit the window.
float box_side(const PanelContext& c) {
  const float room = ImGui::GetMainViewport()->WorkSize.x - c.style.px(kColumn + 100);
  return std::floor(std::clamp(room / 2, c.style.px(kMinBox), c.style.px(kMaxBox)));
}

/// The place of a picture of a : b in a square box at the cursor.
std::pair<ImVec2, ImVec2> place_in_box(const PanelContext& c, int a, int b) {
  const float box = box_side(c);
  const float scale = box / static_cast<float>(std::max({a, b, 1}));
  const ImVec2 size{std::floor(static_cast<float>(a) * scale), std::floor(static_cast<float>(b) * scale)};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 from{at.x + std::floor((box - size.x) / 2), at.y + std::floor((box - size.y) / 2)};
  return {from, {from.x + size.x, from.y + size.y}};
}

void draw_box(const PanelContext& c, const char* words) {
  const float box = box_side(c);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddRectFilled(at, {at.x + box, at.y + box}, c.style.color.window);
  const ImVec2 size = ImGui::CalcTextSize(words, nullptr, false, box - c.style.px(24));
  dl->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + (box - size.x) / 2, at.y + (box - size.y) / 2},
              c.style.color.muted, words, nullptr, box - c.style.px(24));
}

/// The pixel of the picture under the pointer, within its edges.
ImVec2 pixel_at(ImVec2 pointer, ImVec2 a, ImVec2 b, ImageSize size) {
  const auto along = [](float at, float low, float high, int pixels) {
    const float part = (at - low) / std::max(high - low, 1.0f);
    return std::clamp(std::round(part * static_cast<float>(pixels)), 0.0f, static_cast<float>(pixels));
  };
  return {along(pointer.x, a.x, b.x, size.width), along(pointer.y, a.y, b.y, size.height)};
}

/// A drag over the picture chooses the part that is woven; a click all of it.
void drag_crop(PicturePrompt& p, ImVec2 a, ImVec2 b, ImageSize size) {
  if (ImGui::IsItemActivated()) p.drag = pixel_at(ImGui::GetIO().MousePos, a, b, size);
  if (p.drag.x < 0) return;
  const ImVec2 to = pixel_at(ImGui::GetIO().MousePos, a, b, size);
  const int x = static_cast<int>(std::min(p.drag.x, to.x)), y = static_cast<int>(std::min(p.drag.y, to.y));
  const int w = static_cast<int>(std::abs(p.drag.x - to.x)), h = static_cast<int>(std::abs(p.drag.y - to.y));
  p.choices.draft.crop = w > 1 && h > 1 ? PictureCrop{x, y, w, h} : PictureCrop{};
  if (!ImGui::IsItemActive()) p.drag = {-1, -1};
}

void draw_source(PanelContext& c, PicturePrompt& p) {
  const ImageSize size = p.stage->weaver.size();
  const float box = box_side(c);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_box(c,
           p.stage->source.empty() && p.stage->weaver.problem().empty() ? tr("Reading the picture\xE2\x80\xA6") : "");
  const auto [a, b] = place_in_box(c, size.width, size.height);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  if (!p.stage->source.empty()) {
    dl->AddImage(p.stage->source.id(), a, b);
    ImGui::SetCursorScreenPos(a);
    hit_area("picture.source", {b.x - a.x, b.y - a.y});
    c.map.add_item("picture.source");
    drag_crop(p, a, b, size);
    const PictureCrop& crop = p.choices.draft.crop;
    if (crop.width > 0) {
      const float sx = (b.x - a.x) / static_cast<float>(size.width), sy = (b.y - a.y) / static_cast<float>(size.height);
      const ImVec2 from{a.x + static_cast<float>(crop.left) * sx, a.y + static_cast<float>(crop.top) * sy};
      const ImVec2 to{from.x + static_cast<float>(crop.width) * sx, from.y + static_cast<float>(crop.height) * sy};
      const ImU32 veil = with_alpha(c.style.color.window, 0.65f);
      dl->AddRectFilled(a, {b.x, from.y}, veil);
      dl->AddRectFilled({a.x, to.y}, b, veil);
      dl->AddRectFilled({a.x, from.y}, {from.x, to.y}, veil);
      dl->AddRectFilled({to.x, from.y}, {b.x, to.y}, veil);
      dl->AddRect(from, to, c.style.color.accent, 0, 0, c.style.px(1.5f));
    }
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({box, box});
}

void draw_woven(PanelContext& c, const PicturePrompt& p) {
  const float box = box_side(c);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string& problem = p.stage->weaver.problem();
  draw_box(c, problem.c_str());
  if (p.stage->shown && problem.empty()) {
    const auto [a, b] = place_in_box(c, p.stage->shown->shown.width, p.stage->shown->shown.height);
    ImGui::GetWindowDrawList()->AddImage(p.stage->woven.id(), a, b);
    if (p.stage->weaver.is_current()) c.map.add("picture.woven", a.x, a.y, b.x - a.x, b.y - a.y);
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({box, box});
}

std::string fact_text(const PicturePrompt& p) {
  const PictureResult* made = p.stage->shown.get();
  if (!made) return p.stage->weaver.busy() ? tr("Weaving\xE2\x80\xA6") : "";
  const draft::Draft& d = made->design->draft;
  std::string text = fill(tr("{ends} ends, {picks} picks, {shafts} shafts; longest float {float}"),
                          arg("ends", d.ends()), arg("picks", d.picks()), arg("shafts", d.shafts),
                          arg("float", std::max({made->floats.warp_front, made->floats.warp_back,
                                                 made->floats.weft_front, made->floats.weft_back})));
  if (made->wrong > 0) {
    const double part = 100.0 * static_cast<double>(made->wrong) / (static_cast<double>(d.ends()) * d.picks());
    text += "; " + fill(tr("{percent} of the crossings cannot be woven as drawn"),
                        arg("percent", ui::fixed(static_cast<float>(part), 1) + "%"));
  }
  return text;
}

void draw_size(PanelContext& c, PicturePrompt& p) {
  files::PictureDraft& o = p.choices.draft;
  const ImageSize all = p.stage->weaver.size();
  const ImageSize part = o.crop.width > 0 ? ImageSize{o.crop.width, o.crop.height} : all;
  int ends = o.ends > 0 ? o.ends : std::min(part.width, int{kMaxShafts});
  number(c, "picture.ends", tr("Ends"), ends, 2, kMaxShafts);
  o.ends = ends;
  const double in_proportion = part.width > 0 ? std::round(static_cast<double>(part.height) * ends / part.width) : 2;
  const int proportional = static_cast<int>(std::clamp(in_proportion, 2.0, static_cast<double>(kMaxThreads)));
  int picks = p.proportions ? proportional : o.picks;
  const int before = picks;
  number(c, "picture.picks", tr("Picks"), picks, 2, kMaxThreads);
  if (picks != before) p.proportions = false;
  row_label(c, "", nullptr);
  ImGui::Checkbox(tr("Keep proportions"), &p.proportions);
  c.map.add_item("picture.proportions");
  o.picks = p.proportions ? 0 : picks;
}

void draw_loom(PanelContext& c, PicturePrompt& p) {
  constexpr const char* kLooms[] = {mark("Jacquard"), mark("Shafts and treadles")};
  row_label(c, tr("Loom"),
            tr("Jacquard: every end is lifted individually. Otherwise the closest weave that the loom can weave"));
  int loom = p.choices.jacquard ? 0 : 1;
  segmented(c, "picture.loom", kLooms, loom, c.style.px(kColumn - 116));
  p.choices.jacquard = loom == 0;
  if (p.choices.jacquard) return;
  number(c, "picture.shafts", tr("Shafts"), p.choices.loom.shafts, 2, kMaxShafts);
  number(c, "picture.treadles", tr("Treadles"), p.choices.loom.treadles, 2, kMaxShafts);
}

void draw_color(PanelContext& c, PicturePrompt& p, int index) {
  const PictureResult& made = *p.stage->shown;
  const auto i = static_cast<size_t>(index);
  ColorWeave& weave = p.weaves[i];
  const std::string id = "picture.weave:" + std::to_string(index + 1);
  ImGui::PushID(index);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float h = ImGui::GetFrameHeight();
  draw_swatch(c, {at.x, at.y + c.style.px(2)}, {at.x + h, at.y + h - c.style.px(2)}, to_u32(made.colors[i]));
  ImGui::Dummy({h, h});
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  muted_text(c, ui::fixed(100 * made.portion[i], 0) + "%");
  ImGui::SameLine(c.style.px(74));
  ImGui::SetNextItemWidth(c.style.px(weave.shelf == kTyped ? 130 : 270));
  if (begin_combo(c, id.c_str(), tr(kShelf[weave.shelf].label))) {
    for (int row = 0; row < static_cast<int>(std::size(kShelf)); ++row) {
      if (row == kOwnWeave && p.own_weave.rows() < 1) continue;
      if (ImGui::Selectable(tr(kShelf[row].label), row == weave.shelf)) weave.shelf = row;
      c.map.add_item(std::string(id).append(":").append(kShelf[row].label));
    }
    end_combo();
  }
  if (weave.shelf == kTyped) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(c.style.px(134));
    ImGui::InputTextWithHint("##typed", "twill 2/1", &weave.typed);
    c.map.add_item(std::string(id).append(":typed"));
  }
  ImGui::PopID();
}

void draw_colors(PanelContext& c, PicturePrompt& p) {
  files::PictureDraft& o = p.choices.draft;
  const int found = p.stage->shown ? static_cast<int>(p.stage->shown->colors.size()) : 2;
  int colors = o.colors > 0 ? o.colors : found;
  const int before = colors;
  number(c, "picture.colors", tr("Colours"), colors, 2, kMaxPictureColors);
  if (colors != before) o.colors = colors;
  number(c, "picture.floats", tr("Longest float"), o.longest_float, 1, 1000);
  row_label(c, "", nullptr);
  ImGui::Checkbox(tr("Warp and weft in the picture's colours"), &o.own_colors);
  c.map.add_item("picture.own_colors");
  const float rows = 5;
  begin_list("##colors", {c.style.px(kColumn), rows * ImGui::GetFrameHeightWithSpacing()});
  if (p.stage->shown)
    for (int i = 0; i < std::min(found, kMaxPictureColors); ++i) draw_color(c, p, i);
  ImGui::EndChild();
}

Edit picture_edit(const PicturePrompt& p) {
  return {tr("Weave a picture"), [next = p.stage->shown->design](const Design&) { return *next; }};
}

}  // namespace

std::span<const ShelfWeave> picture_shelf() { return kShelf; }

base::Result<PictureChoices> chosen_picture(const PicturePrompt& p) {
  PictureChoices out = p.choices;
  int last = -1;
  for (int i = 0; i < kMaxPictureColors; ++i)
    if (p.weaves[static_cast<size_t>(i)].shelf != 0) last = i;
  out.draft.weaves.clear();
  for (int i = 0; i <= last; ++i) {
    const ColorWeave& weave = p.weaves[static_cast<size_t>(i)];
    if (weave.shelf == kOwnWeave) {
      out.draft.weaves.push_back(p.own_weave);
      continue;
    }
    base::Result<BitMatrix> read =
        weaves::read_weave_words(weave.shelf == kTyped ? std::string_view(weave.typed) : kShelf[weave.shelf].words);
    if (!read) return base::Failure(read.error());
    out.draft.weaves.push_back(std::move(*read));
  }
  return out;
}

DialogResult draw_prompt(PanelContext& c, PicturePrompt& p) {
  heading(c, tr("Weave a picture"));
  muted_text(c, fitted(p.name, 2 * box_side(c)));
  ImGui::BeginGroup();
  draw_source(c, p);
  muted_text(c, p.choices.draft.crop.width > 0
                    ? fill(tr("{width} by {height} pixels of the picture; click to select all"),
                           arg("width", p.choices.draft.crop.width), arg("height", p.choices.draft.crop.height))
                    : std::string(tr("Drag over the picture to weave a part of it")));
  ImGui::EndGroup();
  ImGui::SameLine(0, c.style.px(12));
  ImGui::BeginGroup();
  draw_woven(c, p);
  muted_text(c, fitted(fact_text(p), box_side(c)));
  ImGui::EndGroup();
  ImGui::SameLine(0, c.style.px(20));
  ImGui::BeginGroup();
  if (p.stage->weaver.size().width > 0) {
    draw_size(c, p);
    draw_loom(c, p);
    draw_colors(c, p);
    const base::Result<PictureChoices> choices = chosen_picture(p);
    p.why = choices ? std::string() : message(choices.error());
    if (choices && p.drag.x < 0) p.stage->weaver.ask(*choices);
  }
  if (!p.why.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + c.style.px(kColumn));
    ImGui::TextUnformatted(p.why.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  ImGui::EndGroup();
  const bool ready = p.stage->weaver.is_current() && p.stage->shown == p.stage->weaver.result() && p.why.empty();
  const int pressed = draw_buttons(c, {mark("Weave the picture"), mark("Cancel")}, true);
  // What is chosen may still be woven.
  p.accepted = (p.accepted || pressed == 0) && p.why.empty() && p.stage->weaver.problem().empty();
  if (!p.accepted || !ready) return pressed == 0 ? DialogResult{} : dialog_result(pressed);
  DialogResult result = dialog_result(0);
  result.edit = picture_edit(p);
  return result;
}

}  // namespace weftlight::views
