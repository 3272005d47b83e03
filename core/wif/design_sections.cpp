#include "wif/design_sections.h"

#include <algorithm>

#include "draft/drawdown.h"
#include "wif/encoding.h"
#include "wif/numbers.h"
#include "wif/private.h"

namespace weftlight::wif {

using draft::Draft, draft::Rgb, draft::ShedControl, draft::Threads, draft::for_each_bit, draft::kFromYarn, draft::lifts;

std::string bit_list(const BitMatrix& bits, int row, int base) {
  std::string list;
  for_each_bit(bits.row(row), [&](int at) {
    if (!list.empty()) list += ',';
    list += std::to_string(at + base);
  });
  return list.empty() && base > 0 ? "0" : list;
}

namespace {

void add_rows(std::vector<WifEntries>& out, const char* name, const BitMatrix& bits, const WifDialect& dialect,
              int value_base = 1) {
  WifEntries section{name, {}};
  section.entries.reserve(static_cast<size_t>(bits.rows()));
  const int base = dialect.base_of(name);
  for (int row = 0; row < bits.rows(); ++row)
    section.entries.push_back({row + base, {}, bit_list(bits, row, value_base), false});
  out.push_back(std::move(section));
}

template <class T>
bool is_uniform(const std::vector<T>& values) {
  return std::all_of(values.begin(), values.end(), [&](const T& v) { return v == values.front(); });
}

/// Colours of a system: all rows if the file lists rows, otherwise a default and the rows that differ.
void add_colors(WifEntries& head, WifEntries& rows, const Threads& threads, const ColumnDialect& column,
                const WifDialect& dialect) {
  const bool one = !column.list_all && is_uniform(threads.color);
  const int fallback = one && threads.size() > 0 ? threads.color.front() : static_cast<int>(column.fallback);
  head.entries.push_back({-1, "Color", std::to_string(fallback + dialect.default_color_base), false});
  const int base = dialect.base_of(rows.name);
  for (int i = 0; i < threads.size(); ++i) {
    const int color = threads.color[static_cast<size_t>(i)];
    if (column.list_all || color != fallback) {
      rows.entries.push_back({i + base, {}, std::to_string(color + dialect.palette_base), false});
    }
  }
}

/// Whether a public line can hold the measure: positive, or kFromYarn.
bool is_public_measure(float mm) { return mm == kFromYarn || (mm > 0 && mm < kAny); }

std::string measure_text(float mm, double unit_mm) { return mm > 0 && mm < kAny ? in_units(mm, unit_mm) : "0"; }

/// Spacing or thickness, like the colours. 0 means kFromYarn where a default has another value.
void add_measures(WifEntries& head, WifEntries& rows, const char* key, const std::vector<float>& mm,
                  const ColumnDialect& column, double unit_mm, const WifDialect& dialect) {
  const float stated = static_cast<float>(column.fallback);
  const bool one = !column.list_all && !mm.empty() && is_uniform(mm) && is_public_measure(mm.front());
  const float fallback = one ? mm.front() : stated;
  if (fallback != kFromYarn || stated != kFromYarn)
    head.entries.push_back({-1, key, measure_text(fallback, unit_mm), false});
  const int base = dialect.base_of(rows.name);
  for (size_t i = 0; i < mm.size(); ++i) {
    if (!column.list_all && mm[i] == fallback) continue;
    if (!(mm[i] > 0 && mm[i] < kAny) && fallback == kFromYarn) continue;
    rows.entries.push_back({static_cast<int>(i) + base, {}, measure_text(mm[i], unit_mm), false});
  }
}

void add_named(WifEntries& section, const char* key, std::string value, bool is_text = false) {
  section.entries.push_back({-1, key, std::move(value), is_text});
}

/// [WARP] or [WEFT] into `head`, its tables into `tables`.
void add_system(WifEntries& head, std::vector<WifEntries>& tables, const Threads& threads, const SystemDialect& own,
                const WifDialect& dialect) {
  WifEntries colors{head.name + " COLORS", {}}, spacing{head.name + " SPACING", {}},
      thickness{head.name + " THICKNESS", {}};
  add_named(head, "Threads", std::to_string(threads.size()));
  add_colors(head, colors, threads, own.color, dialect);
  WifEntries measures{head.name, {}};
  add_measures(measures, spacing, "Spacing", threads.spacing_mm, own.spacing, own.unit.mm, dialect);
  add_measures(measures, thickness, "Thickness", threads.thickness_mm, own.thickness, own.unit.mm, dialect);
  if (!measures.entries.empty() || !spacing.entries.empty() || !thickness.entries.empty())
    add_named(head, "Units", own.unit.name);
  head.entries.insert(head.entries.end(), measures.entries.begin(), measures.entries.end());
  for (WifEntries* table : {&colors, &spacing, &thickness}) {
    if (!table->entries.empty()) tables.push_back(std::move(*table));
  }
}

WifEntries color_table(const Draft& draft, const WifDialect& dialect) {
  WifEntries table{"COLOR TABLE", {}};
  const auto number = [&](float channel) {
    return std::to_string(channel_number(channel, dialect.range_low, dialect.range_high));
  };
  for (size_t i = 0; i < draft.palette.size(); ++i) {
    const Rgb& c = draft.palette[i];
    std::string value = number(c.r);
    value.append(",").append(number(c.g)).append(",").append(number(c.b));
    table.entries.push_back({static_cast<int>(i) + dialect.palette_base, {}, std::move(value), false});
  }
  return table;
}

/// Tie-up and treadling, or the liftplan. A liftplan besides a treadling is computed from it.
void add_shed_control(std::vector<WifEntries>& out, const Draft& draft, const WifDialect& dialect) {
  const bool treadled = draft.shed_control == ShedControl::kTreadling;
  if (treadled || draft.tieup.count() > 0) add_rows(out, "TIEUP", draft.tieup, dialect);
  if (treadled) add_rows(out, "TREADLING", draft.treadling, dialect, dialect.treadle_base);
  if (!treadled) add_rows(out, "LIFTPLAN", draft.liftplan, dialect);
  if (treadled && dialect.has_liftplan) add_rows(out, "LIFTPLAN", lifts(draft), dialect);
}

WifEntries notes_of(const Design& design, const WifDialect& dialect) {
  WifEntries notes{"NOTES", {}};
  const int base = dialect.base_of("NOTES");
  for (size_t i = 0; i < design.notes.size(); ++i) {
    notes.entries.push_back({static_cast<int>(i) + base, {}, one_line(design.notes[i]), true});
  }
  return notes;
}

}  // namespace

std::vector<WifEntries> public_sections_of(const Design& design, const WifDialect& dialect) {
  const Draft& draft = design.draft;
  std::vector<WifEntries> out, tables;
  WifEntries palette{"COLOR PALETTE", {}}, text{"TEXT", {}}, weaving{"WEAVING", {}}, warp{"WARP", {}}, weft{"WEFT", {}};
  add_named(palette, "Entries", std::to_string(draft.palette.size()));
  std::string range = std::to_string(dialect.range_low);
  add_named(palette, "Range", range.append(",").append(std::to_string(dialect.range_high)));
  const std::string title = one_line(design.title), author = one_line(design.author);
  if (!title.empty()) add_named(text, "Title", title, true);
  if (!author.empty()) add_named(text, "Author", author, true);
  add_named(weaving, "Shafts", std::to_string(draft.shafts));
  add_named(weaving, "Treadles", std::to_string(draft.treadles));
  add_named(weaving, "Rising Shed", draft.rising ? "true" : "false");
  add_system(warp, tables, draft.warp, dialect.warp, dialect);
  add_system(weft, tables, draft.weft, dialect.weft, dialect);
  out.push_back(std::move(palette));
  if (!text.entries.empty()) out.push_back(std::move(text));
  for (WifEntries* head : {&weaving, &warp, &weft}) out.push_back(std::move(*head));
  out.push_back(color_table(draft, dialect));
  add_rows(out, "THREADING", draft.threading, dialect);
  add_shed_control(out, draft, dialect);
  out.insert(out.end(), std::make_move_iterator(tables.begin()), std::make_move_iterator(tables.end()));
  if (!design.notes.empty()) out.push_back(notes_of(design, dialect));
  return out;
}

std::vector<WifEntries> sections_of(const Design& design, const WifDialect& dialect) {
  std::vector<WifEntries> out = public_sections_of(design, dialect);
  append_private_sections(out, design, dialect);
  append_versions(out, design);
  return out;
}

}  // namespace weftlight::wif
