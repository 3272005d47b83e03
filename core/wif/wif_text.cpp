#include "wif/wif_text.h"

#include <algorithm>
#include <climits>

#include "base/text.h"
#include "base/utf8.h"
#include "wif/numbers.h"

namespace weftlight::wif {

using base::arg, base::fill, base::is_utf8, base::tr;

namespace {

constexpr std::string_view kBom = "\xEF\xBB\xBF";

void split_lines(WifText& text) {
  const std::string_view bytes = text.bytes;
  uint32_t begin = text.bom ? static_cast<uint32_t>(kBom.size()) : 0;
  const uint32_t size = static_cast<uint32_t>(bytes.size());
  text.lines.reserve(std::min<size_t>(size / 10 + 1, kMaxLines));
  for (uint32_t i = begin; i < size; ++i) {
    const char c = bytes[i];
    if (c != '\n' && c != '\r') continue;
    const uint32_t eol = c == '\r' && i + 1 < size && bytes[i + 1] == '\n' ? 2 : 1;
    if (text.lines.size() == kMaxLines) {
      text.too_large = fill(tr("the file has more than {most} lines"), arg("most", kMaxLines));
      return;
    }
    text.lines.push_back({begin, i - begin, eol});
    i += eol - 1;
    begin = i + 1;
  }
  if (begin < size) text.lines.push_back({begin, size - begin, 0});
}

int key_number(std::string_view key) {
  if (key.empty()) return -1;
  int64_t value = 0;
  for (const char c : key) {
    if (c < '0' || c > '9') return -1;
    value = std::min<int64_t>(value * 10 + (c - '0'), INT_MAX);
  }
  return static_cast<int>(value);
}

/// Name between the brackets, in upper case, with single blanks.
std::string section_name(std::string_view line, bool& closed) {
  const size_t close = line.find(']');
  closed = close != std::string_view::npos;
  std::string name;
  for (const char c : trimmed(line.substr(1, closed ? close - 1 : std::string_view::npos))) {
    if (!is_blank(c)) {
      name += upper(c);
    } else if (name.back() != ' ') {
      name += ' ';
    }
  }
  return name;
}

WifSection& section_at(WifText& text, const std::string& name) {
  const auto [at, is_new] = text.section_index.try_emplace(name, static_cast<uint32_t>(text.sections.size()));
  if (is_new) text.sections.push_back({name, {}, {}, {}, {}});
  return text.sections[at->second];
}

/// Luminescence writes the weft's colours under a second [WARP COLORS]; that block is indexed as [WEFT COLORS].
void find_sections(WifText& text) {
  int warp_colors = 0;
  bool weft_colors = false;
  int second = -1;
  std::vector<std::pair<int, std::string>> headers;
  for (int i = 0; i < static_cast<int>(text.lines.size()); ++i) {
    const std::string_view line = trimmed(text.line(i));
    if (line.empty() || line.front() != '[') continue;
    bool closed = true;
    std::string name = section_name(line, closed);
    if (!closed) text.unclosed_headers.push_back(i);
    if (name == "WARP COLORS" && ++warp_colors == 2) second = i;
    weft_colors = weft_colors || name == "WEFT COLORS";
    headers.emplace_back(i, std::move(name));
  }
  if (second >= 0 && warp_colors == 2 && !weft_colors) text.second_warp_colors = second;
  const int count = static_cast<int>(text.lines.size());
  const int first_header = headers.empty() ? count : headers.front().first;
  if (first_header > 0) section_at(text, "").blocks.push_back({-1, 0, first_header});
  for (size_t h = 0; h < headers.size(); ++h) {
    const auto& [line, name] = headers[h];
    const int end = h + 1 < headers.size() ? headers[h + 1].first : count;
    if (text.sections.size() == kMaxTextSections) {
      text.too_large = fill(tr("the file has more than {most} sections"), arg("most", kMaxTextSections));
      return;
    }
    section_at(text, line == text.second_warp_colors ? "WEFT COLORS" : name).blocks.push_back({line, line + 1, end});
  }
}

void index_keys(WifText& text, WifSection& section) {
  for (const WifSection::Block& block : section.blocks) {
    for (int i = block.first; i < block.end; ++i) {
      const std::string_view line = trimmed(text.line(i));
      if (line.empty() || line.front() == ';') continue;
      const size_t equals = line.find('=');
      if (equals == std::string_view::npos) {
        section.other_lines.push_back(i);
        continue;
      }
      const std::string_view key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
      const int number = key_number(key);
      if (number < 0 && !value.empty())
        section.words.try_emplace(uppercase(key), static_cast<uint32_t>(section.keys.size()));
      section.keys.push_back({i, number, key, value});
    }
  }
}

}  // namespace

const WifKey* WifSection::find(std::string_view key) const {
  const auto found = words.find(uppercase(key));
  return found != words.end() ? &keys[found->second] : nullptr;
}

const WifSection* WifText::find(std::string_view name) const {
  const auto found = section_index.find(name);
  return found != section_index.end() ? &sections[found->second] : nullptr;
}

const WifKey* WifText::find(std::string_view section, std::string_view key) const {
  const WifSection* s = find(section);
  return s ? s->find(key) : nullptr;
}

WifText scan_wif(std::string_view bytes) {
  WifText text;
  text.bytes = bytes;
  text.bom = bytes.starts_with(kBom);
  text.encoding = is_utf8(bytes) ? Encoding::kUtf8 : Encoding::kLatin1;
  split_lines(text);
  if (text.too_large.empty()) find_sections(text);
  for (WifSection& section : text.sections) index_keys(text, section);
  return text;
}

}  // namespace weftlight::wif
