#pragma once
// Internal to the reader: what it learns of a file besides the design (its dialect), so that an edit is written in the
// same form.

#include <string>
#include <vector>

#include "wif/wif.h"
#include "wif/wif_text.h"

namespace weftlight::wif {

using design::Design;

/// Collects diagnostics, one for each kind, with the other lines that it concerns or their number. Texts are single
/// lines of UTF-8, whatever they quote from the file; they are in the user's language.
class Diagnostics {
 public:
  /// Diagnostics of the same non-empty `kind` are merged.
  void add(Severity severity, int line_index, std::string_view kind, const std::string& text,
           const std::string& remedy);
  void warn(int line_index, std::string_view kind, const std::string& text, const std::string& remedy) {
    add(Severity::kWarning, line_index, kind, text, remedy);
  }
  bool has_error() const { return error_; }
  /// All diagnostics by line; the collection is empty afterwards.
  std::vector<Diagnostic> release();

 private:
  struct Item {
    Diagnostic diagnostic;
    int more = 0;
    std::vector<int> lines;  // the first of the other lines, counted from 1
  };
  std::vector<Item> items_;
  NameIndex by_kind_;  // index into items_
  bool error_ = false;
};

/// How a file stores one table of a system: rows listed, or one value for all threads.
struct ColumnDialect {
  bool list_all = false;  // the file lists rows
  double fallback = -1;   // value of rows that are not listed: palette index or mm
};

struct SystemDialect {
  ColumnDialect color, spacing, thickness;
  WifUnit unit;
};

/// The dialect of a file: its variants of the format.
struct WifDialect {
  int range_low = 0, range_high = 255;
  int palette_base = 1;        // number of the first row of [COLOR TABLE]
  int default_color_base = 1;  // of Color= in [WARP] and [WEFT] (Luminescence: 0)
  SystemDialect warp, weft;
  int treadle_base = 1;                 // number of the first treadle in [TREADLING]
  bool has_liftplan = false;            // the file has a liftplan besides the treadling
  std::vector<std::string> zero_based;  // sections whose rows count from 0
  bool has_yarns = false;               // the file states its yarns, even if it has only the default one
  bool leaves_out_defaults = false;     // private numbers that are the default are not written

  int base_of(std::string_view section) const;
};

struct ParsedWif {
  WifText text;
  WifDialect dialect;
  Design design;
};

/// Reads the sections [PRIVATE WEFTLIGHT ...], after the shed control is known: yarns, plan, yarns of the threads,
/// look, scene, exact values, and the grid of the inactive shed control.
void read_private_sections(const WifText& text, const WifDialect& dialect, Diagnostics& diagnostics, Design& design);

/// Reads the versions of the design (versions.cpp). Those that cannot be read are left out, with a diagnostic.
void read_versions(const WifText& text, Diagnostics& diagnostics, Design& design);

/// Reads a file; empty if it cannot be used. Fills `info` with the facts that are shown to the user.
std::optional<ParsedWif> parse_wif(std::string_view bytes, Diagnostics& diagnostics, WifFile* info = nullptr);

}  // namespace weftlight::wif
