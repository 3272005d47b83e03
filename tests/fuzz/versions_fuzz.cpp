// Any bytes as the versions of a draft: reading them never crashes and never changes the draft, and versions that were
// read are written and read as they are.

#include <cstdint>
#include <string>
#include <string_view>

#include "design/versions.h"
#include "require.h"
#include "wif/wif.h"

using weftlight::design::Design, weftlight::design::Version, weftlight::design::is_consistent,
    weftlight::design::with_version, weftlight::design::without_version;
using weftlight::draft::Draft;
using weftlight::wif::WifRead, weftlight::wif::read_wif, weftlight::wif::write_new_wif, weftlight::wif::write_wif;

namespace {

constexpr std::string_view kDraft =
    "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=2\nTreadles=2\nRising "
    "Shed=true\n[WARP]\nThreads=2\nColor=1\n[WEFT]\nThreads=2\n"
    "Color=2\n[COLOR PALETTE]\nRange=0,255\n[COLOR "
    "TABLE]\n1=0,0,0\n2=255,255,255\n[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n"
    "[TREADLING]\n1=1\n2=2\n";

bool is_small(const Design& design) {
  constexpr int kMax = 200;
  const Draft& d = design.draft;
  return d.ends() <= kMax && d.picks() <= kMax && d.shafts <= kMax && d.treadles <= kMax && d.palette.size() <= kMax;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  // Headings are short in the input: "<" begins "[PRIVATE WEFTLIGHT VERSION ".
  std::string bytes(kDraft);
  for (size_t i = 0; i < size; ++i) {
    if (data[i] == '<') bytes.append("\n[PRIVATE WEFTLIGHT VERSION ");
    else bytes.push_back(static_cast<char>(data[i]));
  }
  const WifRead read = read_wif(bytes);
  if (!read.file) return 0;
  const Design& design = read.file->design;
  require(is_consistent(design), "a design and its versions are consistent");
  require(write_wif(*read.file, design) == bytes, "an unedited file keeps its bytes");
  if (design.versions.empty() || !is_small(design)) return 0;
  for (const Version& version : design.versions)
    if (!is_small(*version.design)) return 0;
  const WifRead again = read_wif(write_new_wif(design));
  require(again.file.has_value() && again.file->design == design, "a new file holds the versions");
  Design fewer = without_version(with_version(design, "fuzz"), 0);
  const WifRead edited = read_wif(write_wif(*read.file, fewer));
  require(edited.file.has_value() && edited.file->design == fewer, "an edited file holds the versions");
  return 0;
}
