#pragma once
// WIF 1.1, lossless. Reading returns a Design and diagnostics, and keeps the bytes. Writing an edited Design changes
// only the lines that the edit concerns.

#include <string>
#include <string_view>
#include <vector>

#include "base/whole_files.h"
#include "design/design.h"

namespace weftlight::wif {

using design::Design;

/// Limit of a draft's file.
inline constexpr uint64_t kMaxDraftBytes = uint64_t{1} << 28;

enum class Severity { kNote, kWarning, kError };

struct Diagnostic {
  Severity severity = Severity::kWarning;
  int line = 0;        // 1-based; 0: the file as a whole
  std::string text;    // what is wrong; both in the user's language
  std::string remedy;  // what to do, or what was done
};

/// The unit of spacing and thickness in a file.
struct WifUnit {
  std::string name = "Centimeters";  // as written in the file
  double mm = 10.0;
};

/// An opened file: its original bytes and their design.
struct WifFile {
  std::string bytes;
  Design design;
  std::string format = "wif";  // "wif", "dtx" or "wpo"; only a wif is saved to its own path
  // Read but not edited; shown by `info`.
  std::string source_program, source_version, version, date;
  bool rising_stated = false, has_liftplan = false, has_treadling = false, has_tieup = false;
  WifUnit warp_unit, weft_unit;
  std::vector<std::string> warp_symbols, weft_symbols;  // one per thread; empty if the file has none
};

struct WifRead {
  base::Result<WifFile> file;           // or, if the input cannot be used, its first diagnostic of kError
  std::vector<Diagnostic> diagnostics;  // by line
};

/// What a reader gives for an input that cannot be used.
WifRead rejected(std::vector<Diagnostic> diagnostics);

/// Reads WIF 1.1 leniently. Never throws; counts are limited (draft.h) before memory is allocated.
WifRead read_wif(std::string_view bytes);

/// The file with `now` instead of `opened.design`; byte-identical if they are equal. Reading the result gives `now`
/// again if `now` is consistent, has at least one end, pick, shaft and treadle, and its yarns are within their ranges.
std::string write_wif(const WifFile& opened, const Design& now);

/// A new file. It states every number of its yarns, so that its cloth stays if a later version has other defaults.
std::string write_new_wif(const Design& design);
/// A new file for presets/, which leaves out the numbers of yarns, look and scene that are the default and so follows
/// it. Not for a user's cloth.
std::string write_preset_wif(const Design& design);

enum class PlainShedControl { kAsIs, kLiftplan, kTreadling };
/// "Save for other programs": ASCII, CRLF, one-pass section order, no private sections, both a tie-up
/// and a liftplan.
std::string write_plain_wif(const Design& design, PlainShedControl shed_control = PlainShedControl::kAsIs);

}  // namespace weftlight::wif
