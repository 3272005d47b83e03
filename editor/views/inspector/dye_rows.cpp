#include "views/inspector/dye_rows.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/text.h"
#include "draft/hex_color.h"
#include "ui/icons.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::arg, base::fill, base::tr;
using design::Dye, design::DyedStretch, design::dye_colors, design::kMaxDyedStretches, design::kMaxDyedThreads,
    design::length_of;
using draft::Draft, draft::Rgb, draft::Threads;
using ui::buttons_row, ui::icon_button, ui::muted_text, ui::number_field, ui::row_label, ui::section, ui::slider,
    ui::text_button, ui::tooltip;

namespace {

constexpr float kBarHeight = 18;  // pixels at 96 dpi

/// The sequence from its first thread to its last.
void draw_sequence(const PanelContext& c, const Dye& dye, Rgb own) {
  const std::vector<Rgb> colors = dye_colors(dye, own);
  const ImVec2 a = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, c.style.px(kBarHeight)};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const int columns = std::max(1, static_cast<int>(size.x));
  const auto at = [&](int column) {
    return to_u32(colors[static_cast<size_t>(column) * colors.size() / static_cast<size_t>(columns)]);
  };
  for (int x = 0; x < columns;) {
    int stop = x + 1;
    while (stop < columns && at(stop) == at(x)) ++stop;
    dl->AddRectFilled({a.x + static_cast<float>(x), a.y}, {a.x + static_cast<float>(stop), a.y + size.y}, at(x));
    x = stop;
  }
  dl->AddRect(a, {a.x + size.x, a.y + size.y}, c.style.color.line_strong);
  ImGui::Dummy(size);
  c.map.add_item("dye.sequence");
  tooltip(c, tr("The colours along a thread, from pick 1 or end 1 on; then they repeat"));
}

/// What a row asks for.
enum class RowChange { kNone, kStretch, kRemove };

RowChange draw_stretch(const PanelContext& c, const std::string& id, int number, DyedStretch& stretch, Rgb own) {
  row_label(c, fill(tr("Stretch {number}"), arg("number", number)).c_str(),
            tr("Its colour, the number of threads that it crosses, whether it has the thread's own colour, and whether "
               "it fades into the next"));
  RowChange change = RowChange::kNone;
  const Rgb shown = stretch.color.value_or(own);
  float rgb[3] = {shown.r, shown.g, shown.b};
  constexpr auto kFlags = ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoTooltip |
                          ImGuiColorEditFlags_PickerHueWheel;
  if (ImGui::ColorEdit3("##color", rgb, kFlags))
    stretch.color = draft::of_8_bits({rgb[0], rgb[1], rgb[2]}), change = RowChange::kStretch;
  c.map.add_item(id + ".color");
  tooltip(c, tr("Colour of this stretch"));
  ImGui::SameLine();
  float threads = static_cast<float>(stretch.threads);
  const std::string threads_id = id + ".threads";
  const float buttons = 3 * (ImGui::GetFrameHeight() + c.style.px(4) + ImGui::GetStyle().ItemSpacing.x);
  const float width = std::max(c.style.px(28), ImGui::GetContentRegionAvail().x - buttons);
  if (number_field(c,
                   {threads_id.c_str(), "", 1, static_cast<float>(kMaxDyedThreads), "%.0f",
                    tr("Threads that this stretch crosses: picks along an end, ends along a pick")},
                   false, width, threads) &&
      std::lround(threads) != stretch.threads)
    stretch.threads = static_cast<int>(std::lround(threads)), change = RowChange::kStretch;
  ImGui::SameLine();
  if (icon_button(c, (id + ".own").c_str(), stretch.color ? icon::kUnlinked : icon::kLinked, "=",
                  stretch.color ? tr("In a colour of this stretch; click for the thread's own")
                                : tr("In the thread's own colour; click for a colour of this stretch")))
    stretch.color = stretch.color ? std::optional<Rgb>() : draft::of_8_bits(own), change = RowChange::kStretch;
  ImGui::SameLine();
  if (icon_button(c, (id + ".fades").c_str(), stretch.fades ? icon::kRight : icon::kMinus, stretch.fades ? ">" : "|",
                  stretch.fades ? tr("Fades into the next stretch; click for a sharp edge")
                                : tr("Ends at a sharp edge; click to let it fade into the next stretch")))
    stretch.fades = !stretch.fades, change = RowChange::kStretch;
  ImGui::SameLine();
  if (icon_button(c, (id + ".remove").c_str(), icon::kClear, "x", tr("Remove this stretch")))
    change = RowChange::kRemove;
  return change;
}

