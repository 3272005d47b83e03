// Threads from sections: add ranges of the draft as sections, type or click their order, and the draft follows. Cancel
// restores the draft.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "base/text.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"
#include "weaves/sections.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using design::Assembly, design::Design, design::ThreadSection;
using draft::Rgb, draft::System, draft::kMaxThreads;
using session::Edit, session::MaybeEdit;
using ui::begin_list, ui::fitted, ui::icon_button, ui::muted_text, ui::row_label, ui::segmented, ui::text_button,
    ui::with_alpha;
using weaves::OrderItem, weaves::OrderRow, weaves::Turn, weaves::assembled, weaves::assembled_threads,
    weaves::free_section_name, weaves::item_at, weaves::list_of, weaves::order_rows, weaves::order_text,
    weaves::read_order, weaves::section_name, weaves::section_of, weaves::with_section;

namespace {

constexpr float kWidth = 430, kSections = 118, kRows = 176, kIndent = 18;  // pixels at 96 dpi

struct Page {
  SectionsPrompt& p;
  System system;
  Assembly& assembly;
  bool changed = false;
  int count() const { return p.base->draft.threads(system).size(); }
};

std::string counted(const Page& page, int n) {
  const bool warp = page.system == System::kWarp;
  return fill(warp ? tr_n("{count} end", "{count} ends", n) : tr_n("{count} pick", "{count} picks", n),
              arg("count", n));
}

/// Every change in the dialog starts again from the draft as it was, and all of them are one undo step.
MaybeEdit preview_edit(SectionsPrompt& p) {
  // What can be assembled is shown, and the first problem.
  const base::Result<Design> warp = assembled(*p.base, System::kWarp, p.warp);
  Design made = warp.value_or(*p.base);
  const base::Result<Design> both = assembled(made, System::kWeft, p.weft);
  if (both) made = *both;
  p.why = warp ? problem_of(both) : problem_of(warp);
  return Edit{tr("Build from sections"),
              [next = std::make_shared<const Design>(std::move(made))](const Design&) { return *next; }, p.stroke};
}

void draw_range(PanelContext& c, Page& page) {
  int& first = page.system == System::kWarp ? page.p.first_end : page.p.first_pick;
  int& last = page.system == System::kWarp ? page.p.last_end : page.p.last_pick;
  const auto field = [&](const char* id, int& value) {
    ImGui::SetNextItemWidth(c.style.px(56));
    ImGui::PushID(id);
    ImGui::InputInt("##n", &value, 0);
    ImGui::PopID();
    c.map.add_item(id);
    value = std::clamp(value, 1, page.count());
  };
  row_label(c, page.system == System::kWarp ? tr("Ends") : tr("Picks"), tr("The range of threads to add as a section"));
  begin_here();
  field("sections.first", first);
  ImGui::SameLine();
  ImGui::TextUnformatted("\xE2\x80\x93");
  ImGui::SameLine();
  field("sections.last", last);
  ImGui::SameLine(0, c.style.px(16));
  muted_text(c, tr("Name"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(c.style.px(80));
  ImGui::InputText("##name", &page.p.name);
  c.map.add_item("sections.name");
  ImGui::SameLine();
  if (!text_button(c, "sections.take", tr("Add"),
                   tr("Add these threads as a section; a section of the same name is replaced")))
    return;
  const std::string name = section_name(page.p.name);
  if (name.empty()) return;
  const int low = std::min(first, last), high = std::max(first, last);
  page.assembly = with_section(std::move(page.assembly), section_of(*page.p.base, {page.system, low - 1, high}, name));
  page.p.name = free_section_name(page.assembly);
  page.changed = true;
}

/// The thread colours of the section, side by side.
void draw_strip(const PanelContext& c, const Page& page, const ThreadSection& section, ImVec2 a, ImVec2 b) {
  const std::vector<Rgb>& palette = page.p.base->draft.palette;
  const int n = section.threads.size();
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const auto pixels = static_cast<int>(b.x - a.x);
  for (int x = 0; x < pixels && n > 0; ++x) {
    const auto color = static_cast<size_t>(section.threads.color[static_cast<size_t>(x * n / pixels)]);
    const float left = a.x + static_cast<float>(x);
    dl->AddRectFilled({left, a.y}, {left + 1, b.y}, to_u32(palette[color < palette.size() ? color : 0]));
  }
  dl->AddRect(a, b, with_alpha(c.style.color.text, 0.25f));
}

void draw_sections(PanelContext& c, Page& page) {
  begin_list("sections", {c.style.px(kWidth), c.style.px(kSections)});
  int deleted = -1;
  for (size_t i = 0; i < page.assembly.sections.size(); ++i) {
    const ThreadSection& section = page.assembly.sections[i];
    const std::string number = std::to_string(i + 1);
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fitted(section.name, c.style.px(90)).c_str());
    ImGui::SameLine(c.style.px(100));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float h = ImGui::GetFrameHeight(), inset = c.style.px(5);
    draw_strip(c, page, section, {at.x, at.y + inset}, {at.x + c.style.px(130), at.y + h - inset});
    ImGui::Dummy({c.style.px(130), h});
    ImGui::SameLine(0, c.style.px(10));
    muted_text(c, counted(page, section.threads.size()));
    ImGui::SameLine(c.style.px(kWidth - 90));
    if (text_button(c, ("sections.add:" + number).c_str(), "+", tr("Append to the order"))) {
      page.assembly.order += (page.assembly.order.empty() ? "" : ", ") + section.name;
      page.changed = true;
    }
    ImGui::SameLine();
    if (icon_button(c, ("sections.drop:" + number).c_str(), icon::kClear, "x", tr("Delete the section")))
      deleted = static_cast<int>(i);
    ImGui::PopID();
  }
  if (page.assembly.sections.empty()) {
    ImGui::PushTextWrapPos(0);
    muted_text(c, tr("No sections yet. Enter a range of threads above and press Add."));
    ImGui::PopTextWrapPos();
    c.map.add_item("sections.none");
  }
  ImGui::EndChild();
  if (deleted < 0) return;
  page.assembly.sections.erase(page.assembly.sections.begin() + deleted);
  page.changed = true;
}

enum class RowRequest { kNone, kUp, kDown, kRemove, kGroup, kUngroup, kTurn };

RowRequest draw_row(PanelContext& c, const OrderRow& row, int index, int& times) {
  const std::string number = std::to_string(index + 1);
  RowRequest requested = RowRequest::kNone;
  ImGui::PushID(index);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + c.style.px(kIndent) * static_cast<float>(row.path.size() - 1));
  ImGui::AlignTextToFramePadding();
  if (row.section.empty()) muted_text(c, tr("group"));
  else ImGui::TextUnformatted(fitted(row.section, c.style.px(120)).c_str());
  ImGui::SameLine(c.style.px(170));
  ImGui::SetNextItemWidth(c.style.px(90));
  ImGui::InputInt("##times", &times);
  c.map.add_field("sections.times:" + number, field_of_number("##times"));
  times = std::clamp(times, 1, kMaxThreads);
  const auto button = [&](const char* id, const char* label, const char* tip, RowRequest to) {
    ImGui::SameLine(0, c.style.px(4));
    if (text_button(c, (std::string(id) + ":" + number).c_str(), label, tip)) requested = to;
  };
  constexpr const char* kTurns[] = {"\xE2\x86\x92", "\xE2\x86\x90", "<>"};
  button("sections.turn", kTurns[static_cast<size_t>(row.turn)],
         tr("Forwards, backwards (A') or both (A<>), with a single thread at the turn"), RowRequest::kTurn);
  button("sections.up", "\xE2\x86\x91", tr("Move up"), RowRequest::kUp);
  button("sections.down", "\xE2\x86\x93", tr("Move down"), RowRequest::kDown);
  if (row.section.empty()) button("sections.loose", "( )", tr("Ungroup"), RowRequest::kUngroup);
  else button("sections.group", "( )", tr("Group with the next, to repeat them together"), RowRequest::kGroup);
  button("sections.out", "x", tr("Remove from the order"), RowRequest::kRemove);
  ImGui::PopID();
  return requested;
}

void apply_request(std::vector<OrderItem>& items, const OrderRow& row, RowRequest requested) {
  std::vector<OrderItem>& list = list_of(items, row.path);
  const auto at = static_cast<size_t>(row.path.back());
  if (requested == RowRequest::kUp && at > 0) std::swap(list[at], list[at - 1]);
  if (requested == RowRequest::kDown && at + 1 < list.size()) std::swap(list[at], list[at + 1]);
  if (requested == RowRequest::kTurn) list[at].turn = static_cast<Turn>((static_cast<int>(list[at].turn) + 1) % 3);
  if (requested == RowRequest::kRemove) list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
  if (requested == RowRequest::kGroup) {
    const size_t many = std::min<size_t>(2, list.size() - at);
    OrderItem group;
    group.items.assign(list.begin() + static_cast<std::ptrdiff_t>(at),
                       list.begin() + static_cast<std::ptrdiff_t>(at + many));
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(at), list.begin() + static_cast<std::ptrdiff_t>(at + many));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), std::move(group));
  }
  if (requested == RowRequest::kUngroup) {
    const std::vector<OrderItem> inside = std::move(list[at].items);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), inside.begin(), inside.end());
  }
}

