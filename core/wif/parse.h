#pragma once
// Inside of the reader: what is found out about a file beside its design, so that an edit can be
// written in the file's own terms.

#include <string>
#include <vector>

#include "wif/names.h"
#include "wif/text.h"
#include "wif/wif.h"

namespace weftlight::wif {

/// A diagnostic for each kind of finding, with the further lines it concerns, or their number. Its texts are lines of
/// UTF-8, whatever of the file they quote.
class Diagnostics {
 public:
  /// Diagnostics of the same non-empty `kind` are joined.
  void add(Severity severity, int line_index, std::string_view kind, const std::string& text,
           const std::string& remedy);
  void warn(int line_index, std::string_view kind, const std::string& text, const std::string& remedy) {
    add(Severity::kWarning, line_index, kind, text, remedy);
  }
  bool has_error() const { return error_; }
  std::vector<Diagnostic> take();

 private:
  struct Item {
    Diagnostic diagnostic;
    int more = 0;
    std::vector<int> lines;  // of those more, the first few, from 1
  };
  std::vector<Item> items_;
  NameIndex by_kind_;  // of items_
  bool error_ = false;
};

/// How one table of a thread system is kept: rows listed, or one value for all.
struct ColumnDialect {
  bool list_all = false;  // rows are in the file
  double fallback = -1;   // what a row not listed means: palette index or millimetres
};

struct SystemDialect {
  ColumnDialect color, spacing, thickness;
  WifUnit unit;
};

/// The file's own way of saying things.
struct WifDialect {
  int range_low = 0, range_high = 255;
  int palette_base = 1;        // number of the first row of [COLOR TABLE]
  int default_color_base = 1;  // of Color= in [WARP] and [WEFT] (Luminescence: 0)
  SystemDialect warp, weft;
  int treadle_base = 1;                 // number that [TREADLING] gives the first treadle
  bool has_liftplan = false;            // a liftplan is kept beside the treadling
  std::vector<std::string> zero_based;  // sections whose rows count from 0

  int base_of(std::string_view section) const;
};

struct ParsedWif {
  WifText text;
  WifDialect dialect;
  Design design;
};

/// Everything of [PRIVATE WEFTLIGHT ...], once the drive is known: yarns, thread yarns, look, scene, exact
/// values, and the grids of the drive that sleeps.
void read_private_sections(const WifText& text, const WifDialect& dialect, Diagnostics& diagnostics, Design& design);

/// Reads a file; nothing but findings when it cannot be used. `info` is given the facts for the user.
std::optional<ParsedWif> parse_wif(std::string_view bytes, Diagnostics& diagnostics, WifFile* info = nullptr);

}  // namespace weftlight::wif
