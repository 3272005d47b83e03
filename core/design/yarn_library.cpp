#include "design/yarn_library.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.h"
#include "base/utf8.h"
#include "base/words.h"
#include "design/count.h"
#include "design/dye.h"
#include "design/edits.h"
#include "design/fibre.h"
#include "design/written_count.h"
#include "design/yarn_fields.h"
#include "design/yarn_presets.h"
#include "draft/hex_color.h"

namespace weftlight::design {

using base::arg, base::cut_utf8, base::failure, base::fill, base::is_utf8, base::same_word, base::tr;
using draft::Threads, draft::hex_of, draft::of_8_bits, draft::packed_rgb, draft::rgb_from_hex;

namespace {

constexpr std::string_view kHead = "# Yarns of Weftlight. Each begins with [Yarn]; only its name has to be there.";
constexpr std::string_view kYarn = "[Yarn]", kBlanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// A text of the user in one line.
std::string one_line(std::string_view text) {
  std::string out(cut_utf8(text, kMaxLibraryLine / 2));
  for (char& c : out)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return std::string(trimmed(out));
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lowered(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), lower);
  return out;
}

/// Whether the text is a count of that weight, to within the rounding of labels.
bool says(std::string_view count, const Yarn& yarn) {
  constexpr double kLabel = 3e-3;  // 16.7 tex is 150 den
  const std::optional<double> tex = tex_from_text(count);
  return tex && std::abs(static_cast<double>(yarn.tex) / *tex - 1) <= kLabel;
}

/// A number with a decimal point or comma.
std::optional<float> number_in(std::string_view text) {
  std::string digits(text);
  if (std::ranges::count(digits, ',') == 1 && digits.find('.') == std::string::npos)
    std::ranges::replace(digits, ',', '.');
  float value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (digits.empty() || error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string number_text(float value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

std::optional<YarnColor> color_in(std::string_view text) {
  if (text.size() > 7 && kBlanks.find(text[7]) == std::string_view::npos) return std::nullopt;
  const std::optional<Rgb> rgb = rgb_from_hex(text.substr(0, 7));
  if (!rgb) return std::nullopt;
  return YarnColor{*rgb, one_line(text.substr(std::min<size_t>(text.size(), 7)))};
}

/// In the list, "Fibre" is what the yarn is made of.
std::string key_of(const FieldFacts& facts) {
  return std::string_view(facts.key) == "Fibre" ? "Fibre Bundles" : facts.key;
}

struct YarnLine {
  int number = 0;
  std::string_view text, key, value;  // key and value trimmed; without =, both are empty
};

YarnLine line_of(int number, std::string_view text) {
  YarnLine line{number, text, {}, {}};
  const size_t equals = text.find('=');
  if (equals == std::string_view::npos || text.front() == '#' || text.front() == ';') return line;
  line.key = trimmed(text.substr(0, equals));
  line.value = trimmed(text.substr(equals + 1));
  return line;
}

/// Reads the lines of one yarn. What they say of the fibre counts first, then the count, then all numbers.
class YarnReader {
 public:
  YarnReader(const std::vector<YarnLine>& lines, std::vector<LibraryRemark>& remarks)
      : lines_(lines), remarks_(remarks) {}

  LibraryYarn read() {
    begin_with_fibre();
    out_.yarn.name.clear();
    for (const YarnLine& line : lines_)
      if (same_word(line.key, "Count")) take_count(line);
    for (const YarnLine& line : lines_) take(line);
    if (out_.yarn.name.empty()) out_.yarn.name = tr("Yarn");
    out_.yarn = clamped(std::move(out_.yarn));
    if (!has_section_) out_.yarn = with_recognised_section(std::move(out_.yarn));
    if (!says(out_.count, out_.yarn)) out_.count.clear();
    return std::move(out_);
  }

 private:
  void remark(const YarnLine& line, std::string text) {
    remarks_.push_back({line.number, std::move(text)});
    out_.other_lines.emplace_back(line.text);
  }

  void begin_with_fibre() {
    const auto presets = ready_yarns();
    out_.yarn = presets[0];
    for (const YarnLine& line : lines_) {
      if (!same_word(line.key, "Fibre")) continue;
      const auto found = std::ranges::find_if(presets, [&](const Yarn& p) {
        return std::ranges::any_of(std::array{p.name.c_str(), fibre_name(p.fibre)}, [&](const char* name) {
          return same_word(name, line.value) || same_word(tr(name), line.value);
        });
      });
      if (found != presets.end()) out_.yarn = *found;
      else
        remark(line, fill(tr("unknown fibre {fibre}; cotton is used. Describe it in a Note= line"),
                          arg("fibre", std::string(line.value))));
    }
  }

  void take_count(const YarnLine& line) {
    if (const std::optional<Yarn> spun = with_count(out_.yarn, line.value)) {
      out_.yarn = *spun;
      out_.count = one_line(line.value);
    } else
      remark(line, fill(tr("the count {count} is not understood; write it as Ne 8/2, Nm 30/2, 16 lea, 150 den, 30 tex"),
                        arg("count", std::string(line.value))));
  }

  void take(const YarnLine& line) {
    if (line.key.empty()) return out_.other_lines.emplace_back(line.text), void();
    if (same_word(line.key, "Count") || same_word(line.key, "Fibre")) return;
    if (same_word(line.key, "Name")) out_.yarn.name = one_line(cut_utf8(line.value, kMaxLibraryLine / 4));
    else if (same_word(line.key, "Note")) out_.note = one_line(line.value);
    else if (same_word(line.key, "Colour") || same_word(line.key, "Color")) take_color(line);
    else if (same_word(line.key, "Cross-section")) take_section(line);
    else if (same_word(line.key, "Twist")) take_twist(line);
    else if (same_word(line.key, "Metallic")) out_.yarn.lobes.metallic = same_word(line.value, "true");
    else if (same_word(line.key, "Tint")) take_tint(line);
    else if (same_word(line.key, "Dye")) take_dye(line);
    else if (same_word(line.key, "Dye Shift")) take_threads(line, -kMaxDyedThreads, out_.yarn.dye.shift);
    else if (same_word(line.key, "Dye Scatter")) take_threads(line, 0, out_.yarn.dye.scatter);
    else take_number(line);
  }

  void take_color(const YarnLine& line) {
    const std::optional<YarnColor> color = color_in(line.value);
    if (!color) return remark(line, tr("a colour is written as #1E3A5F Navy"));
    if (out_.colors.size() < kMaxYarnColors) out_.colors.push_back(*color);
    else remark(line, tr("a yarn can have at most 1,000 colours"));
  }

  void take_section(const YarnLine& line) {
    const std::optional<CrossSection> section = section_from_name(line.value);
    if (!section) return remark(line, tr("a cross-section is Round, Trilobal, Bean or Flat film"));
    out_.yarn.section = *section;
    has_section_ = true;
  }

  void take_twist(const YarnLine& line) {
    for (size_t i = 0; i < kTwistNames.size(); ++i)
      if (same_word(kTwistNames[i], line.value)) return out_.yarn.twist = static_cast<Twist>(i), void();
    remark(line, tr("a twist is S, Z or none"));
  }

  void take_tint(const YarnLine& line) {
    if (const auto color = color_in(line.value)) out_.yarn.lobes.specular_tint = color->rgb;
    else remark(line, tr("a colour is written as #1E3A5F Navy"));
  }

  void take_dye(const YarnLine& line) {
    if (auto stretches = dye_from_text(line.value)) out_.yarn.dye.stretches = std::move(*stretches);
    else remark(line, tr("a dye is written as 12 #1F3B73, 6 #1F3B73 fades, 20 own"));
  }

  void take_threads(const YarnLine& line, int least, int& out) {
    const std::optional<float> value = number_in(line.value);
    if (value)
      out = static_cast<int>(std::clamp(*value, static_cast<float>(least), static_cast<float>(kMaxDyedThreads)));
    else remark(line, tr("a number of threads was expected"));
  }

  void take_number(const YarnLine& line) {
    float* const number = number_of(line.key);
    const bool plies = same_word(line.key, kPliesFacts.key);
    if (number == nullptr && !plies) return remark(line, tr("this line is not understood by this version; it is kept"));
    const std::optional<float> value = number_in(line.value);
    if (!value || *value < 0) return remark(line, tr("a number of 0 or more was expected"));
    if (plies) out_.yarn.plies = static_cast<int>(std::min(*value, 1000.0f));
    else *number = std::min(*value, kMaxNumber);
  }

  /// Where the number of that key belongs.
  float* number_of(std::string_view key) {
    if (same_word(key, "Price")) return &out_.price;
    if (same_word(key, "Cone Weight")) return &out_.cone_g;
    if (same_word(key, "Cone Length")) return &out_.cone_m;
    for (const YarnField<Yarn>& field : kYarnFields)
      if (same_word(key, key_of(field.facts))) return &(out_.yarn.*field.member);
    for (const YarnField<Lobes>& field : kLobeFields)
      if (same_word(key, field.facts.key)) return &(out_.yarn.lobes.*field.member);
    return nullptr;
  }

  static constexpr float kMaxNumber = 1e6f;
  const std::vector<YarnLine>& lines_;
  std::vector<LibraryRemark>& remarks_;
  LibraryYarn out_;
  bool has_section_ = false;
};

void add(std::string& out, std::string_view key, std::string_view value) {
  out.append(key).append("=").append(value).append("\n");
}

void add_if(std::string& out, std::string_view key, float value) {
  if (value > 0) add(out, key, number_text(value));
}

std::string yarn_text(const LibraryYarn& one) {
  const Yarn& yarn = one.yarn;
  std::string out(kYarn);
  out += "\n";
  add(out, "Name", one_line(yarn.name));
  if (!one.note.empty()) add(out, "Note", one_line(one.note));
  if (!one.count.empty()) add(out, "Count", one_line(one.count));
  add(out, "Fibre", ready_yarn(yarn.fibre).name);
  add(out, "Cross-section", kCrossSectionNames[static_cast<size_t>(yarn.section)]);
  add_if(out, "Price", one.price);
  add_if(out, "Cone Weight", one.cone_g);
  add_if(out, "Cone Length", one.cone_m);
  for (const YarnColor& color : one.colors)
    add(out, "Colour", trimmed(hex_of(color.rgb).append(" ").append(one_line(color.name))));
  add(out, "Twist", kTwistNames[static_cast<size_t>(yarn.twist)]);
  // What the count says stands there alone, so that it can be changed by hand.
  const Yarn spun = with_count(yarn, one.count).value_or(Yarn{});
  if (one.count.empty() || spun.plies != yarn.plies || read_count(one.count)->plies == 0)
    add(out, kPliesFacts.key, std::to_string(yarn.plies));
  for (const YarnField<Yarn>& field : kYarnFields)
    if (field.member != &Yarn::tex || one.count.empty() || spun.tex != yarn.tex)
      add(out, key_of(field.facts), number_text(yarn.*field.member));
  for (const YarnField<Lobes>& field : kLobeFields) add(out, field.facts.key, number_text(yarn.lobes.*field.member));
  if (packed_rgb(yarn.lobes.specular_tint) != packed_rgb({1, 1, 1})) add(out, "Tint", hex_of(yarn.lobes.specular_tint));
  if (yarn.lobes.metallic) add(out, "Metallic", "true");
  if (!yarn.dye.stretches.empty()) add(out, "Dye", dye_text(yarn.dye.stretches));
  if (yarn.dye.shift != 0) add(out, "Dye Shift", std::to_string(yarn.dye.shift));
  if (yarn.dye.scatter != 0) add(out, "Dye Scatter", std::to_string(yarn.dye.scatter));
  for (const std::string& line : one.other_lines) out.append(line).append("\n");
  return out;
}

template <class Colors>
void add_color(Colors& colors, const YarnColor& color) {
  const auto same = [&](const YarnColor& c) { return packed_rgb(c.rgb) == packed_rgb(color.rgb); };
  if (colors.size() < kMaxYarnColors && std::ranges::none_of(colors, same)) colors.push_back(color);
}

}  // namespace

base::Result<YarnLibrary> read_yarn_library(std::string_view text) {
  while (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (!is_utf8(text))
    return failure(base::ErrorKind::kInput, tr("is not in UTF-8; save it as UTF-8 text in the program that wrote it"));
  YarnLibrary out;
  std::vector<YarnLine> lines;
  bool in_yarn = false, any = false;
  const auto finish = [&] {
    if (in_yarn) out.yarns.push_back(YarnReader(lines, out.remarks).read());
    lines.clear();
  };
  int number = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = trimmed(text.substr(at, end - at));
    at = end + 1;
    ++number;
    if (line.empty()) continue;
    any = true;
    if (line.size() > kMaxLibraryLine) {
      out.remarks.push_back({number, tr("the line is too long, and was left out")});
    } else if (!same_word(line, kYarn)) {
      if (in_yarn) lines.push_back(line_of(number, line));
      else out.head.emplace_back(line);
    } else if (finish(); out.yarns.size() == kMaxLibraryYarns) {
      return failure(base::ErrorKind::kInput, fill(tr("has more than {count} yarns"), arg("count", kMaxLibraryYarns)),
                     {}, number);
    } else {
      in_yarn = true;
    }
  }
  finish();
  const bool only_comments = std::ranges::all_of(out.head, [](const std::string& line) { return line[0] == '#'; });
  if (any && out.yarns.empty() && !only_comments)
    return failure(base::ErrorKind::kInput, tr("is not a yarn list: it has no [Yarn] line"));
  std::ranges::sort(out.remarks, {}, &LibraryRemark::line);
  return out;
}

std::string yarn_library_text(const YarnLibrary& library) {
  std::string out;
  for (const std::string& line : library.head) out.append(line).append("\n");
  if (library.head.empty()) out.append(kHead).append("\n");
  for (const LibraryYarn& yarn : library.yarns) out.append("\n").append(yarn_text(yarn));
  return out;
}

LibraryYarn as_written(const LibraryYarn& yarn) {
  const base::Result<YarnLibrary> read = read_yarn_library(yarn_text(yarn));
  return read && read->yarns.size() == 1 ? read->yarns.front() : yarn;
}

LibraryYarn library_yarn_of(const Design& design, int yarn, int color) {
  LibraryYarn out;
  if (yarn < 0 || static_cast<size_t>(yarn) >= design.yarns.size()) return out;
  out.yarn = design.yarns[static_cast<size_t>(yarn)];
  if (out.yarn.tex > 0) out.count = written_count(out.yarn);
  const YarnPurchase bought = purchase_of(design.plan, out.yarn.name);
  out.cone_g = bought.cone_g, out.cone_m = bought.cone_m, out.price = bought.price;
  const auto& palette = design.draft.palette;
  std::vector<bool> has(palette.size());
  for (const Threads* threads : {&design.draft.warp, &design.draft.weft})
    for (size_t i = 0; i < threads->yarn.size(); ++i)
      if (threads->yarn[i] == yarn) has[static_cast<size_t>(threads->color[i])] = true;
  for (size_t i = 0; i < palette.size(); ++i)
    if (has[i]) add_color(out.colors, {of_8_bits(palette[i]), {}});
  if (out.colors.empty() && color >= 0 && static_cast<size_t>(color) < palette.size())
    out.colors.push_back({of_8_bits(palette[static_cast<size_t>(color)]), {}});
  return out;
}

std::vector<LibraryYarn> with_library_yarn(std::vector<LibraryYarn> yarns, LibraryYarn yarn) {
  const auto same = std::ranges::find_if(yarns, [&](const LibraryYarn& y) {
    return y.yarn.name == yarn.yarn.name && y.count == yarn.count && y.yarn.tex == yarn.yarn.tex;
  });
  if (same != yarns.end()) {
    std::vector<YarnColor> colors = same->colors;
    for (const YarnColor& color : yarn.colors) add_color(colors, color);
    yarn.colors = std::move(colors);
    if (!(yarn.price > 0)) yarn.cone_g = same->cone_g, yarn.cone_m = same->cone_m, yarn.price = same->price;
    if (yarn.note.empty()) yarn.note = same->note;
    if (yarn.other_lines.empty()) yarn.other_lines = same->other_lines;
    *same = std::move(yarn);
    return yarns;
  }
  if (yarns.size() >= kMaxLibraryYarns) return yarns;
  const auto after = std::ranges::upper_bound(yarns, lowered(yarn.yarn.name), {},
                                              [](const LibraryYarn& y) { return lowered(y.yarn.name); });
  yarns.insert(after, std::move(yarn));
  return yarns;
}

UsedYarn with_yarn_from(Design design, const LibraryYarn& from, size_t color) {
  UsedYarn out{std::move(design)};
  std::vector<Yarn>& yarns = out.design.yarns;
  const Yarn yarn = clamped(from.yarn);
  if (std::ranges::find(yarns, yarn) == yarns.end()) out.design = with_new_yarn(std::move(out.design), yarn);
  out.yarn = static_cast<int>(
      std::min<size_t>(static_cast<size_t>(std::ranges::find(yarns, yarn) - yarns.begin()), yarns.size() - 1));
  if (from.price > 0 || from.cone_g > 0 || from.cone_m > 0)
    out.design.plan = clamped(with_purchase(out.design.plan, {yarn.name, from.cone_g, from.cone_m, from.price}));
  if (color >= from.colors.size()) return out;
  const Rgb rgb = from.colors[color].rgb;
  const auto& palette = out.design.draft.palette;
  const auto same = [&] {
    return std::ranges::find_if(palette, [&](Rgb c) { return packed_rgb(c) == packed_rgb(rgb); }) - palette.begin();
  };
  if (static_cast<size_t>(same()) == palette.size()) out.design = with_new_palette_color(std::move(out.design), rgb);
  out.color = static_cast<int>(std::min<size_t>(static_cast<size_t>(same()), palette.size() - 1));
  return out;
}

bool matches(const LibraryYarn& yarn, std::string_view typed) {
  std::string all = lowered(yarn.yarn.name + "\n" + yarn.count + "\n" + yarn.note);
  all.append("\n").append(lowered(tr(fibre_name(yarn.yarn.fibre))));
  for (const YarnColor& color : yarn.colors) all.append("\n").append(lowered(color.name));
  const std::string words = lowered(typed);
  for (size_t at = words.find_first_not_of(kBlanks); at != std::string::npos;) {
    const size_t end = std::min(words.find_first_of(kBlanks, at), words.size());
    if (all.find(words.substr(at, end - at)) == std::string::npos) return false;
    at = words.find_first_not_of(kBlanks, end);
  }
  return true;
}

}  // namespace weftlight::design
