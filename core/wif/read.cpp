// Reading: from the index of lines to a Design, leniently, with findings. Rules and the habits of other
// programs: WIF 1.1 (20 April 1997) and files as they are met.

#include <algorithm>
#include <cmath>

#include "draft/drawdown.h"
#include "wif/rows.h"

namespace weftlight::wif {

int row_base(const WifSection& section, int count) {
  bool zero = false;
  for (const WifKey& key : section.keys) {
    if (key.value.empty()) continue;
    if (key.number == count) return 1;
    zero = zero || key.number == 0;
  }
  return zero ? 0 : 1;
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
  std::string words(const WifKey* key) const { return key ? to_utf8(key->value, text.encoding) : std::string{}; }
  /// [WIF], or the lines before the first header.
  const WifKey* wif(std::string_view key) const {
    const WifKey* found = text.find("WIF", key);
    return found ? found : text.find("", key);
  }
};

/// The number a key holds; warns when it holds something else.
std::optional<int> int_of(const Reader& r, const WifKey* key) {
  if (!key) return std::nullopt;
  const std::optional<int> value = leading_int(key->value);
  if (!value) {
    r.diagnostics.warn(key->line, {}, std::string(key->key) + " is not a number", "ignored; write a whole number");
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

/// Threads of [WARP] or [WEFT]; 0 after an error.
int read_thread_count(const Reader& r, const char* system, std::initializer_list<const char*> tables) {
  const WifKey* key = r.text.find(system, "Threads");
  const std::string place = std::string("[") + system + "] Threads";
  const char* what = system[1] == 'A' ? "ends" : "picks";
  int count = int_of(r, key).value_or(0);
  if (count > kMaxThreads) {
    r.diagnostics.add(Severity::kError, key->line, {}, place + " is " + std::to_string(count),
                      "at most " + std::to_string(kMaxThreads) + " can be opened; correct the count");
    return 0;
  }
  if (count <= 0) {
    count = 0;
    for (const char* table : tables) count = std::max(count, largest_key(r.text.find(table)));
    const int line = key ? key->line : r.line_of(system);
    if (count == 0) {
      r.diagnostics.add(Severity::kError, line, {}, std::string("the draft has no ") + what,
                        "give their number as Threads= in [" + std::string(system) + "]");
    } else {
      r.diagnostics.warn(line, {}, place + " is missing",
                         "taken as " + std::to_string(count) + ", the last line listed");
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
    r.diagnostics.add(Severity::kError, key->line, {}, "[WEAVING] Shafts is " + std::to_string(stated),
                      "at most " + std::to_string(kMaxShafts) + " can be opened; correct the count");
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
    r.diagnostics.warn(used_line, {},
                       "shaft " + std::to_string(used) + " is used but [WEAVING] Shafts is " + std::to_string(stated),
                       "read with " + std::to_string(used) + " shafts; correct the one or the other");
  } else if (stated <= 0) {
    r.diagnostics.warn(key ? key->line : r.line_of("WEAVING"), {}, "[WEAVING] Shafts is missing",
                       "taken as " + std::to_string(std::max(used, 1)) + ", the highest shaft used");
  }
  return std::max({stated, used, 1});
}

/// Some programs count treadles from 0, in [TIEUP] alone or in [TREADLING] too: when row 0 ties shafts.
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
  r.diagnostics.add(Severity::kNote, r.line_of("TIEUP"), {}, "[TIEUP] counts from 0", "read so; nothing to do");
}

int read_treadle_count(const Reader& r) {
  const WifKey* key = r.text.find("WEAVING", "Treadles");
  const int stated = int_of(r, key).value_or(0);
  if (stated > kMaxShafts) {
    r.diagnostics.add(Severity::kError, key->line, {}, "[WEAVING] Treadles is " + std::to_string(stated),
                      "at most " + std::to_string(kMaxShafts) + " can be opened; correct the count");
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
        line, {}, "treadle " + std::to_string(used) + " is used but [WEAVING] Treadles is " + std::to_string(stated),
        "read with " + std::to_string(used) + " treadles; correct the one or the other");
  } else if (stated <= 0 && (used > 0 || !r.text.find("LIFTPLAN"))) {
    r.diagnostics.warn(key ? key->line : r.line_of("WEAVING"), {}, "[WEAVING] Treadles is missing",
                       "taken as " + std::to_string(std::max(used, 1)) + ", the highest treadle used");
  }
  return std::max({stated, used, 1});
}

void read_rising(const Reader& r, WifFile* info) {
  const WifKey* key = r.text.find("WEAVING", "Rising Shed");
  const std::optional<bool> value = key ? word_as_bool(key->value) : std::nullopt;
  if (!value) {
    r.diagnostics.warn(key ? key->line : r.line_of("WEAVING"), {},
                       key ? "Rising Shed is neither true nor false" : "[WEAVING] does not say Rising Shed",
                       "read as rising; write Rising Shed=true, or false for a sinking shed");
  }
  r.draft().rising = value.value_or(true);
  if (info) info->rising_stated = value.has_value();
}

/// Rows of lists (threading, tie-up, treadling, liftplan) as bits.
void read_lists(Reader& r, const char* name, BitMatrix& bits, const char* what, int value_base = 1) {
  const WifSection* section = r.text.find(name);
  if (!section) return;
  const bool is_tieup = section->name == "TIEUP";  // its base is known already
  const int base = is_tieup ? r.dialect.base_of(name) : row_base(*section, bits.rows());
  if (base == 0 && !is_tieup) {
    r.dialect.zero_based.push_back(name);
    r.diagnostics.add(Severity::kNote, r.line_of(name), {}, std::string("[") + name + "] counts from 0",
                      "read so; nothing to do");
  }
  std::vector<int> list;
  each_row(*section, bits.rows(), base, r.diagnostics, [&](int row, const WifKey& key) {
    leading_ints(key.value, list);
    if (list.empty()) {
      r.diagnostics.warn(key.line, section->name + " value",
                         "[" + section->name + "] has a value that is not a list of numbers",
                         std::string("ignored; write the numbers of its ") + what);
    }
    for (const int value : list) {
      if (value >= value_base && value - value_base < bits.cols()) {
        bits.set(row, value - value_base, true);
      } else if (value != 0) {
        r.diagnostics.warn(key.line, section->name + " shaft",
                           "[" + section->name + "] names " + what + " " + std::to_string(value),
                           "ignored; there are " + std::to_string(bits.cols()));
      }
    }
  });
}

void note_differing_liftplan(const Reader& r, const BitMatrix& liftplan) {
  const BitMatrix from_treadles = lifts(r.draft());
  for (int pick = 0; pick < liftplan.rows(); ++pick) {
    if (std::ranges::equal(liftplan.row(pick), from_treadles.row(pick))) continue;
    r.diagnostics.warn(r.line_of("LIFTPLAN"), {},
                       "the liftplan differs from tie-up and treadling, first at pick " + std::to_string(pick + 1),
                       "tie-up and treadling were used; remove one of the two");
    return;
  }
}

/// Tie-up with treadling rule where they lift anything; otherwise the liftplan.
void read_drive(Reader& r, WifFile* info) {
  Draft& draft = r.draft();
  const bool has_tieup = r.text.find("TIEUP"), has_treadling = r.text.find("TREADLING");
  const bool has_liftplan = r.text.find("LIFTPLAN");
  read_lists(r, "TIEUP", draft.tieup, "shafts");
  read_lists(r, "TREADLING", draft.treadling, "treadles", r.dialect.treadle_base);
  BitMatrix liftplan(draft.picks(), draft.shafts);
  read_lists(r, "LIFTPLAN", liftplan, "shafts");
  draft.drive = ShedControl::kTreadling;
  const bool treadles_lift = has_tieup && has_treadling && lifts(draft).count() > 0;
  if (!treadles_lift && (liftplan.count() > 0 || (has_liftplan && !has_treadling)))
    draft.drive = ShedControl::kLiftplan;
  if (draft.drive == ShedControl::kLiftplan) {
    draft.treadling = BitMatrix(draft.picks(), draft.treadles);
    draft.liftplan = std::move(liftplan);
  } else {
    if (has_liftplan) note_differing_liftplan(r, liftplan);
    if (!has_liftplan && !has_treadling) {
      r.diagnostics.warn(-1, {}, "there is neither a treadling nor a liftplan",
                         "every pick is empty; add [TREADLING] or [LIFTPLAN]");
    } else if (!has_tieup) {
      r.diagnostics.warn(r.line_of("TREADLING"), {}, "there is a treadling but no tie-up",
                         "no shaft moves; add [TIEUP]");
    }
  }
  r.dialect.has_liftplan = has_liftplan;
  if (info) {
    info->has_liftplan = has_liftplan;
    info->has_treadling = has_treadling;
    info->has_tieup = has_tieup;
  }
}

/// Some programs write their largest loom around a small draft: a long tail of threads that nothing uses.
void note_empty_tail(const Reader& r, const BitMatrix& rows, const char* system, const char* what) {
  constexpr int kLong = 100, kTimes = 4;
  int used = rows.rows();
  while (used > 0 && rows.first(used - 1) < 0) --used;
  if (used == 0 || rows.rows() < kLong || rows.rows() < used * kTimes) return;
  r.diagnostics.add(
      Severity::kNote, r.line_of(system), {},
      "only the first " + std::to_string(used) + " of " + std::to_string(rows.rows()) + " " + what + " are used",
      "resize the draft to " + std::to_string(used) + " to see its cloth alone");
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
           [&](int line, const WifKey& key) { r.design.notes[static_cast<size_t>(line)] = r.words(&key); });
}

void read_head(const Reader& r, WifFile* info) {
  if (!r.text.find("WIF")) {
    r.diagnostics.add(Severity::kNote, 0, {}, "the file does not start with [WIF]",
                      "read as WIF; \"save for other programs\" writes the heading");
  } else if (!r.wif("Version")) {
    r.diagnostics.add(Severity::kNote, r.line_of("WIF"), {}, "[WIF] does not give a Version", "read as version 1.1");
  }
  r.design.title = r.words(r.text.find("TEXT", "Title"));
  r.design.author = r.words(r.text.find("TEXT", "Author"));
  if (!info) return;
  info->version = r.words(r.wif("Version"));
  info->date = r.words(r.wif("Date"));
  info->source_program = r.words(r.wif("Source Program"));
  info->source_version = r.words(r.wif("Source Version"));
}

bool is_usable(const WifText& text, Diagnostics& diagnostics) {
  const auto refuse = [&](std::string what, std::string remedy) {
    diagnostics.add(Severity::kError, text.lines.empty() ? -1 : 0, {}, std::move(what), std::move(remedy));
    return false;
  };
  if (text.lines.empty()) return refuse("the file is empty", "choose a WIF file");
  if (text.bytes.starts_with("\xFF\xFE") || text.bytes.starts_with("\xFE\xFF")) {
    return refuse("the file is UTF-16 text", "save it as UTF-8 or ASCII first");
  }
  if (!text.refused.empty()) return refuse("the file has " + text.refused, "choose a draft saved as .wif");
  for (const char* name : {"WEAVING", "WARP", "WEFT", "THREADING"}) {
    if (text.find(name)) return true;
  }
  return refuse("this is not a WIF file: it has none of [WEAVING], [WARP], [WEFT] and [THREADING]",
                "choose a draft saved as .wif");
}

}  // namespace

