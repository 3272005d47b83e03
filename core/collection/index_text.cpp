#include "collection/index_text.h"

#include <array>
#include <charconv>
#include <limits>

#include "draft/draft.h"

namespace weftlight::collection {
namespace {

// Its number changes with the fields, and with what analysis finds in a draft.
constexpr std::string_view kHeading = "weftlight drafts 3\n";

enum Field : size_t {
  kPath,
  kSize,
  kModified,
  kReadable,
  kEnds,
  kPicks,
  kShafts,
  kTreadles,
  kFamily,
  kColours,
  kTitle,
  kAuthor,
  kFields
};

void add_text(std::string& to, std::string_view text) {
  for (const char c : text) {
    if (c == '\t') to += "\\t";
    else if (c == '\n') to += "\\n";
    else if (c == '\\') to += "\\\\";
    else to += c;
  }
}

std::optional<std::string> text_from(std::string_view field) {
  std::string out;
  out.reserve(field.size());
  for (size_t i = 0; i < field.size(); ++i) {
    if (field[i] != '\\') {
      out += field[i];
      continue;
    }
    if (++i == field.size()) return {};
    if (field[i] == 't') out += '\t';
    else if (field[i] == 'n') out += '\n';
    else if (field[i] == '\\') out += '\\';
    else return {};
  }
  return out;
}

template <class T>
bool take(std::string_view field, T& value, T least, T most) {
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc() && end == field.data() + field.size() && value >= least && value <= most;
}

using Fields = std::array<std::string_view, kFields>;

std::optional<Fields> fields_of(std::string_view line) {
  Fields fields;
  for (size_t i = 0; i < kFields; ++i) {
    const size_t tab = line.find('\t');
    if ((tab == std::string_view::npos) != (i + 1 == kFields)) return {};
    fields[i] = line.substr(0, tab);
    line.remove_prefix(tab == std::string_view::npos ? line.size() : tab + 1);
  }
  return fields;
}

std::optional<DraftEntry> entry_from(std::string_view line) {
  const std::optional<Fields> f = fields_of(line);
  if (!f) return {};
  DraftEntry e;
  const auto text = [&](Field field, std::string& to) {
    std::optional<std::string> read = text_from((*f)[field]);
    if (read) to = std::move(*read);
    return read.has_value();
  };
  int readable = 0, family = 0;
  const bool good =
      text(kPath, e.path) && !e.path.empty() && text(kTitle, e.title) && text(kAuthor, e.author) &&
      take((*f)[kSize], e.size, uint64_t{0}, std::numeric_limits<uint64_t>::max()) &&
      take((*f)[kModified], e.modified_ns, std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()) &&
      take((*f)[kReadable], readable, 0, 1) && take((*f)[kEnds], e.ends, 0, draft::kMaxThreads) &&
      take((*f)[kPicks], e.picks, 0, draft::kMaxThreads) && take((*f)[kShafts], e.shafts, 0, draft::kMaxShafts) &&
      take((*f)[kTreadles], e.treadles, 0, draft::kMaxShafts) &&
      take((*f)[kFamily], family, 0, static_cast<int>(analysis::kWeaveFamilies) - 1) &&
      take((*f)[kColours], e.colours, uint32_t{0}, std::numeric_limits<uint32_t>::max());
  if (!good) return {};
  e.readable = readable == 1;
  e.family = static_cast<WeaveFamily>(family);
  return with_search_text(std::move(e));
}

}  // namespace

std::string index_text(const std::vector<DraftEntry>& entries) {
  std::string out(kHeading);
  for (const DraftEntry& e : entries) {
    add_text(out, e.path);
    const auto number = [&out](auto value) { (out += '\t') += std::to_string(value); };
    number(e.size), number(e.modified_ns), number(e.readable ? 1 : 0);
    number(e.ends), number(e.picks), number(e.shafts), number(e.treadles);
    number(static_cast<int>(e.family)), number(e.colours);
    add_text(out += '\t', e.title);
    add_text(out += '\t', e.author);
    out += '\n';
  }
  return out;
}

std::optional<std::vector<DraftEntry>> entries_from(std::string_view text) {
  if (!text.starts_with(kHeading)) return {};
  text.remove_prefix(kHeading.size());
  std::vector<DraftEntry> entries;
  while (!text.empty()) {
    const size_t end = text.find('\n');
    if (end == std::string_view::npos || entries.size() >= kMaxIndexed) return {};
    std::optional<DraftEntry> entry = entry_from(text.substr(0, end));
    if (!entry) return {};
    entries.push_back(std::move(*entry));
    text.remove_prefix(end + 1);
  }
  return entries;
}

}  // namespace weftlight::collection
