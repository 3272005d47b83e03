#include "design/thread_text.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.h"
#include "base/words.h"
#include "design/edits.h"
#include "draft/hex_color.h"

namespace weftlight::design {

using base::next_word;
using draft::Threads, draft::hex_of, draft::kFromYarn, draft::kMaxThreads, draft::packed_rgb, draft::rgb_from_hex;

namespace {

constexpr std::string_view kColors = "weftlight colours:", kThickness = "weftlight thickness:";
constexpr std::string_view kSpace = " \t\r\n";

template <class Use>
void each_thread(const Threads& t, std::span<const int> threads, Use use) {
  for (const int thread : threads)
    if (thread >= 0 && thread < t.size()) use(static_cast<size_t>(thread));
}

std::optional<float> thickness_of(std::string_view word) {
  if (word == "-") return kFromYarn;
  float mm = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, mm);
  constexpr float kThickest = 1000;
  if (error != std::errc() || stop != end || !(mm > 0 && mm <= kThickest)) return {};
  return mm;
}

/// Index of the colour in the palette; adds it if it is missing.
int index_of(Design& design, Rgb color) {
  const auto& palette = design.draft.palette;
  for (size_t i = 0; i < palette.size(); ++i)
    if (packed_rgb(palette[i]) == packed_rgb(color)) return static_cast<int>(i);
  design = with_new_palette_color(std::move(design), color);
  return static_cast<int>(design.draft.palette.size()) - 1;
}

template <class Value, class Read>
bool read_values(std::string_view text, std::vector<Value>& values, Read read) {
  while (values.size() < static_cast<size_t>(kMaxThreads)) {
    const std::string_view word = next_word(text);
    if (word.empty()) break;
    const auto value = read(word);
    if (!value) return false;
    values.push_back(*value);
  }
  return !values.empty();
}

}  // namespace

std::string color_text(const Draft& draft, System system, std::span<const int> threads) {
  const Threads& t = draft.threads(system);
  std::string text(kColors);
  each_thread(t, threads,
              [&](size_t i) { text.append(" ").append(hex_of(draft.palette[static_cast<size_t>(t.color[i])])); });
  return text + "\n";
}

std::string thickness_text(const Draft& draft, System system, std::span<const int> threads) {
  const Threads& t = draft.threads(system);
  std::string text(kThickness);
  each_thread(t, threads, [&](size_t i) {
    char word[32];
    const float mm = t.thickness_mm[i];
    if (mm > 0) text.append(" ").append(word, std::to_chars(word, word + sizeof word, mm).ptr);
    else text += " -";
  });
  return text + "\n";
}

base::Result<ThreadProperties> read_thread_properties(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  ThreadProperties properties;
  bool whole = false;
  if (text.starts_with(kColors)) whole = read_values(text.substr(kColors.size()), properties.colors, rgb_from_hex);
  else if (text.starts_with(kThickness))
    whole = read_values(text.substr(kThickness.size()), properties.thickness_mm, thickness_of);
  if (!whole)
    return base::failure(
        base::ErrorKind::kInput,
        base::tr("The clipboard holds no colours or thicknesses of threads; select threads and copy theirs first"));
  return properties;
}

Design with_properties(Design design, System system, std::span<const int> threads, const ThreadProperties& properties) {
  std::vector<int> colors;
  for (const Rgb& color : properties.colors) colors.push_back(index_of(design, color));
  for (size_t i = 0; i < threads.size(); ++i) {
    if (!colors.empty()) design = with_thread_color(std::move(design), system, threads[i], colors[i % colors.size()]);
    if (!properties.thickness_mm.empty())
      design = with_thread_thickness(std::move(design), system, threads[i],
                                     properties.thickness_mm[i % properties.thickness_mm.size()]);
  }
  return design;
}

}  // namespace weftlight::design
