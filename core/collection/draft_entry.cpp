#include "collection/draft_entry.h"

#include <algorithm>
#include <filesystem>

#include "base/utf8.h"
#include "collection/colour_names.h"
#include "draft/drawdown.h"
#include "wif/other_formats.h"

namespace weftlight::collection {

using base::as_utf8, base::cut_utf8;

namespace {

constexpr size_t kLongestTitle = 200;  // bytes of what is kept

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// One line of UTF-8.
std::string line_of(const std::string& text) {
  std::string line(cut_utf8(as_utf8(text), kLongestTitle));
  std::ranges::replace_if(
      line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return line;
}

}  // namespace

DraftEntry with_search_text(DraftEntry e) {
  e.found_by = e.title + '\n' + e.author + '\n' + e.path;
  std::ranges::transform(e.found_by, e.found_by.begin(), small);
  return e;
}

DraftEntry entry_of(DraftEntry file, std::string_view bytes) {
  const wif::WifRead read = wif::read_draft(bytes);
  if (!read.file) return with_search_text(std::move(file));
  const design::Design& d = read.file->design;
  file.readable = true;
  file.ends = d.draft.ends(), file.picks = d.draft.picks();
  file.shafts = d.draft.shafts;
  file.treadles = d.draft.shed_control == design::ShedControl::kLiftplan ? 0 : d.draft.treadles;
  file.family = analysis::weave_family(draft::drawdown(d.draft));
  file.colours = colours_of(d.draft);
  file.title = line_of(d.title), file.author = line_of(d.author);
  return with_search_text(std::move(file));
}

std::string shown_name(const DraftEntry& entry) {
  return entry.title.empty() ? as_utf8(std::filesystem::path(entry.path).stem().string()) : entry.title;
}

}  // namespace weftlight::collection
