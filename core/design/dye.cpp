#include "design/dye.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "base/words.h"
#include "design/oklab.h"
#include "draft/hex_color.h"

namespace weftlight::design {

using base::next_word, base::same_word;
using draft::hex_of, draft::of_8_bits, draft::rgb_from_hex;

namespace {

Rgb mixed(Rgb from, Rgb to, float t) {
  const Oklab a = oklab_of(from), b = oklab_of(to);
  const auto mix = [t](float x, float y) { return x + (y - x) * t; };
  return rgb_of({mix(a.lightness, b.lightness), mix(a.a, b.a), mix(a.b, b.b)});
}

Rgb color_of(const DyedStretch& stretch, Rgb own) { return stretch.color.value_or(own); }

/// -most..most, each as probable; the finaliser of MurmurHash3 (Appleby 2011).
int scattered(System system, int thread, int most) {
  uint64_t h = static_cast<uint64_t>(thread) * 2 + (system == System::kWarp ? 1 : 2);
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdu;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53u;
  h ^= h >> 33;
  return static_cast<int>(h % (2 * static_cast<uint64_t>(most) + 1)) - most;
}

/// "12 #1F3B73 fades".
std::optional<DyedStretch> stretch_from(std::string_view text) {
  DyedStretch out;
  const std::string_view count = next_word(text), color = next_word(text), fades = next_word(text);
  const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), out.threads);
  if (error != std::errc() || stop != count.data() + count.size()) return {};
  if (out.threads < 1 || out.threads > kMaxDyedThreads || !next_word(text).empty()) return {};
  out.color = rgb_from_hex(color);
  if (!out.color && !same_word(color, "own")) return {};
  out.fades = same_word(fades, "fades");
  if (!out.fades && !fades.empty()) return {};
  return out;
}

}  // namespace

int length_of(const Dye& dye) {
  int length = 0;
  for (const DyedStretch& s : dye.stretches) length += s.threads;
  return length;
}

std::vector<Rgb> dye_colors(const Dye& dye, Rgb own) {
  std::vector<Rgb> out;
  out.reserve(static_cast<size_t>(length_of(dye)));
  for (size_t i = 0; i < dye.stretches.size(); ++i) {
    const DyedStretch &here = dye.stretches[i], &next = dye.stretches[(i + 1) % dye.stretches.size()];
    const Rgb from = color_of(here, own), to = color_of(next, own);
    for (int k = 0; k < here.threads; ++k)
      out.push_back(here.fades ? mixed(from, to, (static_cast<float>(k) + 0.5f) / static_cast<float>(here.threads))
                               : from);
  }
  return out;
}

int dye_phase(const Dye& dye, System system, int thread) {
  const int64_t length = length_of(dye);
  if (length == 0) return 0;
  const int64_t at = int64_t{dye.shift} * thread + (dye.scatter > 0 ? scattered(system, thread, dye.scatter) : 0);
  return static_cast<int>(((at % length) + length) % length);
}

Dye clamped(Dye dye) {
  if (dye.stretches.size() > kMaxDyedStretches) dye.stretches.resize(kMaxDyedStretches);
  for (DyedStretch& s : dye.stretches) {
    s.threads = std::clamp(s.threads, 1, kMaxDyedThreads);
    if (s.color) s.color = of_8_bits(*s.color);
  }
  dye.shift = std::clamp(dye.shift, -kMaxDyedThreads, kMaxDyedThreads);
  dye.scatter = std::clamp(dye.scatter, 0, kMaxDyedThreads);
  return dye;
}

std::string dye_text(const std::vector<DyedStretch>& stretches) {
  std::string out;
  for (const DyedStretch& s : stretches) {
    if (!out.empty()) out += ", ";
    out.append(std::to_string(s.threads)).append(" ").append(s.color ? hex_of(*s.color) : "own");
    if (s.fades) out += " fades";
  }
  return out;
}

std::optional<std::vector<DyedStretch>> dye_from_text(std::string_view text) {
  std::vector<DyedStretch> out;
  while (!text.empty()) {
    const size_t comma = std::min(text.find(','), text.size());
    const std::optional<DyedStretch> stretch = stretch_from(text.substr(0, comma));
    if (!stretch || out.size() == kMaxDyedStretches) return {};
    out.push_back(*stretch);
    if (comma + 1 == text.size()) return {};  // nothing after a comma
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return out;
}

DyedThreads::DyedThreads(const Design& design) {
  const auto is_dyed = [](const Yarn& yarn) { return !yarn.dye.stretches.empty(); };
  if (std::ranges::none_of(design.yarns, is_dyed)) return;
  std::map<std::pair<int, int>, int> made;  // by yarn and palette entry
  for (const System system : {System::kWarp, System::kWeft}) {
    const Threads& threads = design.draft.threads(system);
    std::vector<Place>& places = threads_[system == System::kWarp ? 0 : 1];
    for (int i = 0; i < threads.size(); ++i) {
      const size_t at = static_cast<size_t>(i);
      const Dye& dye = design.yarns[static_cast<size_t>(threads.yarn[at])].dye;
      Place& place = places.emplace_back();
      if (dye.stretches.empty()) continue;
      const auto [table, is_new] =
          made.try_emplace({threads.yarn[at], threads.color[at]}, static_cast<int>(tables_.size()));
      if (is_new) tables_.push_back(dye_colors(dye, design.draft.palette[static_cast<size_t>(threads.color[at])]));
      place = {table->second, dye_phase(dye, system, i)};
      std::vector<int>& lengths = lengths_[system == System::kWarp ? 0 : 1];
      const int length = length_of(dye);
      if (std::ranges::find(lengths, length) == lengths.end()) lengths.push_back(length);
    }
  }
  if (tables_.empty()) *this = {};
}

bool DyedThreads::repeat_after(System system, int crossings) const {
  return std::ranges::all_of(lengths_[system == System::kWarp ? 0 : 1],
                             [crossings](int length) { return crossings % length == 0; });
}

const Rgb* DyedThreads::color(System system, int thread, int crossing) const {
  if (empty()) return nullptr;
  const Place& place = at(system, thread);
  if (place.table < 0) return nullptr;
  const std::vector<Rgb>& colors = tables_[static_cast<size_t>(place.table)];
  return &colors[static_cast<size_t>(crossing + place.phase) % colors.size()];
}

const Rgb& color_at(const Draft& draft, const DyedThreads& dyed, System system, int thread, int crossing) {
  if (const Rgb* const color = dyed.color(system, thread, crossing)) return *color;
  return draft.palette[static_cast<size_t>(draft.threads(system).color[static_cast<size_t>(thread)])];
}

const Rgb& color_on_top(const Draft& draft, const DyedThreads& dyed, bool warp_up, int end, int pick) {
  return warp_up ? color_at(draft, dyed, System::kWarp, end, pick) : color_at(draft, dyed, System::kWeft, pick, end);
}

}  // namespace weftlight::design
