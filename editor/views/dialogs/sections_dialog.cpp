// Threads from sections: take them from the draft, write or click their order, and see it woven at once. Cancel gives
// back what was there.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "draft/generators/sections.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {
namespace {

constexpr float kWidth = 430, kSections = 118, kRows = 176, kIndent = 18;  // pixels at 96 dpi

struct Page {
  SectionsPrompt& p;
  System system;
  Assembly& assembly;
  const char *one, *many;
  bool changed = false;
  int count() const { return p.base->draft.threads(system).size(); }
};

std::string counted(const Page& page, int n) { return std::to_string(n) + " " + (n == 1 ? page.one : page.many); }

/// All steps of the dialog are one step of undo, each made anew from the draft that it found.
MaybeEdit follow(SectionsPrompt& p) {
  Assembled warp = assembled(*p.base, System::kWarp, p.warp);
  Assembled both = assembled(std::move(warp.design), System::kWeft, p.weft);
  p.why = warp.why.empty() ? std::move(both.why) : std::move(warp.why);
  return Edit{"Threads from sections",
              [next = std::make_shared<const Design>(std::move(both.design))](const Design&) { return *next; },
              p.stroke};
}

void draw_take(PanelContext& c, Page& page) {
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
  row_label(c, page.system == System::kWarp ? "From ends" : "From picks", "What is selected, or any other threads");
  field("sections.first", first);
  ImGui::SameLine();
  ImGui::TextUnformatted("\xE2\x80\x93");
  ImGui::SameLine();
  field("sections.last", last);
  ImGui::SameLine(0, c.style.px(16));
  muted_text(c, "as");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(c.style.px(80));
  ImGui::InputText("##name", &page.p.name);
  c.map.add_item("sections.name");
  ImGui::SameLine();
  if (!text_button(c, "sections.take", "Take", "Keeps these threads as a section; one of that name becomes these"))
    return;
  const std::string name = section_name(page.p.name);
  if (name.empty()) return;
  const int low = std::min(first, last), high = std::max(first, last);
  page.assembly = with_section(std::move(page.assembly), section_of(*page.p.base, {page.system, low - 1, high}, name));
  page.p.name = free_section_name(page.assembly);
  page.changed = true;
}

/// The colours of its threads, side by side.
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
  ImGui::BeginChild("sections", {c.style.px(kWidth), c.style.px(kSections)});
  int drop = -1;
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
    if (text_button(c, ("sections.add:" + number).c_str(), "+", "Once more at the end of the order")) {
      page.assembly.order += (page.assembly.order.empty() ? "" : ", ") + section.name;
      page.changed = true;
    }
    ImGui::SameLine();
    if (icon_button(c, ("sections.drop:" + number).c_str(), icon::kClear, "x", "Drop the section"))
      drop = static_cast<int>(i);
    ImGui::PopID();
  }
  if (page.assembly.sections.empty()) muted_text(c, "No sections yet: choose threads above and take them.");
  ImGui::EndChild();
  if (drop < 0) return;
  page.assembly.sections.erase(page.assembly.sections.begin() + drop);
  page.changed = true;
}

enum class RowRequest { kNone, kUp, kDown, kDrop, kGroup, kLoose };

RowRequest draw_row(PanelContext& c, const OrderRow& row, int index, int& times) {
  const std::string number = std::to_string(index + 1);
  RowRequest requested = RowRequest::kNone;
  ImGui::PushID(index);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + c.style.px(kIndent) * static_cast<float>(row.path.size() - 1));
  ImGui::AlignTextToFramePadding();
  if (row.section.empty()) muted_text(c, "together");
  else ImGui::TextUnformatted(fitted(row.section, c.style.px(120)).c_str());
  ImGui::SameLine(c.style.px(170));
  ImGui::SetNextItemWidth(c.style.px(90));
  ImGui::InputInt("##times", &times);
  c.map.add_item("sections.times:" + number);
  times = std::clamp(times, 1, kMaxThreads);
  const auto button = [&](const char* id, const char* label, const char* tip, RowRequest to) {
    ImGui::SameLine(0, c.style.px(4));
    if (text_button(c, (std::string(id) + ":" + number).c_str(), label, tip)) requested = to;
  };
  button("sections.up", "\xE2\x86\x91", "Earlier", RowRequest::kUp);
  button("sections.down", "\xE2\x86\x93", "Later", RowRequest::kDown);
  if (row.section.empty()) button("sections.loose", "( )", "Its sections one by one", RowRequest::kLoose);
  else button("sections.group", "( )", "Together with the next, to be repeated as one", RowRequest::kGroup);
  button("sections.out", "x", "Out of the order", RowRequest::kDrop);
  ImGui::PopID();
  return requested;
}

