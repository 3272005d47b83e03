// Reads the index of lines into a Design, leniently and with diagnostics. Sources: WIF 1.1 (20 April 1997) and the
// files of other programs.

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "draft/drawdown.h"
#include "wif/foreign.h"
#include "wif/private.h"
#include "wif/section_rows.h"

namespace weftlight::wif {

using base::arg, base::fill, base::tr;
using design::Design;
using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::System, draft::kMaxCells, draft::kMaxShafts,
    draft::kMaxThreads, draft::lifts;

int row_base(const WifSection& section, int count) {
  bool zero = false;
  for (const WifKey& key : section.keys) {
    if (key.value.empty()) continue;
    if (key.number == count) return 1;
    zero = zero || key.number == 0;
  }
  return zero ? 0 : 1;
}

void note_short_list(const WifSection& section, int count, Diagnostics& diagnostics, const std::string& rest) {
  const WifKey* last = nullptr;
  for (const WifKey& key : section.keys)
    if (key.number >= 0 && (last == nullptr || key.number > last->number)) last = &key;
  if (last == nullptr || last->number >= count - (row_base(section, count) == 0 ? 1 : 0)) return;
  diagnostics.add(Severity::kNote, last->line, {},
                  fill(tr("[{section}] ends with line {number}, but there are {count} threads"),
                       arg("section", section.name), arg("number", last->number), arg("count", count)),
                  rest);
}

namespace {

struct Reader {
  const WifText& text;
  Diagnostics& diagnostics;
  WifDialect& dialect;
  Design& design;

