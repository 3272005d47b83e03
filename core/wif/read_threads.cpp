// Reading the tables of threads: palette, colours, spacing, thickness, zooms and symbols.

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "wif/foreign.h"
#include "wif/section_rows.h"

namespace weftlight::wif {

using base::arg, base::fill, base::tr;
using draft::Draft, draft::Rgb, draft::System, draft::Threads, draft::kFromYarn, draft::kMaxColors;

namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kDecipointsPerInch = 720.0;  // by convention; WIF does not define it

struct Context {
  const WifText& text;
  Diagnostics& diagnostics;
  WifDialect& dialect;
  Draft& draft;
};

int base_of_rows(Context& c, const WifSection& section, int count) {
  const int base = row_base(section, count);
  if (base == 0) c.dialect.zero_based.push_back(section.name);
  return base;
}

bool is_luminescence(const WifText& text) {
  for (const char* section : {"WIF", ""}) {
    for (const char* name : {"Source Program", "Developers"}) {
      const WifKey* key = text.find(section, name);
      if (!key) continue;
      const std::string value = uppercase(key->value);
      if (value.find("LUMINESCENCE") != std::string::npos || value.find("GLASSNER") != std::string::npos) return true;
    }
  }
  return false;
}

void read_range(Context& c, int largest_channel) {
  const WifKey* key = c.text.find("COLOR PALETTE", "Range");
  std::vector<int> list;
  if (key) leading_ints(key->value, list);
  if (list.size() >= 2 && list[0] >= 0 && list[1] > list[0]) {
    c.dialect.range_low = list[0];
    c.dialect.range_high = list[1];
    return;
  }
  c.dialect.range_high = largest_channel <= 255 ? 255 : largest_channel <= 999 ? 999 : std::max(65535, largest_channel);
  c.diagnostics.warn(
      key ? key->line : -1, {}, tr("[COLOR PALETTE] gives no usable Range"),
      fill(tr("colours were read as 0,{high}; write Range= as two numbers"), arg("high", c.dialect.range_high)));
}

/// "[WARP SPACING] 3=".
std::string place_of(std::string_view section, const WifKey& key) {
  return fill("[{section}] {key}=", arg("section", section), arg("key", key.key));
}

/// `section`, `key`: where the colour stands.
Rgb color_of(Context& c, const int* channel, const char* section, const WifKey& key) {
  const double low = c.dialect.range_low, high = c.dialect.range_high;
  float out[3];
  for (int i = 0; i < 3; ++i) {
    if (channel[i] < low || channel[i] > high) {
      c.diagnostics.warn(
          key.line, "channel",
          fill(tr("{place}: {value} is outside Range"), arg("place", place_of(section, key)), arg("value", channel[i])),
          tr("the nearest colour within Range was used"));
    }
    out[i] = static_cast<float>((std::clamp<double>(channel[i], low, high) - low) / (high - low));
  }
  return {out[0], out[1], out[2]};
}

/// False if the file has no colour table.
bool read_palette(Context& c) {
  const WifSection* table = c.text.find("COLOR TABLE");
  int base = 1, last = -1, largest_channel = 0;
  std::vector<int> list;
  if (table) {
    for (const WifKey& key : table->keys) {
      if (key.value.empty() || key.number < 0 || key.number > kMaxColors - 1) continue;
      if (key.number == 0) base = 0;
      last = std::max(last, key.number);
      leading_ints(key.value, list);
      for (const int channel : list) largest_channel = std::max(largest_channel, channel);
    }
  }
  if (last < base) return false;
  c.dialect.palette_base = base;
  if (base == 0) c.dialect.zero_based.push_back("COLOR TABLE");
  read_range(c, largest_channel);
  c.draft.palette.assign(static_cast<size_t>(last - base + 1), Rgb{});
  each_row(*table, last - base + 1, base, c.diagnostics, [&](int index, const WifKey& key) {
    leading_ints(key.value, list);
    if (list.size() < 3) {
      c.diagnostics.warn(key.line, "rgb",
                         fill(tr("{place}: {value} has fewer than three numbers"),
                              arg("place", place_of("COLOR TABLE", key)), arg("value", short_quote(key.value))),
                         tr("read as black; write red,green,blue"));
      return;
    }
    c.draft.palette[static_cast<size_t>(index)] = color_of(c, list.data(), "COLOR TABLE", key);
  });
  return true;
}

/// Color=index,R,G,B of a two-colour draft without a colour table.
std::optional<Rgb> stated_rgb(Context& c, const char* system) {
  const WifKey* key = c.text.find(system, "Color");
  if (!key) return std::nullopt;
  std::vector<int> list;
  leading_ints(key->value, list);
  if (list.size() < 4) return std::nullopt;
  const WifKey* range = c.text.find("COLOR PALETTE", "Range");
  if (!range) read_range(c, *std::max_element(list.begin() + 1, list.end()));
  return color_of(c, list.data() + 1, system, *key);
}

void default_palette(Context& c) {
  const WifKey* range = c.text.find("COLOR PALETTE", "Range");
  if (range) read_range(c, 255);
  c.draft.palette = {stated_rgb(c, "WARP").value_or(Rgb{0, 0, 0}), stated_rgb(c, "WEFT").value_or(Rgb{1, 1, 1})};
  std::fill(c.draft.weft.color.begin(), c.draft.weft.color.end(), 1);
  c.dialect.warp.color.fallback = 0;
  c.dialect.weft.color.fallback = 1;
  c.diagnostics.add(Severity::kNote, -1, {}, tr("there is no color table"),
                    tr("warp and weft were given a colour each; change them as you like"));
}

int color_index(Context& c, int number, int base, std::string_view section, const WifKey& key) {
  const int count = static_cast<int>(c.draft.palette.size());
  const int index = std::clamp(number, base, base + count - 1) - base;
  if (index != number - base) {
    c.diagnostics.warn(key.line, "color index",
                       fill(tr("{place}: color {number} is not in the color table"),
                            arg("place", place_of(section, key)), arg("number", number)),
                       fill(tr("color {number} was used; correct one of them"), arg("number", index + base)));
  }
  return index;
}

void read_colors(Context& c, const char* system, Threads& threads, ColumnDialect& column, int implied) {
  const WifKey* key = c.text.find(system, "Color");
  const std::optional<int> stated = key ? leading_int(key->value) : std::nullopt;
  const int fallback = stated ? color_index(c, *stated, c.dialect.default_color_base, system, *key)
                              : std::min(implied, static_cast<int>(c.draft.palette.size()) - 1);
  std::fill(threads.color.begin(), threads.color.end(), fallback);
  column.fallback = fallback;
  const WifSection* rows = c.text.find(std::string(system) + " COLORS");
  if (!rows) return;
  column.list_all = true;
  each_row(
      *rows, threads.size(), base_of_rows(c, *rows, threads.size()), c.diagnostics, [&](int thread, const WifKey& row) {
        if (const std::optional<int> number = leading_int(row.value)) {
          threads.color[static_cast<size_t>(thread)] = color_index(c, *number, c.dialect.palette_base, rows->name, row);
        }
      });
  // With Color=, a list may name the exceptions alone.
  if (!stated)
    note_short_list(*rows, threads.size(), c.diagnostics,
                    fill(tr("those after it were given color {number}; add their lines, or Color= in [{section}]"),
                         arg("number", fallback + c.dialect.palette_base), arg("section", system)));
}

void read_units(Context& c, const char* system, SystemDialect& dialect) {
  const WifKey* key = c.text.find(system, "Units");
  if (!key) {
    for (const char* name : {"Spacing", "Thickness"}) {
      if (const WifKey* measure = c.text.find(system, name)) {
        c.diagnostics.warn(measure->line, {}, fill(tr("[{section}] gives no Units"), arg("section", system)),
                           tr("read as centimeters; write Units="));
        return;
      }
    }
    return;
  }
  size_t size = 0;
  while (size < key->value.size() && !is_blank(key->value[size]) && key->value[size] != ';') ++size;
  const std::string unit = uppercase(key->value.substr(0, size));
  dialect.unit.name = to_utf8(key->value.substr(0, size), c.text.encoding);
  if (unit == "INCHES" || unit == "INCH" || unit == "ENGLISH") {
    dialect.unit.mm = kMmPerInch;
  } else if (unit == "DECIPOINTS" || unit == "DECIPOINT") {
    dialect.unit.mm = kMmPerInch / kDecipointsPerInch;
  } else if (unit != "CENTIMETERS" && unit != "CENTIMETER" && unit != "CENTIMETRES" && unit != "CM") {
    c.diagnostics.warn(key->line, {}, tr("Units is neither Inches, Centimeters nor Decipoints"),
                       tr("read as centimeters"));
  }
  if (unit == "ENGLISH") {
    c.diagnostics.add(Severity::kNote, key->line, {},
                      fill(tr("Units={unit} is not a unit of WIF"), arg("unit", dialect.unit.name)),
                      tr("read as inches"));
  }
}

/// A measure in mm; kFromYarn for 0, empty if it cannot be read.
std::optional<float> measure(Context& c, std::string_view section, const WifKey& key, double unit_mm) {
  bool comma = false;
  const std::optional<double> value = leading_real(key.value, &comma);
  if (comma)
    c.diagnostics.warn(key.line, "comma",
                       fill(tr("{place}: {value} has a decimal comma"), arg("place", place_of(section, key)),
                            arg("value", short_quote(key.value))),
                       tr("read as a point; write a point"));
  const float mm = static_cast<float>(value.value_or(-1) * unit_mm);
  if (!value || *value < 0 || !std::isfinite(mm)) {
    c.diagnostics.warn(key.line, "measure",
                       fill(tr("{place}: {value} is not a usable number"), arg("place", place_of(section, key)),
                            arg("value", short_quote(key.value))),
                       tr("ignored; write a number of 0 or more"));
    return std::nullopt;
  }
  return mm > 0 ? mm : kFromYarn;
}

/// Spacing or thickness: a row's own measure, otherwise that of the system times the zoom of the row or of the system.
void read_measures(Context& c, const std::string& system, const std::string& name, std::vector<float>& out,
                   ColumnDialect& column, double unit_mm) {
  const WifKey* stated = c.text.find(system, name);
  const float base = stated ? measure(c, system, *stated, unit_mm).value_or(kFromYarn) : kFromYarn;
  const WifKey* zoom_key = c.text.find(system, name + " Zoom");
  const int zoom = zoom_key ? leading_int(zoom_key->value).value_or(1) : 1;
  const auto zoomed = [base](int times) { return base > 0 && times > 0 ? base * static_cast<float>(times) : base; };
  const int count = static_cast<int>(out.size());
  std::fill(out.begin(), out.end(), zoomed(zoom));
  column.fallback = static_cast<double>(zoomed(zoom));
  const std::string table = system + " " + uppercase(name);
  if (const WifSection* rows = c.text.find(table + " ZOOM")) {
    column.list_all = true;
    each_row(*rows, count, row_base(*rows, count), c.diagnostics, [&](int thread, const WifKey& row) {
      if (const std::optional<int> times = leading_int(row.value)) out[static_cast<size_t>(thread)] = zoomed(*times);
    });
  }
  column.list_all = column.list_all || zoom > 1;
  if (const WifSection* rows = c.text.find(table)) {
    column.list_all = true;
    each_row(*rows, count, base_of_rows(c, *rows, count), c.diagnostics, [&](int thread, const WifKey& row) {
      if (const std::optional<float> mm = measure(c, table, row, unit_mm)) out[static_cast<size_t>(thread)] = *mm;
    });
  }
}

/// The character of a WIF symbol, written as X, 'X' or #88.
std::string symbol_of(std::string_view value, Encoding encoding) {
  if (value.size() >= 3 && value.front() == '\'') return to_utf8(value.substr(1, value.find('\'', 2) - 1), encoding);
  if (value.size() >= 2 && value.front() == '#') {
    const int code = leading_int(value.substr(1)).value_or(-1);
    if (code >= 0 && code <= 255) {
      const char byte = static_cast<char>(code);
      return to_utf8(std::string_view(&byte, 1), Encoding::kLatin1);
    }
  }
  if (encoding == Encoding::kLatin1 || static_cast<unsigned char>(value.front()) < 0x80) {
    return to_utf8(value.substr(0, 1), encoding);
  }
  size_t size = 1;
  while (size < value.size() && (static_cast<unsigned char>(value[size]) & 0xC0) == 0x80) ++size;
  return std::string(value.substr(0, size));
}

std::vector<std::string> read_symbols(Context& c, const std::string& system, int count) {
  constexpr int kMaxSymbols = 65536;
  const WifSection* table = c.text.find(system + " SYMBOL TABLE");
  const WifSection* rows = c.text.find(system + " SYMBOLS");
  const WifKey* stated = c.text.find(system, "Symbol");
  const WifKey* number = c.text.find(system, "Symbol Number");
  if (!rows && !stated && !number) return {};
  std::vector<std::string> symbols(1);
  if (table) {
    for (const WifKey& key : table->keys) {
      if (key.value.empty() || key.number < 1 || key.number > kMaxSymbols) continue;
      symbols.resize(std::max(symbols.size(), static_cast<size_t>(key.number) + 1));
      symbols[static_cast<size_t>(key.number)] = symbol_of(key.value, c.text.encoding);
    }
  }
  const auto at = [&](int index) {
    return index >= 0 && index < static_cast<int>(symbols.size()) ? symbols[static_cast<size_t>(index)] : std::string{};
  };
  std::string fallback = stated ? symbol_of(stated->value, c.text.encoding) : std::string{};
  if (number) fallback = at(leading_int(number->value).value_or(0));
  std::vector<std::string> result(static_cast<size_t>(count), fallback);
  if (rows) {
    each_row(*rows, count, row_base(*rows, count), c.diagnostics, [&](int thread, const WifKey& row) {
      result[static_cast<size_t>(thread)] = at(leading_int(row.value).value_or(0));
    });
  }
  return result;
}

}  // namespace

void read_threads(const WifText& text, Diagnostics& diagnostics, WifDialect& dialect, Draft& draft, WifFile* info) {
  Context c{text, diagnostics, dialect, draft};
  if (is_luminescence(text)) dialect.default_color_base = 0;
  if (read_palette(c)) {
    read_colors(c, "WARP", draft.warp, dialect.warp.color, 0);
    read_colors(c, "WEFT", draft.weft, dialect.weft.color, 1);
  } else {
    default_palette(c);
  }
  for (const System system : {System::kWarp, System::kWeft}) {
    const char* name = system == System::kWarp ? "WARP" : "WEFT";
    SystemDialect& own = system == System::kWarp ? dialect.warp : dialect.weft;
    Threads& threads = draft.threads(system);
    read_units(c, name, own);
    read_measures(c, name, "Spacing", threads.spacing_mm, own.spacing, own.unit.mm);
    read_measures(c, name, "Thickness", threads.thickness_mm, own.thickness, own.unit.mm);
    if (!info) continue;
    (system == System::kWarp ? info->warp_unit : info->weft_unit) = own.unit;
    (system == System::kWarp ? info->warp_symbols : info->weft_symbols) = read_symbols(c, name, threads.size());
  }
}

}  // namespace weftlight::wif
