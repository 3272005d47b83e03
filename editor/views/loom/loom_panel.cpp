#include "views/loom/loom_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/loom/loom_drawing.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_in, base::tr_n;
using design::Design;
using session::DocumentView, session::LoomWork, session::Settings, session::go_to, session::keep_to_section,
    session::put_tabby_between;
using ui::begin_combo, ui::blend, ui::end_combo, ui::fitted, ui::muted_text, ui::push_font, ui::row_label,
    ui::segmented, ui::text_button, ui::tooltip;

namespace {

using Panel = ViewContext<LoomView>;

// Pixels at 96 dpi.
constexpr float kMargin = 28, kFoot = 190, kMinForStrip = 900;

std::string line_text(const LoomLine& line, loom::Protocol protocol, LoomWork work) {
  switch (line.state) {
    case LoomLink::State::kOff:
      if (work != LoomWork::kWeave) return tr("Not connected. Space or a click: next step; Backspace: previous step");
      return tr("Not connected. Space or a click: next step; Backspace: previous step; T: tabby");
    case LoomLink::State::kConnecting:
      return line.why.empty() ? tr("Connecting to the loom\xE2\x80\xA6")
                              : fill(tr("Trying again: {reason}"), arg("reason", line.why));
    case LoomLink::State::kConnected:
      break;
  }
  if (loom::takes_picks_ahead(protocol))
    return tr("Connected with the published AVL protocol, not yet tested on a loom. Watch the first picks");
  return protocol == loom::Protocol::kToikaEs
             ? tr("Connected. This loom does not ask for picks; press Space for the next one")
             : tr("Connected. The loom asks for each pick");
}

/// By value of loom::Protocol.
std::array<const char*, 5> protocol_names() {
  return {tr_in("protocol", "Plain"), "S\xC3\xA9guin", "Toika ES", "AVL Compu-Dobby II, III", "AVL Compu-Dobby IV"};
}

void choose_protocol(Panel& c) {
  const auto names = protocol_names();
  const auto now = static_cast<size_t>(c.view.at_loom.protocol);
  ImGui::SetNextItemWidth(c.style.px(210));
  if (begin_combo(c, "loom.protocol", names[now])) {
    for (size_t i = 0; i < names.size(); ++i) {
      if (ImGui::Selectable(names[i], i == now))
        c.wanted.change_view([i](DocumentView& v) { v.at_loom.protocol = static_cast<loom::Protocol>(i); });
      c.map.add_item("loom.protocol:" + std::to_string(i));
    }
    end_combo();
  }
  tooltip(c, tr("The loom's protocol. The AVL protocols follow third-party descriptions and were tested with a "
                "simulator only. Louet publishes none"));
}

void draw_line(Panel& c, std::string& address) {
  const LoomLine& line = c.view.line;
  row_label(c, tr("Loom address"), tr("tcp:HOST:PORT or serial:/dev/ttyUSB0, followed by :BAUD if it is not 9600"));
  ImGui::SetNextItemWidth(c.style.px(220));
  const bool enter =
      ImGui::InputTextWithHint("##address", "tcp:HOST:PORT", &address, ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("loom.address");
  if (address != c.settings.loom_address)
    c.wanted.change_settings([address](Settings& s) { s.loom_address = address; });
  ImGui::SameLine();
  choose_protocol(c);
  ImGui::SameLine();
  const bool off = line.state == LoomLink::State::kOff;
  if (text_button(c, off ? "loom.connect" : "loom.disconnect", off ? tr("Connect") : tr("Disconnect"), nullptr) ||
      (enter && off))
    c.wanted.add_action(off ? "loom_connect" : "loom_disconnect");
}

/// What the loom, the page or the draft has to tell.
void draw_status(Panel& c) {
  const LoomLine& line = c.view.line;
  const AtLoom& at = c.view.at_loom;
  const bool bad = !line.why.empty() || !at.remark.empty() || !c.view.page_error.empty();
  std::string text = at.remark.empty() ? c.view.page_error : at.remark;
  if (text.empty()) text = line_text(line, at.protocol, at.work);
  ImGui::PushStyleColor(ImGuiCol_Text, bad ? c.style.color.warn : c.style.color.muted);
  row_label(c, "", nullptr);
  ImGui::TextUnformatted(fitted(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
  c.map.add_item(line.state == LoomLink::State::kConnected ? "loom.connected" : "loom.line");
}

std::string address_text(const platform::OwnAddress& one) {
  if (one.this_machine_only) return fill(tr("{address} (this machine only)"), arg("address", one.address));
  return fill(tr("{address} ({network})"), arg("address", one.address), arg("network", one.network));
}

/// "482 913": six digits are read in two groups.
std::string spaced(const std::string& code) {
  constexpr size_t kGroup = 3;
  std::string text = code.substr(0, kGroup);
  if (code.size() > kGroup) text.append(" ").append(code, kGroup);
  return text;
}

std::string page_text(const PhoneLink::Status& page) {
  const platform::PageRefusals& refused = page.refusals;
  if (refused.connections + refused.requests > 0)
    return fill(tr("Refused connections: {connections}. Refused requests: {requests}. Last from {peer}"),
                arg("connections", refused.connections), arg("requests", refused.requests), arg("peer", refused.peer));
  if (page.code.empty()) return tr("Pairing is closed after too many wrong codes");
  return fill(tr_n("{count} device is paired", "{count} devices are paired", static_cast<long long>(page.paired)),
              arg("count", page.paired));
}

void draw_served_page(Panel& c) {
  const PhoneLink::Status& page = c.view.page;
  ImGui::AlignTextToFramePadding();
  push_font(c.style.font.mono);
  ImGui::TextUnformatted(page.url.c_str());
  c.map.add_item("loom.page_url:" + page.url);
  ImGui::SameLine(0, c.style.px(16));
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.accent);
  ImGui::TextUnformatted(spaced(page.code).c_str());
  c.map.add_item("loom.page_code:" + page.code);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::SameLine(0, c.style.px(16));
  if (text_button(c, "loom.page_renew", tr("New code"), tr("A new code; failed attempts are reset")))
    c.wanted.add_action("loom_page_code");
  ImGui::SameLine();
  if (text_button(c, "loom.page_off", tr("Stop"), tr("Stop the page and unpair all devices")))
    c.wanted.add_action("loom_page_off");
  ImGui::SameLine(0, c.style.px(12));
  muted_text(c, fitted(page_text(page), ImGui::GetContentRegionAvail().x));
}

/// The page for a phone: where it shall be, or where it is, and the code to pair with.
void draw_page(Panel& c, std::string& page_address) {
  row_label(c, tr("Phone page"),
            tr("A page that shows this step, for a phone or tablet on the local network. It can only show and change "
               "the step. The connection is not encrypted; use it only on a network you trust"));
  if (c.view.page.open) return draw_served_page(c);
  const auto chosen = std::ranges::find(c.view.own_addresses, page_address, &platform::OwnAddress::address);
  ImGui::SetNextItemWidth(c.style.px(290));
  if (begin_combo(c, "loom.page_address",
                  chosen == c.view.own_addresses.end() ? page_address.c_str() : address_text(*chosen).c_str())) {
    for (const platform::OwnAddress& one : c.view.own_addresses) {
      if (ImGui::Selectable(address_text(one).c_str(), one.address == page_address)) page_address = one.address;
      c.map.add_item("loom.page_address:" + one.address);
    }
    end_combo();
  }
  ImGui::SameLine();
  if (text_button(c, "loom.page", tr("Start page"), tr("Start the page at this address and show a pairing code")))
    c.wanted.add_action("loom_page");
}

/// First and last pick of the range that is woven over and over, counted from 1.
void draw_range(Panel& c) {
  const int picks = c.design.draft.picks();
  const loom::PickRange now = c.view.at_loom.section;
  int first = now.first < now.end ? now.first + 1 : 1, last = now.first < now.end ? now.end : picks;
  row_label(c, tr("Picks"), tr("Picks to weave repeatedly"));
  push_font(c.style.font.mono);
  ImGui::SetNextItemWidth(c.style.px(110));
  bool changed = ImGui::InputInt("##first", &first);
  c.map.add_item("loom.first");
  ImGui::SameLine();
  ImGui::TextUnformatted("\xE2\x80\x93");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(c.style.px(110));
  changed |= ImGui::InputInt("##last", &last);
  c.map.add_item("loom.last");
  ImGui::PopFont();
  if (changed)
    c.wanted.gesture([first, last, picks](DocumentView& v, const Design& d) {
      const int from = std::clamp(first, 1, picks) - 1, to = std::clamp(last, from + 1, picks);
      return keep_to_section(v.at_loom, d, from == 0 && to == picks ? loom::PickRange{} : loom::PickRange{from, to})
          .edit;
    });
  ImGui::SameLine();
  if (text_button(c, "loom.whole", tr("Whole draft"), nullptr))
    c.wanted.gesture([](DocumentView& v, const Design& d) { return keep_to_section(v.at_loom, d, {}).edit; });
  ImGui::SameLine(0, c.style.px(20));
  bool between = c.design.loom.tabby_between;
  if (ImGui::Checkbox(tr("Tabby between pattern picks"), &between))
    c.wanted.gesture(
        [between](DocumentView& v, const Design& d) { return put_tabby_between(v.at_loom, d, between).edit; });
  c.map.add_item("loom.tabby_between");
  ImGui::SameLine(0, c.style.px(20));
  if (ImGui::CalcTextSize(c.view.step.progress.c_str()).x > ImGui::GetContentRegionAvail().x) {
    ImGui::NewLine();
    row_label(c, "", "");
  }
  muted_text(c, c.view.step.progress);
  c.map.add_item("loom.progress");
}

/// The end or dent to go on from, counted from 1.
void draw_place(Panel& c) {
  const bool ends = c.view.step.work == LoomWork::kThread;
  row_label(c, ends ? tr("Next end") : tr("Next dent"), tr("Continue from here"));
  push_font(c.style.font.mono);
  ImGui::SetNextItemWidth(c.style.px(130));
  int number = c.view.step.number;
  const bool changed = ImGui::InputInt("##place", &number);
  c.map.add_item("loom.place");
  ImGui::PopFont();
  if (changed)
    c.wanted.gesture(
        [number](DocumentView& v, const Design& d) { return go_to(v.at_loom, d, std::max(number, 1) - 1).edit; });
  ImGui::SameLine(0, c.style.px(20));
  ImGui::AlignTextToFramePadding();
  muted_text(c, c.view.step.progress);
  if (ends || c.design.plan.reed.dents > 0) return;
  ImGui::SameLine(0, c.style.px(20));
  muted_text(c, tr("No reed is chosen under Plan: one end per dent, or the sleying set there"));
}

const char* next_label(LoomWork work) {
  if (work == LoomWork::kThread) return tr("Next end");
  return work == LoomWork::kSley ? tr("Next dent") : tr("Next pick");
}

const char* first_label(LoomWork work) {
  if (work == LoomWork::kThread) return tr("First end");
  return work == LoomWork::kSley ? tr("First dent") : tr("First pick");
}

/// Beside the last item, or below it where `width` has no room.
void next_in_row(float width, float gap = -1) {
  ImGui::SameLine(0, gap);
  if (width > ImGui::GetContentRegionAvail().x) ImGui::NewLine();
}

bool step_button(const Panel& c, const char* id, const char* label, const char* tip, float gap = -1) {
  next_in_row(ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x, gap);
  return text_button(c, id, label, tip);
}

void draw_steps(Panel& c) {
  const char* const kWorks[] = {mark("Thread"), mark("Sley"), tr_in("at the loom", "Weave")};
  const LoomWork work = c.view.at_loom.work;
  const float pad = std::max(c.style.px(10), ImGui::GetStyle().FramePadding.y);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(18), pad});
  int chosen = static_cast<int>(work);
  if (segmented(c, "loom.work", kWorks, chosen, c.style.px(230)))
    c.wanted.change_view([chosen](DocumentView& v) {
      v.at_loom.work = static_cast<LoomWork>(chosen);
      v.at_loom.remark.clear();
    });
  if (step_button(c, "loom.back", tr_in("a step", "Back"), tr("Previous step   Backspace"), c.style.px(16)))
    c.wanted.add_action("loom_back");
  ImGui::PushStyleColor(ImGuiCol_Button, c.style.color.accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, blend(c.style.color.accent, c.style.color.text, 0.15f));
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.paper);
  if (step_button(c, "loom.next", next_label(work), tr("Next step   Space"))) c.wanted.add_action("loom_next");
  ImGui::PopStyleColor(3);
  if (work == LoomWork::kWeave && step_button(c, "loom.tabby", tr("Tabby"),
                                              tr("A tabby pick before this one, alternating the two tabby sheds   T")))
    c.wanted.add_action("loom_tabby");
  if (c.view.can_speak && step_button(c, "loom.say", tr("Read aloud"), tr("Read this step aloud   S")))
    c.wanted.add_action("loom_say");
  if (step_button(c, "loom.first_pick", first_label(work), tr("Start again from the first")))
    c.wanted.gesture([](DocumentView& v, const Design& d) { return go_to(v.at_loom, d, 0).edit; });
  if (step_button(c, "loom.done", tr("Leave loom view"), tr("Back to the draft, which keeps your place   F9")))
    c.wanted.add_action("loom");
  ImGui::PopStyleVar();
  if (!c.view.can_speak) return;
  const char* label = tr("Read each step aloud");
  next_in_row(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label).x,
              c.style.px(16));
  bool each = c.settings.say_steps;
  if (ImGui::Checkbox(label, &each)) c.wanted.change_settings([each](Settings& s) { s.say_steps = each; });
  c.map.add_item("loom.say_steps");
}

}  // namespace