  Draft& draft() const { return design.draft; }
  int line_of(std::string_view section) const {
    const WifSection* s = text.find(section);
    return s && !s->blocks.empty() ? s->blocks.front().header : -1;
  }
  std::string text_of(const WifKey* key) const { return key ? to_utf8(key->value, text.encoding) : std::string{}; }
  /// [WIF], or the lines before the first header.
  const WifKey* wif(std::string_view key) const {
    const WifKey* found = text.find("WIF", key);
    return found ? found : text.find("", key);
  }
};

/// The number of a key; warns if its value is not a number.
std::optional<int> int_of(const Reader& r, const WifKey* key) {
  if (!key) return std::nullopt;
  const std::optional<int> value = leading_int(key->value);
  if (!value) {
    r.diagnostics.warn(key->line, {}, fill(tr("{key} is not a number"), arg("key", key->key)),
                       tr("ignored; write a whole number"));
  }
  return value;
}

int largest_key(const WifSection* section) {
  int largest = 0;
  if (section) {
    for (const WifKey& key : section->keys) {
      if (!key.value.empty() && key.number > largest && key.number <= kMaxThreads) largest = key.number;
    }
  }
  return largest;
}

/// "at most 4096 can be opened; correct the count"
std::string limit_remedy(int most) {
  return fill(tr("at most {most} can be opened; correct the count"), arg("most", most));
}

/// Number of threads of [WARP] or [WEFT]; 0 after an error.
int read_thread_count(const Reader& r, const char* system, std::initializer_list<const char*> tables) {
  const WifKey* key = r.text.find(system, "Threads");
  int count = int_of(r, key).value_or(0);
  if (count > kMaxThreads) {
    r.diagnostics.add(Severity::kError, key->line, {},
                      fill(tr("[{section}] Threads is {count}"), arg("section", system), arg("count", count)),
                      limit_remedy(kMaxThreads));
    return 0;
  }
  if (count <= 0) {
    count = 0;
    for (const char* table : tables) count = std::max(count, largest_key(r.text.find(table)));
    const int line = key ? key->line : r.line_of(system);
    if (count == 0) {
      r.diagnostics.add(Severity::kError, line, {},
                        system[1] == 'A' ? tr("the draft has no ends") : tr("the draft has no picks"),
                        fill(tr("give their number as Threads= in [{section}]"), arg("section", system)));
    } else {
      r.diagnostics.warn(line, {}, fill(tr("[{section}] Threads is missing"), arg("section", system)),
                         fill(tr("taken as {count}, the last line listed"), arg("count", count)));
    }
  }
  return count;
}

/// Largest value up to kMaxShafts in the lists of a section.
int largest_value(const Reader& r, const char* name, int& line) {
  int largest = 0;
  std::vector<int> list;
  if (const WifSection* section = r.text.find(name)) {
    for (const WifKey& key : section->keys) {
      leading_ints(key.value, list);
      for (const int value : list) {
        if (value > largest && value <= kMaxShafts) {
          largest = value;
          line = key.line;
        }
      }
    }
  }
  return largest;
}

int read_shaft_count(const Reader& r) {
  const WifKey* key = r.text.find("WEAVING", "Shafts");
  const int stated = int_of(r, key).value_or(0);
  if (stated > kMaxShafts) {
    r.diagnostics.add(Severity::kError, key->line, {}, fill(tr("[WEAVING] Shafts is {count}"), arg("count", stated)),
                      limit_remedy(kMaxShafts));
    return 0;
  }
  int used = 0, used_line = -1;
  for (const char* name : {"THREADING", "TIEUP", "LIFTPLAN"}) {
    int line = -1;
    const int largest = largest_value(r, name, line);
    if (largest > used) {
      used = largest;
      used_line = line;
    }
  }
  if (stated > 0 && used > stated) {
    r.diagnostics.warn(
        used_line, {},
        fill(tr("shaft {used} is used but [WEAVING] Shafts is {stated}"), arg("used", used), arg("stated", stated)),
        fill(tr("read with {used} shafts; correct one of the two"), arg("used", used)));
  } else if (stated <= 0) {
    r.diagnostics.warn(key ? key->line : r.line_of("WEAVING"), {}, tr("[WEAVING] Shafts is missing"),
                       fill(tr("taken as {count}, the highest shaft used"), arg("count", std::max(used, 1))));
  }
  return std::max({stated, used, 1});
}

/// Some programs count treadles from 0 in [TIEUP], some also in [TREADLING]. Recognised by ties in row 0 of [TIEUP].
void find_treadle_base(const Reader& r, int stated) {
  const WifSection* tieup = r.text.find("TIEUP");
  if (!tieup) return;
  bool zero = false;
  int last = 0;
  for (const WifKey& key : tieup->keys) {
    if (leading_int(key.value).value_or(0) <= 0) continue;
    zero = zero || key.number == 0;
    last = std::max(last, key.number);
  }
  if (!zero || (stated > 0 && last >= stated)) return;
  r.dialect.zero_based.push_back("TIEUP");
  int line = -1;
  if (largest_value(r, "TREADLING", line) <= last) r.dialect.treadle_base = 0;
  r.diagnostics.add(Severity::kNote, r.line_of("TIEUP"), {}, tr("[TIEUP] counts from 0"),
                    tr("read that way; nothing to do"));
}

int read_treadle_count(const Reader& r) {
  const WifKey* key = r.text.find("WEAVING", "Treadles");
  const int stated = int_of(r, key).value_or(0);
  if (stated > kMaxShafts) {
    r.diagnostics.add(Severity::kError, key->line, {}, fill(tr("[WEAVING] Treadles is {count}"), arg("count", stated)),
                      limit_remedy(kMaxShafts));
    return 0;
  }
  find_treadle_base(r, stated);
  int line = -1;
  int used = std::min(largest_value(r, "TREADLING", line) + 1 - r.dialect.treadle_base, kMaxShafts);
  const int shift = 1 - r.dialect.base_of("TIEUP");
  if (const WifSection* tieup = r.text.find("TIEUP")) {
    for (const WifKey& k : tieup->keys) {
      if (k.number < kMaxShafts && k.number + shift > used && leading_int(k.value).value_or(0) != 0) {
        used = k.number + shift;
        line = k.line;
      }
    }
  }
  if (stated > 0 && used > stated) {
    r.diagnostics.warn(
        line, {},
        fill(tr("treadle {used} is used but [WEAVING] Treadles is {stated}"), arg("used", used), arg("stated", stated)),
        fill(tr("read with {used} treadles; correct one of the two"), arg("used", used)));
  } else if (stated <= 0 && (used > 0 || !r.text.find("LIFTPLAN"))) {
    r.diagnostics.warn(key ? key->line : r.line_of("WEAVING"), {}, tr("[WEAVING] Treadles is missing"),
                       fill(tr("taken as {count}, the highest treadle used"), arg("count", std::max(used, 1))));
  }
  return std::max({stated, used, 1});
}

void read_rising(const Reader& r, WifFile* info) {
  const WifKey* key = r.text.find("WEAVING", "Rising Shed");
  const std::optional<bool> value = key ? word_as_bool(key->value) : std::nullopt;
  if (!value) {
    r.diagnostics.warn(key ? key->line : r.line_of("WEAVING"), {},
                       key ? tr("Rising Shed is neither true nor false") : tr("[WEAVING] has no Rising Shed"),
                       tr("read as rising; write Rising Shed=true, or false for a sinking shed"));
  }
  r.draft().rising = value.value_or(true);
  if (info) info->rising_stated = value.has_value();
}

/// "[THREADING] end 3".
std::string place_of(const WifSection& section, int number) {
  const char* form = section.name == "THREADING" ? tr("[{section}] end {number}")
                     : section.name == "TIEUP"   ? tr("[{section}] treadle {number}")
                                                 : tr("[{section}] pick {number}");
  return fill(form, arg("section", section.name), arg("number", number));
}

/// Rows of lists (threading, tie-up, treadling, liftplan) as bits.
/// `shafts`: the values are shafts, otherwise treadles.
void read_lists(Reader& r, const char* name, BitMatrix& bits, bool shafts, int value_base = 1) {
  const WifSection* section = r.text.find(name);
  if (!section) return;
  const bool is_tieup = section->name == "TIEUP";  // its base is known already
  const int base = is_tieup ? r.dialect.base_of(name) : row_base(*section, bits.rows());
  if (base == 0 && !is_tieup) {
    r.dialect.zero_based.push_back(name);
    r.diagnostics.add(Severity::kNote, r.line_of(name), {}, fill(tr("[{section}] counts from 0"), arg("section", name)),
                      tr("read that way; nothing to do"));
  }
  std::vector<int> list;
  each_row(*section, bits.rows(), base, r.diagnostics, [&](int row, const WifKey& key) {
    const std::string_view wrong = leading_ints(key.value, list);
    if (!wrong.empty()) {
      r.diagnostics.warn(
          key.line, section->name + " value",
          fill(shafts ? tr("{place}: {value} is not the number of a shaft")
                      : tr("{place}: {value} is not the number of a treadle"),
               arg("place", place_of(*section, key.number)), arg("value", short_quote(wrong))),
          shafts ? tr("ignored; write the numbers of its shafts") : tr("ignored; write the numbers of its treadles"));
    }
    for (const int value : list) {
      if (value >= value_base && value - value_base < bits.cols()) {
        bits.set(row, value - value_base, true);
      } else if (value != 0) {
        r.diagnostics.warn(key.line, section->name + " shaft",
                           fill(shafts ? tr("{place} names shaft {number}") : tr("{place} names treadle {number}"),
                                arg("place", place_of(*section, key.number)), arg("number", value)),
                           fill(tr("ignored; there are {count}"), arg("count", bits.cols())));
      }
    }
  });
}

void note_differing_liftplan(const Reader& r, const BitMatrix& liftplan) {
  const BitMatrix from_treadles = lifts(r.draft());
  for (int pick = 0; pick < liftplan.rows(); ++pick) {
    if (std::ranges::equal(liftplan.row(pick), from_treadles.row(pick))) continue;
    r.diagnostics.warn(
        r.line_of("LIFTPLAN"), {},
        fill(tr("the liftplan differs from tie-up and treadling, first at pick {pick}"), arg("pick", pick + 1)),
        tr("tie-up and treadling were used; remove one of the two"));
    return;
  }
}

/// The shed control is tie-up and treadling if they lift anything, otherwise the liftplan.
void read_shed_control(Reader& r, WifFile* info) {
  Draft& draft = r.draft();
  const bool has_tieup = r.text.find("TIEUP"), has_treadling = r.text.find("TREADLING");
  const bool has_liftplan = r.text.find("LIFTPLAN");
  read_lists(r, "TIEUP", draft.tieup, true);
  read_lists(r, "TREADLING", draft.treadling, false, r.dialect.treadle_base);
  BitMatrix liftplan(draft.picks(), draft.shafts);
  read_lists(r, "LIFTPLAN", liftplan, true);
  draft.shed_control = ShedControl::kTreadling;
  const bool treadles_lift = has_tieup && has_treadling && lifts(draft).count() > 0;
  if (!treadles_lift && (liftplan.count() > 0 || (has_liftplan && !has_treadling)))
    draft.shed_control = ShedControl::kLiftplan;
  if (draft.shed_control == ShedControl::kLiftplan) {
    draft.treadling = BitMatrix(draft.picks(), draft.treadles);
    draft.liftplan = std::move(liftplan);
  } else {
    if (has_liftplan) note_differing_liftplan(r, liftplan);
    if (!has_liftplan && !has_treadling) {
      r.diagnostics.warn(-1, {}, tr("there is neither a treadling nor a liftplan"),
                         tr("every pick is empty; add [TREADLING] or [LIFTPLAN]"));
    } else if (!has_tieup) {
      r.diagnostics.warn(r.line_of("TREADLING"), {}, tr("there is a treadling but no tie-up"),
                         tr("no shaft moves; add [TIEUP]"));
    }
  }
  r.dialect.has_liftplan = has_liftplan;
  if (info) {
    info->has_liftplan = has_liftplan;
    info->has_treadling = has_treadling;
    info->has_tieup = has_tieup;
  }
}

/// Some programs fill a small draft up to their largest size with unused threads. True if this one is such.
bool note_empty_tail(const Reader& r, const BitMatrix& rows, System system) {
  constexpr int kMinThreads = 100, kMinRatio = 4;
  int used = rows.rows();
  while (used > 0 && rows.first(used - 1) < 0) --used;
  if (used == 0 || rows.rows() < kMinThreads || rows.rows() < used * kMinRatio) return false;
  const bool warp = system == System::kWarp;
  const char* text = warp ? tr("only the first {used} of {count} ends are used")
                          : tr("only the first {used} of {count} picks are used");
  r.diagnostics.add(Severity::kNote, r.line_of(warp ? "WARP" : "WEFT"), {},
                    fill(text, arg("used", used), arg("count", rows.rows())),
                    fill(tr("resize the draft to {used} to see its cloth alone"), arg("used", used)));
  return true;
}

void note_threads_without_lines(const Reader& r) {
  const Draft& draft = r.draft();
  const bool liftplan = draft.shed_control == ShedControl::kLiftplan;
  const auto note = [&r](const char* name, const BitMatrix& rows, System system) {
    const WifSection* section = r.text.find(name);
    if (note_empty_tail(r, rows, system) || section == nullptr) return;
    note_short_list(*section, rows.rows(), r.diagnostics,
                    tr("those after it are empty; add their lines, or lower Threads"));
  };
  note("THREADING", draft.threading, System::kWarp);
  note(liftplan ? "LIFTPLAN" : "TREADLING", liftplan ? draft.liftplan : draft.treadling, System::kWeft);
}

void read_notes(const Reader& r) {
  const WifSection* notes = r.text.find("NOTES");
  if (!notes) return;
  constexpr int kMaxNotes = 100000;
  int base = 1, last = -1;
  for (const WifKey& key : notes->keys) {
    if (key.number == 0) base = 0;
    if (key.number <= kMaxNotes) last = std::max(last, key.number);
  }
  if (last < base) return;
  if (base == 0) r.dialect.zero_based.push_back("NOTES");
  r.design.notes.resize(static_cast<size_t>(last - base + 1));
  each_row(*notes, last - base + 1, base, r.diagnostics,
           [&](int line, const WifKey& key) { r.design.notes[static_cast<size_t>(line)] = r.text_of(&key); });
}

void read_head(const Reader& r, WifFile* info) {
  if (!r.text.find("WIF")) {
    r.diagnostics.add(Severity::kNote, 0, {}, tr("the file does not start with [WIF]"),
                      tr("read as WIF; \"save for other programs\" writes the heading"));
  } else if (!r.wif("Version")) {
    r.diagnostics.add(Severity::kNote, r.line_of("WIF"), {}, tr("[WIF] does not give a Version"),
                      tr("read as version 1.1"));
  }
  r.design.title = r.text_of(r.text.find("TEXT", "Title"));
  r.design.author = r.text_of(r.text.find("TEXT", "Author"));
  if (!info) return;
  info->version = r.text_of(r.wif("Version"));
  info->date = r.text_of(r.wif("Date"));
  info->source_program = r.text_of(r.wif("Source Program"));
  info->source_version = r.text_of(r.wif("Source Version"));
}

bool is_usable(const WifText& text, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    diagnostics.add(Severity::kError, text.lines.empty() ? -1 : 0, {}, what, remedy);
    return false;
  };
  if (text.lines.empty()) return refuse(tr("the file is empty"), tr("choose a WIF file"));
  if (text.bytes.starts_with("\xFF\xFE") || text.bytes.starts_with("\xFE\xFF")) {
    return refuse(tr("the file is UTF-16 text"), tr("save it as UTF-8 or ASCII first"));
  }
  if (!text.too_large.empty()) return refuse(text.too_large, tr("choose a draft saved as .wif"));
  for (const char* name : {"WEAVING", "WARP", "WEFT", "THREADING"}) {
    if (text.find(name)) return true;
  }
  return refuse(tr("this is not a WIF file: it has none of [WEAVING], [WARP], [WEFT] and [THREADING]"),
                tr("choose a draft saved as .wif"));
}

}  // namespace

