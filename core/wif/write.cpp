// Writes an edited file, a new file, and the plain file for other programs.

#include <algorithm>

#include "design/edits.h"
#include "wif/line_edits.h"
#include "wif/numbers.h"

namespace weftlight::wif {

using design::Design, design::to_liftplan, design::to_treadling;
using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::System, draft::Threads;

namespace {

constexpr std::string_view kEol = "\r\n";

struct Attempt {
  std::string bytes;
  Design design;  // as read back
  bool read = false;
};

std::optional<Attempt> attempt(const WifText& text, const std::vector<WifEntries>& before,
                               const std::vector<WifEntries>& now, EditScope scope) {
  std::optional<std::string> bytes = patched(text, before, now, scope);
  if (!bytes) return std::nullopt;
  Attempt result{std::move(*bytes), {}, false};
  Diagnostics diagnostics;
  if (std::optional<ParsedWif> parsed = parse_wif(result.bytes, diagnostics)) {
    result.design = std::move(parsed->design);
    result.read = true;
  }
  return result;
}

/// What the file says before the edit. Of versions that change these are its lines, so that odd ones go.
std::vector<WifEntries> lines_before(const Design& opened, const Design& now, const WifText& text,
                                     const WifDialect& dialect) {
  std::vector<WifEntries> before = sections_of(opened, dialect);
  if (opened.versions == now.versions) return before;
  std::erase_if(before, [](const WifEntries& section) { return is_version_section(section.name); });
  std::ranges::move(version_lines(text), std::back_inserter(before));
  return before;
}

std::vector<std::string> head_lines(const std::vector<WifEntries>& sections) {
  std::vector<std::string> lines{
      "[WIF]", "Version=1.1", "Date=April 20, 1997", "Developers=wif@mhsoft.com", "Source Program=Weftlight",
      "",      "[CONTENTS]"};
  for (const WifEntries& section : sections) lines.push_back(section.name + "=true");
  return lines;
}

std::string whole_file(const std::vector<WifEntries>& sections) {
  std::string out;
  for (const std::string& line : head_lines(sections)) out.append(line).append(kEol);
  for (const WifEntries& section : sections) {
    out.append(kEol).append("[").append(section.name).append("]").append(kEol);
    for (const WifEntry& entry : section.entries) {
      if (entry.value.empty() && !entry.is_text) continue;
      out.append(entry.number >= 0 ? std::to_string(entry.number) : entry.key)
          .append("=")
          .append(entry.value)
          .append(kEol);
    }
  }
  return out;
}

WifDialect new_dialect(const Draft& draft) {
  WifDialect dialect;
  dialect.has_yarns = true;
  for (const System system : {System::kWarp, System::kWeft}) {
    const Threads& threads = draft.threads(system);
    ColumnDialect& color = system == System::kWarp ? dialect.warp.color : dialect.weft.color;
    color.list_all = true;
    color.fallback = threads.size() > 0 ? threads.color.front() : 0;
  }
  return dialect;
}

/// Other programs expect a straight tie-up besides a liftplan.
Design with_straight_tieup(Design design) {
  Draft& draft = design.draft;
  draft.treadles = draft.shafts;
  draft.tieup = BitMatrix(draft.treadles, draft.shafts);
  for (int i = 0; i < draft.shafts; ++i) draft.tieup.set(i, i, true);
  draft.treadling = BitMatrix(draft.picks(), draft.treadles);
  return design;
}

/// Lines of at most `width` characters, broken at blanks if possible.
std::vector<std::string> wrapped(const std::string& text, size_t width) {
  std::vector<std::string> lines;
  std::string_view rest = trimmed(text);
  while (rest.size() > width) {
    size_t at = rest.rfind(' ', width);
    if (at == std::string_view::npos || at == 0) at = width;
    lines.emplace_back(trimmed(rest.substr(0, at)));
    rest = trimmed(rest.substr(at));
  }
  lines.emplace_back(rest);
  return lines;
}

std::vector<std::string> plain_notes(const std::vector<std::string>& notes) {
  constexpr size_t kConsoleWidth = 32;
  std::vector<std::string> result;
  for (const std::string& note : notes) {
    size_t begin = 0;
    while (begin <= note.size()) {
      const size_t end = std::min(note.find('\n', begin), note.size());
      for (std::string& line : wrapped(to_ascii(note.substr(begin, end - begin)), kConsoleWidth))
        result.push_back(std::move(line));
      begin = end + 1;
    }
  }
  return result;
}

}  // namespace

std::string write_wif(const WifFile& opened, const Design& now) {
  if (now == opened.design) return opened.bytes;
  Diagnostics diagnostics;
  const std::optional<ParsedWif> parsed = parse_wif(opened.bytes, diagnostics);
  if (!parsed) return write_new_wif(now);
  const std::vector<WifEntries> after = sections_of(now, parsed->dialect);
  // Change the fewest lines first, and more only if the result does not read back as `now`.
  std::string fallback;
  const auto try_text = [&](const WifText& text) -> std::optional<std::string> {
    const std::vector<WifEntries> before = lines_before(opened.design, now, text, parsed->dialect);
    for (const EditScope scope : {EditScope::kChanged, EditScope::kCounts, EditScope::kAll}) {
      std::optional<Attempt> tried = attempt(text, before, after, scope);
      if (!tried) return std::nullopt;
      if (tried->read && tried->design == now) return std::move(tried->bytes);
      if (fallback.empty() && tried->read && tried->design.draft == now.draft) fallback = std::move(tried->bytes);
    }
    return std::nullopt;
  };
  if (std::optional<std::string> bytes = try_text(parsed->text)) return *bytes;
  if (parsed->text.encoding != Encoding::kUtf8) {
    const std::string utf8 = to_utf8(opened.bytes, parsed->text.encoding);
    if (std::optional<std::string> bytes = try_text(scan_wif(utf8))) return *bytes;
  }
  return fallback.empty() ? write_new_wif(now) : fallback;
}

std::vector<WifEntries> new_file_sections(const Design& design) {
  return sections_of(design, new_dialect(design.draft));
}

std::string write_new_wif(const Design& design) { return whole_file(new_file_sections(design)); }

std::string write_preset_wif(const Design& design) {
  WifDialect dialect = new_dialect(design.draft);
  dialect.leaves_out_defaults = true;
  return whole_file(sections_of(design, dialect));
}

std::string write_plain_wif(const Design& design, PlainShedControl shed_control) {
  Design plain = shed_control == PlainShedControl::kLiftplan    ? to_liftplan(design)
                 : shed_control == PlainShedControl::kTreadling ? to_treadling(design)
                                                                : design;
  if (plain.draft.shed_control == ShedControl::kLiftplan) plain = with_straight_tieup(std::move(plain));
  plain.title = to_ascii(plain.title);
  plain.author = to_ascii(plain.author);
  plain.notes = plain_notes(plain.notes);
  WifDialect dialect = new_dialect(plain.draft);
  dialect.has_liftplan = true;
  return whole_file(public_sections_of(plain, dialect));
}

}  // namespace weftlight::wif
