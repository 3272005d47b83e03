// The page of the gallery that browses a folder. Only the cards in sight are drawn and have pictures.

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "base/text.h"
#include "collection/colour_names.h"
#include "session/library/folder_browser.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"
#include "views/dialogs/gallery_cards.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using collection::DraftEntry, collection::DraftQuery, collection::Entries, collection::Span;
using ui::begin_combo, ui::end_combo, ui::fitted, ui::muted_text, ui::text_button;

namespace {

/// The counts of shafts and treadles that looms have.
constexpr std::array kUpTo = {4, 8, 12, 16, 24, 32};
constexpr std::array kExactly = {2, 3, 4, 5, 6, 8, 10, 12, 14, 16, 20, 24, 32};
constexpr float kListRows = 22;

std::string span_text(const Span& span) {
  if (span.any()) return tr("any");
  if (span.least == 0) return fill(tr("up to {count}"), arg("count", span.most));
  return std::to_string(span.least);
}

bool choice(const PanelContext& c, const std::string& id, const std::string& label, bool chosen) {
  const bool pressed = ImGui::Selectable(label.c_str(), chosen);
  c.map.add_item(id);
  return pressed;
}

/// A label and a list beside it; in the next row where this one is full. True while the list is open: then end_filter.
bool begin_filter(const PanelContext& c, const char* id, const char* label, const std::string& shown, float right) {
  const float list = c.style.px(118), gap = c.style.px(6), words = ImGui::CalcTextSize(label).x;
  if (ImGui::GetCursorScreenPos().x + words + gap + list > right) ImGui::NewLine();
  ImGui::AlignTextToFramePadding();
  muted_text(c, label);
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(list);
  // All counts at once where the screen has room; ImGui's own lists show eight.
  ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, kListRows * ImGui::GetFrameHeightWithSpacing()});
  return begin_combo(c, id, shown.c_str());
}

void filter_span(const PanelContext& c, const char* id, const char* label, Span& span, float right) {
  if (begin_filter(c, id, label, span_text(span), right)) {
    const auto one = [&](const Span& to) {
      if (choice(c, std::string(id) + ":" + std::to_string(to.least) + "-" + std::to_string(to.most), span_text(to),
                 span == to))
        span = to;
    };
    one({});
    for (const int most : kUpTo) one({0, most});
    ImGui::Separator();
    for (const int count : kExactly) one({count, count});
    end_combo();
  }
  ImGui::SameLine(0, c.style.px(14));
}

void filter_family(const PanelContext& c, DraftQuery& q, float right) {
  const auto name = [](const std::optional<analysis::WeaveFamily>& family) {
    return std::string(family ? tr(analysis::kWeaveFamilyNames[static_cast<size_t>(*family)].label) : tr("any"));
  };
  if (begin_filter(c, "folder.family", tr("Weave"), name(q.family), right)) {
    if (choice(c, "folder.family:any", tr("any"), !q.family)) q.family.reset();
    for (size_t i = 1; i <= analysis::kWeaveFamilies; ++i) {  // "other" stands last
      const auto family = static_cast<analysis::WeaveFamily>(i % analysis::kWeaveFamilies);
      if (choice(c, std::string("folder.family:") + analysis::kWeaveFamilyNames[i % analysis::kWeaveFamilies].id,
                 name(family), q.family == family))
        q.family = family;
    }
    end_combo();
  }
  ImGui::SameLine(0, c.style.px(14));
}

void filter_colour(const PanelContext& c, DraftQuery& q, float right) {
  std::string shown;
  for (size_t i = 0; i < collection::kColourNames.size(); ++i)
    if (q.colours >> i & 1) shown += (shown.empty() ? "" : ", ") + std::string(tr(collection::kColourNames[i].label));
  if (!begin_filter(c, "folder.colour", tr("Colours"), shown.empty() ? tr("any") : shown, right)) return;
  if (choice(c, "folder.colour:any", tr("any"), q.colours == 0)) q.colours = 0;
  for (size_t i = 0; i < collection::kColourNames.size(); ++i) {
    bool on = (q.colours >> i & 1) != 0;
    if (ImGui::Checkbox(tr(collection::kColourNames[i].label), &on)) q.colours ^= uint32_t{1} << i;
    c.map.add_item(std::string("folder.colour:") + collection::kColourNames[i].id);
  }
  end_combo();
}

