// Edits lines in place. A changed value keeps the spacing, comment and line end of its line; a new key goes where its
// number belongs; a new section is appended and listed in [CONTENTS].

#include "wif/line_edits.h"

#include <algorithm>
#include <unordered_map>

#include "wif/numbers.h"

namespace weftlight::wif {
namespace {

/// Changes or removes a line, or inserts one after it (line -1: before the first).
struct LineEdit {
  int line = 0;
  bool insert = false;
  bool remove = false;
  std::string text;  // without line end
};

class Patch {
 public:
  explicit Patch(const WifText& text) : text_(text) { find_style(); }

  void set_value(const WifKey& key, const WifEntry& entry);
  void remove_line(int line) { edits_.push_back({line, false, true, {}}); }
  void insert_after(int line, std::string text) { edits_.push_back({line, true, false, std::move(text)}); }
  void append(std::string text) { appended_.push_back(std::move(text)); }
  std::string new_line(const WifEntry& entry, const WifKey* neighbour) const;
  const WifText& text() const { return text_; }
  /// The bytes with all edits; empty if the encoding cannot represent a text.
  std::optional<std::string> bytes();

 private:
  void find_style();
  void end_line(std::string& out, int neighbour) const;
  const WifText& text_;
  std::string eol_ = "\r\n", separator_ = "=";
  std::vector<LineEdit> edits_;
  std::vector<std::string> appended_;
  bool unencodable_ = false;
};

/// The text between key and value of a line: "=", " = " ...
std::string_view separator_of(const WifKey& key) {
  const char* begin = key.key.data() + key.key.size();
  const char* end = key.value.data();
  return end > begin ? std::string_view(begin, static_cast<size_t>(end - begin)) : "=";
}

void Patch::find_style() {
  for (int i = 0; i < static_cast<int>(text_.lines.size()); ++i) {
    if (text_.lines[static_cast<size_t>(i)].eol_size == 0) continue;
    eol_ = text_.eol(i);
    break;
  }
  for (const WifSection& section : text_.sections) {
    for (const WifKey& key : section.keys) {
      if (key.value.empty()) continue;
      separator_ = separator_of(key);
      return;
    }
  }
}

/// true/false, yes/no, on/off or 1/0, in the style of `example`.
std::string bool_word(bool on, std::string_view example) {
  constexpr const char* kPairs[][2] = {{"true", "false"}, {"yes", "no"}, {"on", "off"}, {"1", "0"}};
  for (const auto& pair : kPairs) {
    if (same_word(example, pair[0]) || same_word(example, pair[1])) return pair[on ? 0 : 1];
  }
  return on ? "true" : "false";
}

/// Size of the value without a comment; a comment may follow numbers and words, but not text.
size_t value_size(const WifKey& key, const WifEntry& entry) {
  if (entry.is_text) return key.value.size();
  const size_t comment = std::min(key.value.find(';'), key.value.size());
  const size_t numbers = leading_numbers_size(key.value);
  if (numbers > 0) return numbers;
  return trimmed(key.value.substr(0, comment)).size();
}

void Patch::set_value(const WifKey& key, const WifEntry& entry) {
  const std::string_view line = text_.line(key.line);
  const bool had_value = !key.value.empty();
  const size_t size = had_value ? value_size(key, entry) : 0;
  // An empty value starts after the "=" and one blank.
  size_t at = had_value ? static_cast<size_t>(key.value.data() - line.data()) : line.find('=') + 1;
  if (!had_value && at < line.size() && is_blank(line[at])) ++at;
  std::string value = entry.value;
  if (!entry.is_text && (value == "true" || value == "false"))
    value = bool_word(value == "true", key.value.substr(0, size));
  const std::optional<std::string> encoded = from_utf8(value, text_.encoding);
  if (!encoded) unencodable_ = true;
  std::string out(line.substr(0, at));
  out += encoded.value_or("");
  out += line.substr(at + size);
  edits_.push_back({key.line, false, false, std::move(out)});
}

std::string Patch::new_line(const WifEntry& entry, const WifKey* neighbour) const {
  std::string out = entry.number >= 0 ? std::to_string(entry.number) : entry.key;
  out += neighbour && !neighbour->value.empty() ? std::string(separator_of(*neighbour)) : separator_;
  return out + entry.value;
}

void Patch::end_line(std::string& out, int neighbour) const {
  const bool known = neighbour >= 0 && text_.lines[static_cast<size_t>(neighbour)].eol_size > 0;
  out += known ? std::string(text_.eol(neighbour)) : eol_;
}

std::optional<std::string> Patch::bytes() {
  std::stable_sort(edits_.begin(), edits_.end(), [](const LineEdit& a, const LineEdit& b) {
    return a.line != b.line ? a.line < b.line : a.insert < b.insert;
  });
  const int count = static_cast<int>(text_.lines.size());
  const bool ended = count == 0 || text_.lines.back().eol_size > 0;
  std::string out(text_.bytes.substr(0, text_.bom ? 3 : 0));
  out.reserve(text_.bytes.size() + 64 * (edits_.size() + appended_.size()));
  size_t next = 0;
  bool open = false;  // the last written line has no line end yet
  const auto put = [&](const std::string& utf8, int neighbour) {
    if (open) end_line(out, -1);
    const std::optional<std::string> encoded = from_utf8(utf8, text_.encoding);
    if (!encoded) unencodable_ = true;
    out += encoded.value_or("");
    end_line(out, neighbour);
    open = false;
  };
  for (int line = -1; line < count; ++line) {
    bool done = line < 0;
    for (; next < edits_.size() && edits_[next].line == line; ++next) {
      const LineEdit& edit = edits_[next];
      if (edit.insert) {
        if (!done) {
          out.append(text_.line(line)).append(text_.eol(line));
          open = text_.eol(line).empty();
          done = true;
        }
        put(edit.text, line);
      } else if (!done) {
        if (!edit.remove) {
          out.append(edit.text).append(text_.eol(line));
          open = text_.eol(line).empty();
        }
        done = true;
      }
    }
    if (done) continue;
    out.append(text_.line(line)).append(text_.eol(line));
    open = text_.eol(line).empty();
  }
  for (const std::string& line : appended_) put(line, -1);
  // If the last line of the file had no line end, it still has none.
  if (!ended && !open && out.ends_with(eol_)) out.resize(out.size() - eol_.size());
  if (unencodable_) return std::nullopt;
  return out;
}

const WifEntries* find(const std::vector<WifEntries>& all, std::string_view name) {
  for (const WifEntries& section : all) {
    if (section.name == name) return &section;
  }
  return nullptr;
}

/// The lines of a section by key, duplicates included.
class KeyLines {
 public:
  explicit KeyLines(const WifSection& section) : section_(section) {
    for (size_t i = 0; i < section.keys.size(); ++i) {
      const WifKey& key = section.keys[i];
      if (key.number >= 0) numbered_.emplace_back(key.number, static_cast<int>(i));
    }
    std::stable_sort(numbered_.begin(), numbered_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  template <class Use>
  bool each(const WifEntry& entry, Use use) const {
    bool found = false;
    if (entry.number >= 0) {
      for (auto it = at(entry.number); it != numbered_.end() && it->first == entry.number; ++it, found = true)
        use(key(it));
    } else {
      for (const WifKey& k : section_.keys) {
        if (same_word(k.key, entry.key)) {
          use(k);
          found = true;
        }
      }
    }
    return found;
  }
  /// The key after which (if `before`, before which) a new row is inserted.
  const WifKey* neighbour(int number, bool& before) const {
    auto it = at(number);
    before = it == numbered_.begin();
    if (numbered_.empty()) return nullptr;
    return &key(before ? it : std::prev(it));
  }
  const WifKey* last() const { return section_.keys.empty() ? nullptr : &section_.keys.back(); }
  int header() const { return section_.blocks.front().header; }
  /// Keys numbered `number` and above.
  template <class Use>
  void each_from(int number, Use use) const {
    for (auto it = at(number); it != numbered_.end(); ++it) use(key(it));
  }

 private:
  using Numbered = std::vector<std::pair<int, int>>;
  Numbered::const_iterator at(int number) const {
    return std::lower_bound(numbered_.begin(), numbered_.end(), number,
                            [](const auto& a, int n) { return a.first < n; });
  }
  const WifKey& key(Numbered::const_iterator it) const { return section_.keys[static_cast<size_t>(it->second)]; }
  const WifSection& section_;
  Numbered numbered_;
};

void insert_entry(Patch& patch, const KeyLines& lines, const WifEntry& entry) {
  bool before = false;
  const WifKey* near = entry.number >= 0 ? lines.neighbour(entry.number, before) : lines.last();
  const int line = !near ? lines.header() : before ? near->line - 1 : near->line;
  patch.insert_after(line, patch.new_line(entry, near));
}

using Values = std::unordered_map<std::string_view, std::string_view>;

/// Whether the value of an entry changed. Entries are passed in ascending order of their numbers.
class Changes {
 public:
  explicit Changes(const WifEntries* before) : before_(before) {
    if (!before_) return;
    for (const WifEntry& e : before_->entries) {
      if (e.number < 0) named_[e.key] = e.value;
    }
  }
  bool is_new(const WifEntry& entry) {
    if (!before_) return true;
    if (entry.number < 0) {
      const auto it = named_.find(entry.key);
      return it == named_.end() || it->second != entry.value;
    }
    while (at_ < before_->entries.size() && before_->entries[at_].number < entry.number) ++at_;
    return at_ == before_->entries.size() || before_->entries[at_].number != entry.number ||
           before_->entries[at_].value != entry.value;
  }

 private:
  const WifEntries* before_;
  Values named_;
  size_t at_ = 0;
};

bool has_value(const WifKey& key, const WifEntry& entry) {
  return key.value.substr(0, value_size(key, entry)) == entry.value;
}

void set_entry(Patch& patch, const KeyLines& lines, const WifEntry& entry) {
  const bool there = lines.each(entry, [&](const WifKey& key) { patch.set_value(key, entry); });
  if (!there && (entry.is_text || !entry.value.empty())) insert_entry(patch, lines, entry);
}

bool is_count_section(const std::string& name) {
  return name == "WEAVING" || name == "WARP" || name == "WEFT" || name == "COLOR PALETTE";
}

bool has_key(const WifEntries& section, const WifEntry& entry) {
  if (entry.number >= 0) {
    return std::binary_search(section.entries.begin(), section.entries.end(), entry,
                              [](const WifEntry& a, const WifEntry& b) { return a.number < b.number; });
  }
  return std::any_of(section.entries.begin(), section.entries.end(),
                     [&](const WifEntry& e) { return same_word(e.key, entry.key); });
}

void change_section(Patch& patch, const WifSection& section, const WifEntries* before, const WifEntries& now,
                    EditScope scope) {
  const KeyLines lines(section);
  Changes changes(before);
  const bool all = scope == EditScope::kAll || (scope == EditScope::kCounts && is_count_section(now.name));
  for (const WifEntry& entry : now.entries) {
    bool set = changes.is_new(entry);
    if (all && !set) {
      bool same = true;
      const bool there = lines.each(entry, [&](const WifKey& key) { same = same && has_value(key, entry); });
      set = !there || !same;
    }
    if (set) set_entry(patch, lines, entry);
  }
  if (!before) return;
  for (const WifEntry& entry : before->entries) {
    if (!has_key(now, entry)) lines.each(entry, [&](const WifKey& key) { patch.remove_line(key.line); });
  }
}

/// Removes headings, keys and blank lines of a section, but not its comments. If the section has lines that were not
/// understood, only its keys are removed, but of versions, which would be read again, all.
void remove_section(Patch& patch, const WifSection& section) {
  if (!section.other_lines.empty() && !is_version_section(section.name)) {
    for (const WifKey& key : section.keys) patch.remove_line(key.line);
    return;
  }
  for (const WifSection::Block& block : section.blocks) {
    for (int line = std::max(block.header, 0); line < block.end; ++line) {
      const std::string_view text = trimmed(patch.text().line(line));
      if (line != block.header && text.starts_with(";")) continue;
      patch.remove_line(line);
    }
  }
}

void append_section(Patch& patch, const WifEntries& section) {
  const WifText& text = patch.text();
  const bool blank_before = !text.lines.empty() && !trimmed(text.line(static_cast<int>(text.lines.size()) - 1)).empty();
  if (blank_before) patch.append({});
  patch.append("[" + section.name + "]");
  for (const WifEntry& entry : section.entries) {
    if (entry.is_text || !entry.value.empty()) patch.append(patch.new_line(entry, nullptr));
  }
}

void list_in_contents(Patch& patch, const std::string& name) {
  const WifSection* contents = patch.text().find("CONTENTS");
  if (!contents) return;
  const KeyLines lines(*contents);
  const WifKey* last = lines.last();
  WifEntry entry{-1, name, "true", false};
  if (last) entry.value = bool_word(true, last->value.substr(0, value_size(*last, entry)));
  const bool there = lines.each(entry, [&](const WifKey& key) {
    if (word_as_bool(key.value) != true) patch.set_value(key, entry);
  });
  if (!there) insert_entry(patch, lines, entry);
}

void remove_from_contents(Patch& patch, const std::string& name) {
  const WifSection* contents = patch.text().find("CONTENTS");
  if (!contents) return;
  KeyLines(*contents).each({-1, name, {}, false}, [&](const WifKey& key) { patch.remove_line(key.line); });
}

int count_of(const std::vector<WifEntries>& all, const char* system) {
  const WifEntries* head = find(all, system);
  return head ? leading_int(head->entries.front().value).value_or(0) : 0;
}

/// Removes rows of other tables that belong to removed threads.
void trim_tables(Patch& patch, const char* system, const std::vector<WifEntries>& before,
                 const std::vector<WifEntries>& now) {
  const int count = count_of(now, system);
  if (count >= count_of(before, system)) return;
  for (const char* table : {" SYMBOLS", " SPACING ZOOM", " THICKNESS ZOOM"}) {
    const WifSection* section = patch.text().find(std::string(system) + table);
    if (section) KeyLines(*section).each_from(count + 1, [&](const WifKey& key) { patch.remove_line(key.line); });
  }
}

}  // namespace

std::optional<std::string> patched(const WifText& text, const std::vector<WifEntries>& before,
                                   const std::vector<WifEntries>& now, EditScope scope) {
  Patch patch(text);
  for (const WifEntries& section : now) {
    const WifEntries* old = find(before, section.name);
    const WifSection* lines = text.find(section.name);
    if (lines) {
      change_section(patch, *lines, old, section, scope);
      if (!old) list_in_contents(patch, section.name);
    } else if (scope != EditScope::kChanged || !old || old->entries != section.entries) {
      append_section(patch, section);
      list_in_contents(patch, section.name);
    }
  }
  for (const WifEntries& section : before) {
    if (find(now, section.name)) continue;
    const WifSection* lines = text.find(section.name);
    if (lines) remove_section(patch, *lines);
    if (!lines || lines->other_lines.empty() || is_version_section(section.name))
      remove_from_contents(patch, section.name);
  }
  trim_tables(patch, "WARP", before, now);
  trim_tables(patch, "WEFT", before, now);
  return patch.bytes();
}

}  // namespace weftlight::wif
