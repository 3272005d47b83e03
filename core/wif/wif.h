#pragma once
// WIF 1.1, lossless. The text is kept line by line; reading gives a Design and a list of
// diagnostics; writing an edited Design changes only the lines that the edit concerns.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draft/design.h"

namespace weftlight {

enum class Severity { kNote, kWarning, kError };

struct Diagnostic {
  Severity severity = Severity::kWarning;
  int line = 0;        // 1-based; 0: the file as a whole
  std::string text;    // what is wrong
  std::string remedy;  // what to do, or what was done
};

/// One physical line: its bytes without the line end, and the line end as found.
struct WifLine {
  std::string text;
  std::string eol;  // "\r\n", "\n", "\r" or "" (last line)
};

enum class Encoding { kUtf8, kLatin1 };

/// An opened file: the lines as they were and the design they mean.
struct WifFile {
  bool bom = false;
  Encoding encoding = Encoding::kUtf8;
  std::vector<WifLine> lines;
  Design design;
  // What is read but not edited (info shows it).
  std::string source_program, source_version, version, date;
  bool rising_stated = false, has_liftplan = false, has_treadling = false, has_tieup = false;
  std::vector<std::string> warp_symbols, weft_symbols;  // one a thread, empty when the file has none
};

struct WifRead {
  std::optional<WifFile> file;           // empty when the input cannot be used
  std::vector<Diagnostic> diagnostics;   // in the order of lines
};

/// Reads WIF 1.1 from bytes, leniently. Never throws; counts are capped (draft.h) before memory is taken.
WifRead read_wif(std::string_view bytes);

/// The file with `now` in place of `opened.design`. Byte-identical when they are equal.
std::string write_wif(const WifFile& opened, const Design& now);

/// A new file for a design that was never a file.
std::string write_new_wif(const Design& design);

enum class PlainDrive { kAsIs, kLiftplan, kTreadling };
/// "Save for other programs": ASCII, CRLF, one-pass section order, no private sections, both a tie-up
/// and a liftplan.
std::string write_plain_wif(const Design& design, PlainDrive drive = PlainDrive::kAsIs);

/// File access: whole file in; out through a temporary beside it, fsync, rename. Empty string: done;
/// otherwise what went wrong.
struct FileBytes {
  std::string bytes, error;
};
FileBytes read_file(const std::string& path);
std::string write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace weftlight