bool draw_stretches(const PanelContext& c, Dye& dye, Rgb own) {
  for (size_t i = 0; i < dye.stretches.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const std::string id = "dye:" + std::to_string(i + 1);
    const RowChange change = draw_stretch(c, id, static_cast<int>(i) + 1, dye.stretches[i], own);
    ImGui::PopID();
    if (change == RowChange::kRemove) dye.stretches.erase(dye.stretches.begin() + static_cast<std::ptrdiff_t>(i));
    if (dye.stretches.empty()) dye = {};
    if (change != RowChange::kNone) return true;
  }
  return false;
}

/// The first two stretches show at once what they do.
void add_stretch(Dye& dye, Rgb color) {
  constexpr int kThreads = 12;
  if (dye.stretches.empty()) dye.stretches.push_back({kThreads, {}, false});
  dye.stretches.push_back({kThreads, draft::of_8_bits(color), false});
}

bool draw_whole(const PanelContext& c, const char* id, const char* label, const char* tip, int least, int& value) {
  float number = static_cast<float>(value);
  constexpr float kTrack = 40;
  if (!slider(c,
              {id, label, least < 0 ? -kTrack : 0, kTrack, "%.0f", tip, false, static_cast<float>(least),
               static_cast<float>(kMaxDyedThreads)},
              number) ||
      std::lround(number) == value)
    return false;
  value = static_cast<int>(std::lround(number));
  return true;
}

/// Where the sequence does not fit the draft, its repeats meet at a seam.
void say_seam(const PanelContext& c, const Dye& dye) {
  const Draft& d = c.design.draft;
  const auto& yarns = c.design.yarns;
  const auto used = [&](const Threads& threads) {
    return std::ranges::any_of(threads.yarn, [&](int y) { return yarns[static_cast<size_t>(y)].dye == dye; });
  };
  const int length = length_of(dye);
  std::string words;
  if (used(d.warp) && d.picks() % length != 0)
    words = fill(tr("{length} threads long; the draft has {picks} picks, so its repeats meet at a seam"),
                 arg("length", length), arg("picks", d.picks()));
  else if (used(d.weft) && d.ends() % length != 0)
    words = fill(tr("{length} threads long; the draft has {ends} ends, so its repeats meet at a seam"),
                 arg("length", length), arg("ends", d.ends()));
  if (words.empty()) return;
  ImGui::PushTextWrapPos(0);
  muted_text(c, words);
  ImGui::PopTextWrapPos();
}

}  // namespace

bool draw_dye(const PanelContext& c, Yarn& yarn, Rgb own, Rgb next) {
  if (!section(c, "section.dye", tr("Dyed along the thread"), false)) return false;
  Dye& dye = yarn.dye;
  bool changed = false;
  if (!dye.stretches.empty()) {
    draw_sequence(c, dye, own);
    changed = draw_stretches(c, dye, own);
  }
  const char* const add[] = {tr("Add a stretch")};
  buttons_row(c, add);
  if (dye.stretches.size() < kMaxDyedStretches &&
      text_button(c, "dye.add", add[0],
                  tr("Another colour along the threads of this yarn: a painted warp, ikat, or space-dyed yarn")))
    add_stretch(dye, next), changed = true;
  if (dye.stretches.empty()) return changed;
  if (draw_whole(
          c, "dye.shift", tr("Shift"),
          tr("Each thread's colours start so many threads earlier than those of the thread before: slanting lines"),
          -kMaxDyedThreads, dye.shift))
    changed = true;
  if (draw_whole(c, "dye.scatter", tr("Scatter"),
                 tr("Moves the colours of each thread to either side by at most so many threads, at random: the "
                    "feathered edges of ikat; the length of the sequence makes a space-dyed yarn"),
                 0, dye.scatter))
    changed = true;
  say_seam(c, dye);
  return changed;
}

}  // namespace weftlight::views
