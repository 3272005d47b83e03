// What is odd about the lines of a file, whatever they mean: each is kept as it is, and listed.

#include "base/utf8.h"
#include "wif/foreign.h"
#include "wif/numbers.h"
#include "wif/parse.h"

namespace weftlight::wif {
namespace {

/// Sections whose lines must all be keys; others may hold free text.
constexpr const char* kKeyedSections[] = {
    "WIF",         "CONTENTS",     "COLOR PALETTE", "WEAVING",        "WARP",           "WEFT",
    "TIEUP",       "COLOR TABLE",  "THREADING",     "TREADLING",      "LIFTPLAN",       "WARP COLORS",
    "WEFT COLORS", "WARP SPACING", "WEFT SPACING",  "WARP THICKNESS", "WEFT THICKNESS", "NOTES"};
constexpr size_t kShown = 40;  // bytes of a quoted line

std::string short_quote(std::string_view line) {
  const std::string_view text = trimmed(line);
  if (text.size() <= kShown) return quoted(text);
  return quoted(std::string(is_utf8(text) ? cut_utf8(text, kShown) : text.substr(0, kShown)) + "...");
}

void check_heading_of_file(const WifText& text, Diagnostics& diagnostics) {
  const WifSection* before = text.find("");
  const bool named = text.find("WIF") != nullptr;
  if (before) {
    // Without the heading they are its keys, which is said once.
    if (named)
      for (const WifKey& key : before->keys)
        diagnostics.add(Severity::kNote, key.line, "before", short_quote(text.line(key.line)) + " stands before [WIF]",
                        "read where [WIF] does not say it, and kept");
    for (const int line : before->other_lines)
      diagnostics.warn(line, "before text", short_quote(text.line(line)) + " stands before the first heading",
                       "not read, and kept; begin it with ; to make it a comment");
  }
  const WifSection* first = nullptr;
  for (const WifSection& section : text.sections)
    if (!section.name.empty() && !first) first = &section;
  if (named && first && first->name != "WIF")
    diagnostics.add(Severity::kNote, first->blocks.front().header, {}, "[" + first->name + "] stands before [WIF]",
                    "read all the same; other programs may look for [WIF] in the first line");
}

void check_other_lines(const WifText& text, const WifSection& section, Diagnostics& diagnostics) {
  for (const int line : section.other_lines)
    diagnostics.warn(line, section.name + " no key",
                     short_quote(text.line(line)) + " in [" + section.name + "] has no =",
                     "not read, and kept; write it as name=value, or begin it with ;");
}

/// Words that are there twice; numbered rows are checked where they are read.
void check_twice(const WifSection& section, Diagnostics& diagnostics) {
  for (const WifKey& key : section.keys) {
    if (key.number >= 0 || key.value.empty()) continue;
    const WifKey* first = section.find(key.key);
    if (first == nullptr || first == &key) continue;
    const std::string what = std::string(key.key) + " is in [" + section.name + "] a second time";
    const std::string where = "line " + std::to_string(first->line + 1);
    if (first->value == key.value)
      diagnostics.add(Severity::kNote, key.line, {}, what + ", as in " + where, "kept; nothing to do");
    else diagnostics.warn(key.line, {}, what + ", with another value", where + " was used; remove one");
  }
}

}  // namespace

void check_lines(const WifText& text, Diagnostics& diagnostics) {
  check_heading_of_file(text, diagnostics);
  for (const int line : text.unclosed_headers) {
    diagnostics.warn(line, "bracket", "a section heading has no closing bracket", "read as if it had one");
  }
  if (text.second_warp_colors >= 0) {
    diagnostics.warn(text.second_warp_colors, {}, "a second [WARP COLORS] and no [WEFT COLORS]",
                     "read as the colours of the weft, as Luminescence writes them");
  }
  for (const char* name : kKeyedSections) {
    const WifSection* section = text.find(name);
    if (!section) continue;
    if (section->blocks.size() > 1) {
      diagnostics.warn(section->blocks[1].header, {}, "[" + section->name + "] is there more than once",
                       "read as one section");
    }
    check_other_lines(text, *section, diagnostics);
    check_twice(*section, diagnostics);
  }
  if (const WifSection* words = text.find("TEXT")) {
    check_other_lines(text, *words, diagnostics);
    check_twice(*words, diagnostics);
  }
}

void check_contents(const WifText& text, Diagnostics& diagnostics) {
  const WifSection* contents = text.find("CONTENTS");
  if (!contents) {
    diagnostics.warn(-1, {}, "there is no [CONTENTS]", "sections were found by their headings");
    return;
  }
  for (const WifKey& key : contents->keys) {
    if (word_as_bool(key.value) == true && !text.find(uppercase(key.key))) {
      diagnostics.warn(key.line, "missing", "[CONTENTS] lists " + std::string(key.key) + ", which is not there",
                       "taken as absent; remove the line");
    }
  }
  for (const WifSection& section : text.sections) {
    if (section.name.empty() || section.name == "WIF" || section.name == "CONTENTS" || section.name == "TRANSLATIONS")
      continue;
    const WifKey* key = contents->find(section.name);
    if (!key || word_as_bool(key->value) != true) {
      diagnostics.add(Severity::kNote, section.blocks.front().header, "unlisted",
                      "[" + section.name + "] is not listed in [CONTENTS]",
                      "read all the same; other programs may skip it");
    }
  }
}

}  // namespace weftlight::wif