// What is odd about the lines themselves: check_lines.cpp.
void check_lines(const WifText& text, Diagnostics& diagnostics);
void check_contents(const WifText& text, Diagnostics& diagnostics);
// Colours and measures of the threads: read_threads.cpp.
void read_threads(const WifText& text, Diagnostics& diagnostics, WifDialect& dialect, Draft& draft, WifFile* info);

std::optional<ParsedWif> parse_wif(std::string_view bytes, Diagnostics& diagnostics, WifFile* info) {
  constexpr size_t kMaxBytes = size_t{1} << 28;
  if (bytes.size() > kMaxBytes) {
    diagnostics.add(Severity::kError, -1, {}, "the file is larger than 256 MB", "choose a WIF file");
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
    diagnostics.add(Severity::kError, -1, {}, std::to_string(ends) + " ends by " + std::to_string(picks) + " picks",
                    "this is more than the " + std::to_string(kMaxCells) + " crossings that can be opened");
  }
  if (diagnostics.has_error()) return std::nullopt;
  draft.warp.resize(ends);
  draft.weft.resize(picks);
  draft.threading = BitMatrix(ends, draft.shafts);
  draft.tieup = BitMatrix(draft.treadles, draft.shafts);
  draft.treadling = BitMatrix(picks, draft.treadles);
  draft.liftplan = BitMatrix(picks, draft.shafts);
  read_rising(r, info);
  read_lists(r, "THREADING", draft.threading, "shafts");
  read_drive(r, info);
  note_empty_tail(r, draft.threading, "WARP", "ends");
  note_empty_tail(r, draft.drive == ShedControl::kLiftplan ? draft.liftplan : draft.treadling, "WEFT", "picks");
  read_threads(r.text, diagnostics, r.dialect, draft, info);
  read_notes(r);
  read_private_sections(r.text, r.dialect, diagnostics, r.design);
  return parsed;
}

WifRead read_wif(std::string_view bytes) {
  Diagnostics diagnostics;
  WifRead result;
  WifFile file;
  if (std::optional<ParsedWif> parsed = parse_wif(bytes, diagnostics, &file)) {
    file.bytes = std::string(bytes);
    file.design = std::move(parsed->design);
    result.file = std::move(file);
  }
  result.diagnostics = diagnostics.take();
  return result;
}

}  // namespace weftlight::wif