void draw_loom(const PanelContext& panel, const LoomView& view, std::string& address, std::string& page_address) {
  Panel c{panel, view};
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  // In a narrow window the rows of the foot wrap: it is as high as it was in the last frame.
  float& used = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("foot"));
  const float margin = c.style.px(kMargin), foot = std::max(c.style.px(kFoot), used);
  PixelRect room{{at.x + margin, at.y + margin}, {at.x + size.x - margin, at.y + size.y - foot - margin}};
  if (view.step.of > 0 && room.height() > 40) {
    const float right = room.max.x;
    const bool strip = size.x >= c.style.px(kMinForStrip);
    if (strip) room.max.x = at.x + size.x * (view.step.work == LoomWork::kWeave ? 0.56f : 0.45f);
    draw_step(c, view.step, room);
    if (strip)
      draw_surroundings(c, view.step, {{room.max.x + margin, room.min.y}, {right - c.style.px(48), room.max.y}});
  }
  ImGui::SetCursorScreenPos({at.x + margin, at.y + std::max(0.0f, size.y - foot - c.style.px(8))});
  ImGui::BeginGroup();
  draw_steps(c);
  ImGui::Dummy({0, c.style.px(2)});
  if (view.step.work == LoomWork::kWeave) draw_range(c);
  else draw_place(c);
  draw_line(c, address);
  draw_page(c, page_address);
  draw_status(c);
  ImGui::EndGroup();
  used = ImGui::GetItemRectSize().y;
}

}  // namespace weftlight::views
