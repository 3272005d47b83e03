#include "wif/foreign.h"

#include <algorithm>

#include "base/utf8.h"
#include "wif/encoding.h"
#include "wif/numbers.h"

namespace weftlight::wif {

using draft::ShedControl;

std::string quoted(std::string_view text) {
  std::string out(1, '\'');
  return out.append(text).append("'");
}

std::string short_quote(std::string_view text) {
  constexpr size_t kMaxQuotedBytes = 40;
  text = trimmed(text);
  if (text.size() <= kMaxQuotedBytes) return quoted(text);
  const std::string_view start =
      base::is_utf8(text) ? base::cut_utf8(text, kMaxQuotedBytes) : text.substr(0, kMaxQuotedBytes);
  return wif::quoted(std::string(start) + "...");
}

Rgb color_of_bytes(int r, int g, int b, int most) {
  const auto channel = [most](int value) {
    return static_cast<float>(std::clamp(value, 0, most)) / static_cast<float>(most);
  };
  return {channel(r), channel(g), channel(b)};
}

std::string text_of_foreign(std::string_view text) {
  constexpr size_t kLongest = 1000;
  const Encoding encoding = scan_wif(text).encoding;
  return one_line(to_utf8(text.substr(0, kLongest), encoding));
}

WifRead foreign_file(std::optional<WifFile> file, const char* format, Diagnostics& diagnostics) {
  if (!file || diagnostics.has_error()) return rejected(diagnostics.release());
  file->bytes = write_new_wif(file->design);
  file->format = format;
  file->has_liftplan = file->design.draft.shed_control == ShedControl::kLiftplan;
  file->has_tieup = file->has_treadling = !file->has_liftplan;
  file->rising_stated = true;
  return {std::move(*file), diagnostics.release()};
}

DraftFormat format_of(std::string_view bytes) {
  // .wpo: 123, a version, then 100, 101 or 102.
  if (bytes.size() > 3 && bytes[0] == 123 && static_cast<unsigned char>(bytes[1]) < 32 && bytes[2] >= 100 &&
      bytes[2] <= 102)
    return DraftFormat::kWpo;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  while (!bytes.empty() && (bytes.front() == '\r' || bytes.front() == '\n' || bytes.front() == ' '))
    bytes.remove_prefix(1);
  return bytes.starts_with("@@") ? DraftFormat::kDtx : DraftFormat::kWif;
}

namespace {

bool ends_in(std::string_view path, std::initializer_list<std::string_view> endings) {
  const auto same = [](char c, char wanted) {
    return (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) == wanted;
  };
  return std::ranges::any_of(endings, [&](std::string_view ending) {
    return path.size() >= ending.size() && std::ranges::equal(path.substr(path.size() - ending.size()), ending, same);
  });
}

}  // namespace

bool is_wif_name(std::string_view path) { return ends_in(path, {".wif", ".wifw"}); }
bool is_draft_name(std::string_view path) { return is_wif_name(path) || ends_in(path, {".dtx", ".wpo"}); }

WifRead read_draft(std::string_view bytes) {
  switch (format_of(bytes)) {
    case DraftFormat::kDtx:
      return read_dtx(bytes);
    case DraftFormat::kWpo:
      return read_wpo(bytes);
    default:
      return read_wif(bytes);
  }
}

}  // namespace weftlight::wif