void carry_out(std::vector<OrderItem>& items, const OrderRow& row, RowRequest requested) {
  std::vector<OrderItem>& list = list_of(items, row.path);
  const auto at = static_cast<size_t>(row.path.back());
  if (requested == RowRequest::kUp && at > 0) std::swap(list[at], list[at - 1]);
  if (requested == RowRequest::kDown && at + 1 < list.size()) std::swap(list[at], list[at + 1]);
  if (requested == RowRequest::kDrop) list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
  if (requested == RowRequest::kGroup) {
    const size_t many = std::min<size_t>(2, list.size() - at);
    OrderItem group;
    group.items.assign(list.begin() + static_cast<std::ptrdiff_t>(at),
                       list.begin() + static_cast<std::ptrdiff_t>(at + many));
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(at), list.begin() + static_cast<std::ptrdiff_t>(at + many));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), std::move(group));
  }
  if (requested == RowRequest::kLoose) {
    const std::vector<OrderItem> inside = std::move(list[at].items);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), inside.begin(), inside.end());
  }
}

void draw_order(PanelContext& c, Page& page) {
  constexpr size_t kMaxRows = 200;  // the text holds more
  row_label(c, "Order",
            "A 4x, (B C) 3x, A: each section by its name, how often behind it, brackets for what is repeated");
  ImGui::SetNextItemWidth(c.style.px(kWidth - 112));
  page.changed |= ImGui::InputTextWithHint("##order", "A 4x, (B C) 3x, A", &page.assembly.order);
  c.map.add_item("sections.order");
  Order order = read_order(page.assembly.order);
  ImGui::BeginChild("order", {c.style.px(kWidth), c.style.px(kRows)});
  if (order.why.empty()) {
    const std::vector<OrderRow> rows = order_rows(order.items);
    RowRequest requested = RowRequest::kNone;
    size_t of = 0;
    bool other = false;
    for (size_t i = 0; i < std::min(rows.size(), kMaxRows); ++i) {
      int times = rows[i].times;
      const RowRequest own = draw_row(c, rows[i], static_cast<int>(i), times);
      if (own != RowRequest::kNone) requested = own, of = i;
      if (times == rows[i].times) continue;
      item_at(order.items, rows[i].path).times = times;
      other = true;
    }
    if (requested != RowRequest::kNone) carry_out(order.items, rows[of], requested);
    if (other || requested != RowRequest::kNone) page.assembly.order = order_text(order.items), page.changed = true;
  }
  ImGui::EndChild();
}

void draw_result(PanelContext& c, const Page& page) {
  const Order order = read_order(page.assembly.order);
  const int made = assembled_threads(page.assembly, order.items);
  if (!page.p.why.empty()) ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
  else ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  ImGui::TextUnformatted(fitted(!page.p.why.empty() ? page.p.why
                                : made > 0          ? "makes " + counted(page, made)
                                                    : "The threads stay as they are until there is an order.",
                                c.style.px(kWidth))
                             .c_str());
  ImGui::PopStyleColor();
}

}  // namespace

DialogAnswer draw_sections(PanelContext& c, SectionsPrompt& p) {
  constexpr const char* kPages[] = {"Threading", "Treadling"};
  heading(c, "Threads from sections");
  int shown = p.system == System::kWarp ? 0 : 1;
  if (segmented(c, "sections.page", kPages, shown, c.style.px(kWidth))) {
    p.system = shown == 0 ? System::kWarp : System::kWeft;
    p.name = free_section_name(shown == 0 ? p.warp : p.weft);
  }
  const bool warp = p.system == System::kWarp;
  Page page{p, p.system, warp ? p.warp : p.weft, warp ? "end" : "pick", warp ? "ends" : "picks"};
  ImGui::PushID(shown);
  draw_take(c, page);
  draw_sections(c, page);
  draw_order(c, page);
  draw_result(c, page);
  ImGui::PopID();
  DialogAnswer answer = answered(draw_buttons(c, {"Keep", "Cancel"}, false));
  if (page.changed) answer.edit = follow(p);
  return answer;
}

MaybeEdit given_back(const SectionsPrompt& p) {
  return Edit{"Threads from sections", [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