void draw_order(PanelContext& c, Page& page) {
  constexpr size_t kMaxRows = 200;  // more can be typed
  row_label(c, tr("Order"),
            tr("Names of sections, each with its number of repeats, and brackets for groups: A 4x, (B C) 3x, A. A' "
               "runs backwards, A<> both ways"));
  ImGui::SetNextItemWidth(c.style.px(kWidth - 112));
  page.changed |= ImGui::InputTextWithHint("##order", "A 4x, (B C) 3x, A", &page.assembly.order);
  c.map.add_item("sections.order");
  base::Result<std::vector<OrderItem>> order = read_order(page.assembly.order);
  begin_list("order", {c.style.px(kWidth), c.style.px(kRows)});
  if (order) {
    const std::vector<OrderRow> rows = order_rows(*order);
    RowRequest requested = RowRequest::kNone;
    size_t requested_row = 0;
    bool changed = false;
    for (size_t i = 0; i < std::min(rows.size(), kMaxRows); ++i) {
      int times = rows[i].times;
      const RowRequest own = draw_row(c, rows[i], static_cast<int>(i), times);
      if (own != RowRequest::kNone) requested = own, requested_row = i;
      if (times == rows[i].times) continue;
      item_at(*order, rows[i].path).times = times;
      changed = true;
    }
    if (requested != RowRequest::kNone) apply_request(*order, rows[requested_row], requested);
    if (changed || requested != RowRequest::kNone) page.assembly.order = order_text(*order), page.changed = true;
  }
  ImGui::EndChild();
}

