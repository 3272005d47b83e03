#pragma once
// WIF 1.1, lossless. Reading gives a Design and a list of diagnostics; the bytes are kept. Writing an
// edited Design changes only the lines that the edit concerns.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "draft/design.h"
#include "wif/names.h"

namespace weftlight::wif {

enum class Severity { kNote, kWarning, kError };

struct Diagnostic {
  Severity severity = Severity::kWarning;
  int line = 0;        // 1-based; 0: the file as a whole
  std::string text;    // what is wrong
  std::string remedy;  // what to do, or what was done
};

/// The unit that a file measures spacing and thickness in.
struct WifUnit {
  std::string name = "Centimeters";  // as the file says it
  double mm = 10.0;
};

/// An opened file: its bytes as they were and the design they mean.
struct WifFile {
  std::string bytes;
  Design design;
  std::string format = "wif";  // what it was read from: a wif is saved where it was, others as a new wif
  // What is read but not edited (info shows it).
  std::string source_program, source_version, version, date;
  bool rising_stated = false, has_liftplan = false, has_treadling = false, has_tieup = false;
  WifUnit warp_unit, weft_unit;
  std::vector<std::string> warp_symbols, weft_symbols;  // one a thread, empty when the file has none
};

struct WifRead {
  std::optional<WifFile> file;          // empty when the input cannot be used
  std::vector<Diagnostic> diagnostics;  // in the order of lines
};

/// Reads WIF 1.1 from bytes, leniently. Never throws; counts are capped (draft.h) before memory is taken.
WifRead read_wif(std::string_view bytes);

/// The file with `now` in place of `opened.design`. Byte-identical when they are equal. Reading the
/// result gives `now` again, as long as `now` is consistent, has at least one end, pick, shaft and
/// treadle, and its yarns are within the ranges of yarn.h.
std::string write_wif(const WifFile& opened, const Design& now);

/// A new file for a design that was never a file.
std::string write_new_wif(const Design& design);

enum class PlainShedControl { kAsIs, kLiftplan, kTreadling };
/// "Save for other programs": ASCII, CRLF, one-pass section order, no private sections, both a tie-up
/// and a liftplan.
std::string write_plain_wif(const Design& design, PlainShedControl drive = PlainShedControl::kAsIs);

}  // namespace weftlight::wif
