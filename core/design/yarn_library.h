#pragma once
// Yarns of one's own: what a weaver has on the shelf, with its colours and prices, as a plain text that can be read and
// written by hand (docs/yarns.md). A draft does not refer to it: a yarn that is used is copied into the draft.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "design/design.h"

namespace weftlight::design {

struct YarnColor {
  Rgb rgb;           // of 8 bits a channel
  std::string name;  // "Navy", "5101"; may be empty
  bool operator==(const YarnColor&) const = default;
};

struct LibraryYarn {
  Yarn yarn;
  std::string count{};                      // as it was written: "Ne 16/2"; empty: the yarn's tex alone is known
  float cone_g = 0, cone_m = 0, price = 0;  // as in YarnPurchase
  std::vector<YarnColor> colors{};
  std::string note{};                      // maker, material, where it was bought
  std::vector<std::string> other_lines{};  // of its part of the text, that say nothing to this version; kept
  bool operator==(const LibraryYarn&) const = default;
};

/// What could not be read, and what was done instead.
struct LibraryRemark {
  int line = 0;  // from 1
  std::string text;
};
struct YarnLibrary {
  std::vector<std::string> head;  // the lines before the first yarn; kept
  std::vector<LibraryYarn> yarns;
  std::vector<LibraryRemark> remarks;
};

inline constexpr size_t kMaxLibraryYarns = 10'000, kMaxYarnColors = 1'000, kMaxLibraryLine = 1'000;
inline constexpr uint64_t kMaxLibraryBytes = uint64_t{1} << 24;

/// Every line that cannot be used is a remark, and kept. An error only if it is no UTF-8, or a list of nothing but
/// other things.
base::Result<YarnLibrary> read_yarn_library(std::string_view text);
std::string yarn_library_text(const YarnLibrary& library);
/// The yarn as it is once it was written and read: texts in one line, colours of 8 bits.
LibraryYarn as_written(const LibraryYarn& yarn);

/// A yarn of the design, with how it is bought, and the colours in which threads have it; `color` of the palette if
/// there is none.
LibraryYarn library_yarn_of(const Design& design, int yarn, int color);
/// Adds the yarn in the order of the names. One of the same name and count is replaced: it keeps its colours beside the
/// new ones, and its price and note unless there are new ones.
std::vector<LibraryYarn> with_library_yarn(std::vector<LibraryYarn> yarns, LibraryYarn yarn);

/// The design with a yarn of the library, in one of its colours, and how it is bought.
struct UsedYarn {
  Design design;
  int yarn = 0, color = -1;  // where they are in the design; -1: the yarn has no such colour
};
UsedYarn with_yarn_from(Design design, const LibraryYarn& from, size_t color);

/// Whether every word of `typed` is in the name, count, fibre, note or names of colours, whatever its case.
bool matches(const LibraryYarn& yarn, std::string_view typed);

}  // namespace weftlight::design