void draw_result(PanelContext& c, const Page& page) {
  const base::Result<std::vector<OrderItem>> order = read_order(page.assembly.order);
  const int made = order ? assembled_threads(page.assembly, *order) : 0;
  if (!page.p.why.empty()) ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
  else ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  const std::string text = !page.p.why.empty() ? page.p.why
                           : made > 0          ? fill(tr("Result: {threads}"), arg("threads", counted(page, made)))
                                               : tr("The threads stay as they are until you enter an order.");
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + c.style.px(kWidth));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, SectionsPrompt& p) {
  constexpr const char* kPages[] = {mark("Threading"), mark("Treadling")};
  heading(c, tr("Threads from sections"));
  int shown = p.system == System::kWarp ? 0 : 1;
  if (segmented(c, "sections.page", kPages, shown, c.style.px(kWidth))) {
    p.system = shown == 0 ? System::kWarp : System::kWeft;
    p.name = free_section_name(shown == 0 ? p.warp : p.weft);
  }
  const bool warp = p.system == System::kWarp;
  Page page{p, p.system, warp ? p.warp : p.weft};
  ImGui::PushID(shown);
  draw_range(c, page);
  draw_sections(c, page);
  draw_order(c, page);
  draw_result(c, page);
  ImGui::PopID();
  MaybeEdit edit;
  if (page.changed) edit = preview_edit(p);
  return edited(std::move(edit), dialog_result(draw_buttons(c, {mark("Apply"), mark("Cancel")}, false, p.why.empty())));
}

MaybeEdit restored(const SectionsPrompt& p) {
  return Edit{tr("Build from sections"), [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
