// Any bytes: parsing never crashes, and the design survives every form of writing.

#include <cstdint>
#include <string_view>

#include "design/edits.h"
#include "draft/drawdown.h"
#include "require.h"
#include "wif/wif.h"

using weftlight::design::Design, weftlight::design::is_consistent, weftlight::design::with_liftplan,
    weftlight::design::with_purchase, weftlight::design::with_rising, weftlight::design::with_size,
    weftlight::design::with_thread_color, weftlight::design::with_thread_spacing, weftlight::design::with_threading,
    weftlight::design::with_tieup, weftlight::design::with_treadling;
using weftlight::draft::Draft, weftlight::draft::System, weftlight::draft::drawdown, weftlight::draft::is_consistent;
using weftlight::wif::WifRead, weftlight::wif::read_wif, weftlight::wif::write_new_wif, weftlight::wif::write_plain_wif,
    weftlight::wif::write_wif;

namespace {

Design read_again(const std::string& bytes, const char* what) {
  WifRead read = read_wif(bytes);
  require(read.file.has_value(), what);
  return std::move(read.file->design);
}

/// One to three edits, chosen by the input.
Design edited(Design design, uint64_t dice) {
  const auto upto = [&dice](int n) {
    dice = dice * 6364136223846793005u + 1442695040888963407u;
    return static_cast<int>((dice >> 33) % static_cast<uint64_t>(n > 0 ? n : 1));
  };
  for (int i = 0; i <= upto(3); ++i) {
    const Draft& d = design.draft;
    const int end = upto(d.ends()), pick = upto(d.picks()), shaft = upto(d.shafts), treadle = upto(d.treadles);
    switch (upto(11)) {
      case 0:
        design = with_threading(std::move(design), end, shaft, true, upto(2) == 0);
        break;
      case 1:
        design = with_tieup(std::move(design), treadle, shaft, upto(2) == 0);
        break;
      case 2:
        design = with_treadling(std::move(design), pick, treadle, upto(2) == 0);
        break;
      case 3:
        design = with_liftplan(std::move(design), pick, shaft, upto(2) == 0);
        break;
      case 4:
        design = with_thread_color(std::move(design), System::kWarp, end, upto(static_cast<int>(d.palette.size())));
        break;
      case 5:
        design = with_thread_spacing(std::move(design), System::kWeft, pick, static_cast<float>(upto(99)) / 10);
        break;
      case 6:
        design = with_size(std::move(design), d.ends() + upto(3) - 1, d.picks() + upto(3) - 1, d.shafts + upto(3) - 1,
                           d.treadles + upto(3) - 1);
        break;
      case 7:
        design.title = "T\xC3\xA4st \xE7\xB9\x94";
        break;
      case 8:
        design.notes.push_back("a\nb");
        break;
      case 9:
        design.plan.width_mm = static_cast<float>(upto(2000));
        design.plan.sleying = {upto(3), 1 + upto(3)};
        design.plan = with_purchase(std::move(design.plan), {design.yarns.front().name, 0, 0, 1});
        break;
      default:
        design = with_rising(std::move(design), upto(2) == 0);
        break;
    }
  }
  return design;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const WifRead read = read_wif(bytes);
  require(read.file.has_value() || !read.diagnostics.empty(), "a rejection has a reason");
  if (!read.file) return 0;
  const Design& design = read.file->design;
  require(is_consistent(design), "a design is consistent");
  require(write_wif(*read.file, design) == bytes, "an unedited file keeps its bytes");
  // Huge drafts are valid, but too slow to write here.
  constexpr int kMax = 600;
  const Draft& d = design.draft;
  if (d.ends() > kMax || d.picks() > kMax || d.shafts > kMax || d.treadles > kMax || d.palette.size() > kMax ||
      design.notes.size() > kMax)
    return 0;
  require(read_again(write_new_wif(design), "a new file can be read") == design, "a new file holds the design");
  const Design now = edited(design, size * 31 + (size > 9 ? data[size / 2] : 0));
  require(read_again(write_wif(*read.file, now), "an edited file can be read") == now, "an edited file holds the edit");
  const Design plain = read_again(write_plain_wif(design), "a plain file is read");
  require(drawdown(plain.draft) == drawdown(d), "a plain file keeps the cloth");
  return 0;
}