// check_lines.cpp
void check_lines(const WifText& text, Diagnostics& diagnostics);
void check_contents(const WifText& text, Diagnostics& diagnostics);
// read_threads.cpp
void read_threads(const WifText& text, Diagnostics& diagnostics, WifDialect& dialect, Draft& draft, WifFile* info);

std::optional<ParsedWif> parse_wif(std::string_view bytes, Diagnostics& diagnostics, WifFile* info) {
  if (bytes.size() > kMaxDraftBytes) {
    diagnostics.add(Severity::kError, -1, {}, tr("the file is larger than 256 MB"), tr("choose a WIF file"));
    return std::nullopt;
  }
  ParsedWif parsed{scan_wif(bytes), {}, {}};
  Reader r{parsed.text, diagnostics, parsed.dialect, parsed.design};
  if (!is_usable(r.text, diagnostics)) return std::nullopt;
  read_head(r, info);
  check_lines(r.text, diagnostics);
  check_contents(r.text, diagnostics);
  const int ends = read_thread_count(r, "WARP", {"THREADING", "WARP COLORS"});
  const int picks = read_thread_count(r, "WEFT", {"TREADLING", "LIFTPLAN", "WEFT COLORS"});
  Draft& draft = r.draft();
  draft.shafts = read_shaft_count(r);
  draft.treadles = read_treadle_count(r);
  if (static_cast<int64_t>(ends) * picks > kMaxCells) {
    diagnostics.add(Severity::kError, -1, {},
                    fill(tr("{ends} ends by {picks} picks"), arg("ends", ends), arg("picks", picks)),
                    fill(tr("this is more than the {most} crossings that can be opened"), arg("most", kMaxCells)));
  }
  if (diagnostics.has_error()) return std::nullopt;
  draft.warp.resize(ends);
  draft.weft.resize(picks);
  draft.threading = BitMatrix(ends, draft.shafts);
  draft.tieup = BitMatrix(draft.treadles, draft.shafts);
  draft.treadling = BitMatrix(picks, draft.treadles);
  draft.liftplan = BitMatrix(picks, draft.shafts);
  read_rising(r, info);
  read_lists(r, "THREADING", draft.threading, true);
  read_shed_control(r, info);
  note_threads_without_lines(r);
  read_threads(r.text, diagnostics, r.dialect, draft, info);
  read_notes(r);
  r.dialect.has_yarns = r.text.find(std::string(kPrivate) + "YARNS") != nullptr;
  read_private_sections(r.text, r.dialect, diagnostics, r.design);
  read_versions(r.text, diagnostics, r.design);
  return parsed;
}

WifRead read_wif(std::string_view bytes) {
  Diagnostics diagnostics;
  WifFile file;
  std::optional<ParsedWif> parsed = parse_wif(bytes, diagnostics, &file);
  if (!parsed) return rejected(diagnostics.release());
  file.bytes = std::string(bytes);
  file.design = std::move(parsed->design);
  return {std::move(file), diagnostics.release()};
}

}  // namespace weftlight::wif
