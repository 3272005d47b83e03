// Reports irregular lines of a file, regardless of their meaning. The lines are kept unchanged.

#include "base/text.h"
#include "wif/foreign.h"
#include "wif/numbers.h"
#include "wif/parse.h"

namespace weftlight::wif {

using base::arg, base::fill, base::tr;

namespace {

/// Sections in which every line must be a key; others may hold free text.
constexpr const char* kKeyedSections[] = {
    "WIF",         "CONTENTS",     "COLOR PALETTE", "WEAVING",        "WARP",           "WEFT",
    "TIEUP",       "COLOR TABLE",  "THREADING",     "TREADLING",      "LIFTPLAN",       "WARP COLORS",
    "WEFT COLORS", "WARP SPACING", "WEFT SPACING",  "WARP THICKNESS", "WEFT THICKNESS", "NOTES"};

void check_head(const WifText& text, Diagnostics& diagnostics) {
  const WifSection* before = text.find("");
  const bool named = text.find("WIF") != nullptr;
  if (before) {
    // Without [WIF] these are its keys; read_head reports the missing heading.
    if (named)
      for (const WifKey& key : before->keys)
        diagnostics.add(Severity::kNote, key.line, "before",
                        fill(tr("{line} comes before [WIF]"), arg("line", short_quote(text.line(key.line)))),
                        tr("used where [WIF] lacks the key; kept"));
    for (const int line : before->other_lines)
      diagnostics.warn(line, "before text",
                       fill(tr("{line} comes before the first heading"), arg("line", short_quote(text.line(line)))),
                       tr("not read, but kept; begin it with ; to make it a comment"));
  }
  const WifSection* first = nullptr;
  for (const WifSection& section : text.sections)
    if (!section.name.empty() && !first) first = &section;
  if (named && first && first->name != "WIF")
    diagnostics.add(Severity::kNote, first->blocks.front().header, {},
                    fill(tr("[{section}] comes before [WIF]"), arg("section", first->name)),
                    tr("read anyway; other programs may look for [WIF] in the first line"));
}

void check_other_lines(const WifText& text, const WifSection& section, Diagnostics& diagnostics) {
  for (const int line : section.other_lines)
    diagnostics.warn(line, section.name + " no key",
                     fill(tr("{line} in [{section}] has no ="), arg("line", short_quote(text.line(line))),
                          arg("section", section.name)),
                     tr("not read, but kept; write it as name=value, or begin it with ;"));
}

/// Reports repeated named keys; numbered rows are checked where they are read.
void check_twice(const WifSection& section, Diagnostics& diagnostics) {
  for (const WifKey& key : section.keys) {
    if (key.number >= 0 || key.value.empty()) continue;
    const WifKey* first = section.find(key.key);
    if (first == nullptr || first == &key) continue;
    const auto text = [&](const char* pattern) {
      return fill(pattern, arg("key", key.key), arg("section", section.name), arg("line", first->line + 1));
    };
    if (first->value == key.value)
      diagnostics.add(Severity::kNote, key.line, {},
                      text(tr("{key} appears twice in [{section}], with the value of line {line}")),
                      tr("kept; nothing to do"));
    else
      diagnostics.warn(key.line, {}, text(tr("{key} appears twice in [{section}], with different values")),
                       text(tr("line {line} was used; remove one")));
  }
}

}  // namespace

void check_lines(const WifText& text, Diagnostics& diagnostics) {
  check_head(text, diagnostics);
  for (const int line : text.unclosed_headers) {
    diagnostics.warn(line, "bracket", tr("a section heading has no closing bracket"), tr("read as if it had one"));
  }
  if (text.second_warp_colors >= 0) {
    diagnostics.warn(text.second_warp_colors, {}, tr("a second [WARP COLORS] and no [WEFT COLORS]"),
                     tr("read as the colours of the weft, as Luminescence writes them"));
  }
  for (const char* name : kKeyedSections) {
    const WifSection* section = text.find(name);
    if (!section) continue;
    if (section->blocks.size() > 1) {
      diagnostics.warn(section->blocks[1].header, {},
                       fill(tr("[{section}] appears more than once"), arg("section", section->name)),
                       tr("read as one section"));
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
    diagnostics.warn(-1, {}, tr("there is no [CONTENTS]"), tr("sections were found by their headings"));
    return;
  }
  for (const WifKey& key : contents->keys) {
    if (word_as_bool(key.value) == true && !text.find(uppercase(key.key))) {
      diagnostics.warn(key.line, "missing",
                       fill(tr("[CONTENTS] lists {section}, which is missing"), arg("section", key.key)),
                       tr("taken as absent; remove the line"));
    }
  }
  for (const WifSection& section : text.sections) {
    if (section.name.empty() || section.name == "WIF" || section.name == "CONTENTS" || section.name == "TRANSLATIONS")
      continue;
    const WifKey* key = contents->find(section.name);
    if (!key || word_as_bool(key->value) != true) {
      diagnostics.add(Severity::kNote, section.blocks.front().header, "unlisted",
                      fill(tr("[{section}] is not listed in [CONTENTS]"), arg("section", section.name)),
                      tr("read anyway; other programs may skip it"));
    }
  }
}

}  // namespace weftlight::wif