std::string facts_of(const DraftEntry& e) {
  if (!e.readable) return {};
  const std::string weave = tr(analysis::kWeaveFamilyNames[static_cast<size_t>(e.family)].label);
  return fill(tr_n("{count} shaft, {weave}", "{count} shafts, {weave}", e.shafts), arg("count", e.shafts),
              arg("weave", weave));
}

GalleryCard card_of(const DraftEntry& e) {
  GalleryCard card{e.path, collection::shown_name(e), facts_of(e), false};
  card.kept = false;
  return card;
}

/// What is found, how many of how many, and what goes on.
void draw_state(PanelContext& c, GalleryPrompt& p, float width) {
  const auto& browser = *p.browser;
  const auto all = static_cast<int>(browser.entries()->size()), found = static_cast<int>(browser.found().size());
  std::string text = found == all ? fill(tr_n("{count} draft", "{count} drafts", all), arg("count", all))
                                  : fill(tr("{found} of {all} drafts"), arg("found", found), arg("all", all));
  if (const std::string said = browser.said(); !said.empty()) text += "   " + said;
  const char* stop = tr("Stop");
  const bool reading = browser.is_reading();
  ImGui::AlignTextToFramePadding();
  muted_text(c, fitted(text, width - (reading ? ImGui::CalcTextSize(stop).x + c.style.px(40) : 0)));
  c.map.add_item(reading ? "folder.reading" : "folder.read");
  if (!reading) return;
  ImGui::SameLine();
  if (text_button(c, "folder.stop", stop, nullptr)) p.browser->stop();
}

std::string draw_cards(PanelContext& c, GalleryPrompt& p, int columns) {
  const Entries& entries = *p.browser->entries();
  const std::vector<int>& found = p.browser->found();
  const ImVec2 size = card_size(c, p.page), first = ImGui::GetCursorScreenPos();
  const float gap = c.style.px(kCardGap), step = size.y + gap, top = ImGui::GetWindowPos().y;
  const auto count = static_cast<int>(found.size()), rows = (count + columns - 1) / columns;
  if (p.follow && p.chosen >= 0) {
    ImGui::SetScrollFromPosY(first.y + static_cast<float>(p.chosen / columns) * step + size.y / 2 - top, 0.5f);
    p.follow = false;
  }
  const int first_row = std::max(0, static_cast<int>((top - first.y) / step));
  const int last_row = std::min(rows - 1, static_cast<int>((top + ImGui::GetWindowHeight() - first.y) / step));
  std::string open;
  for (int i = first_row * columns; i < std::min(count, (last_row + 1) * columns); ++i) {
    const DraftEntry& entry = entries[static_cast<size_t>(found[static_cast<size_t>(i)])];
    const ImVec2 at{first.x + static_cast<float>(i % columns) * (size.x + gap),
                    first.y + static_cast<float>(i / columns) * step};
    if (draw_card(c, p, card_of(entry), i, at) == CardRequest::kOpen) open = entry.path;
  }
  ImGui::SetCursorScreenPos({first.x, first.y + static_cast<float>(rows) * step - gap});
  ImGui::Dummy({1, 1});
  return open;
}

}  // namespace

std::string draw_folder_page(PanelContext& c, GalleryPrompt& p, ImVec2 size, int columns, bool& choose) {
  const float right = ImGui::GetCursorScreenPos().x + size.x;
  filter_span(c, "folder.shafts", tr("Shafts"), p.filter.shafts, right);
  filter_span(c, "folder.treadles", tr("Treadles"), p.filter.treadles, right);
  filter_family(c, p.filter, right);
  filter_colour(c, p.filter, right);
  DraftQuery query = p.filter;
  query.words = p.typed;
  p.browser->search(query);
  draw_state(c, p, size.x);
  const auto count = static_cast<int>(p.browser->found().size());
  p.chosen = std::min(p.chosen, count - 1);
  move_choice(p, count, columns);
  std::string open;
  const float taken = 2 * ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("cards", {size.x, std::max(c.style.px(80), size.y - taken)});
  if (p.browser->folder().empty()) {
    muted_text(c, tr("Choose a folder; its drafts, and those in the folders within, are listed here."));
    choose = text_button(c, "folder.choose", tr("Choose folder\xE2\x80\xA6"), nullptr);
  } else if (count == 0 && !p.browser->busy()) {
    muted_text(c, p.browser->entries()->empty() ? tr("There are no drafts in this folder.") : tr("No draft matches."));
  } else {
    open = draw_cards(c, p, columns);
  }
  ImGui::EndChild();
  return open;
}

}  // namespace weftlight::views
