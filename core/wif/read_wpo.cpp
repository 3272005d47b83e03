// .wpo (WeavePoint): fields in a fixed order, without published specification. Integers are big-endian, masks
// little-endian.

#include <algorithm>

#include "base/text.h"
#include "wif/foreign.h"

namespace weftlight::wif {

using base::arg, base::fill, base::tr;
using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::Threads, draft::kFromYarn, draft::kMaxCells;

namespace {

constexpr int kLastVersion = 7, kFirstByteColors = 4;  // earlier versions have channels of 0..63
enum Kind : int { kLiftplanKind = 100, kSingleTreadles = 101, kManyTreadles = 102 };

/// A cursor over the bytes. Reading beyond the end gives zeros and sets `short_`.
struct Bytes {
  std::string_view bytes;
  size_t at = 0;
  bool short_ = false;

  int byte() {
    if (at >= bytes.size()) {
      short_ = true;
      return 0;
    }
    return static_cast<unsigned char>(bytes[at++]);
  }
  int number() {
    const int high = byte();
    return high * 256 + byte();
  }
  void skip(size_t count) {
    short_ |= count > bytes.size() - at;
    at = std::min(at + count, bytes.size());
  }
  std::vector<int> list() {
    const size_t length = static_cast<size_t>(number());
    std::vector<int> out;
    for (size_t i = 0; i < length && !short_; ++i) out.push_back(byte());
    return out;
  }
  /// `rows` masks of `columns` bits.
  BitMatrix masks(int rows, int columns) {
    BitMatrix out(rows, columns);
    for (int r = 0; r < rows && !short_; ++r)
      for (int first = 0; first < columns; first += 8) {
        const int mask = byte();
        for (int bit = 0; bit < 8 && first + bit < columns; ++bit)
          if (mask >> bit & 1) out.set(r, first + bit, true);
      }
    return out;
  }
};

struct Wpo {
  Bytes in;
  Diagnostics& diagnostics;
  Draft d;
  int version = 0, kind = 0;
  float spacing_mm[2] = {kFromYarn, kFromYarn};  // of ends, of picks

  bool refuse(std::string what, std::string remedy) const {
    diagnostics.add(Severity::kError, -1, {}, std::move(what), std::move(remedy));
    return false;
  }
  /// `what`: the message.
  bool truncated(const char* what) const { return refuse(what, tr("save the draft again")); }

  bool read_head() {
    if (in.byte() != 123) return refuse(tr("this is not a .wpo file"), tr("choose a .wpo file"));
    version = in.byte();
    kind = in.byte();
    if (version > kLastVersion)
      return refuse(fill(tr("version {version} of .wpo is not known"), arg("version", version)),
                    tr("save the draft as WIF in WeavePoint"));
    if (kind < kLiftplanKind || kind > kManyTreadles)
      return refuse(fill(tr("a draft of type {type} is not known"), arg("type", kind)),
                    tr("save the draft as WIF in WeavePoint"));
    in.skip(1);  // zoom
    d.shafts = in.byte();
    d.treadles = std::max(in.byte(), 1);
    in.skip(1);
    d.rising = in.byte() == 0;
    in.skip(1);
    const int ends_per_inch = in.byte(), picks_per_inch = in.byte();
    in.skip(2 + 2 + 2 + 7);  // unknown, then ends and picks of the sheet, often many more than are used
    if (in.short_) return truncated(tr("the file ends within its header"));
    if (d.shafts < 1) return refuse(tr("the draft has no shafts"), tr("choose another file"));
    spacing_mm[0] = ends_per_inch > 0 ? 25.4f / static_cast<float>(ends_per_inch) : kFromYarn;
    spacing_mm[1] = picks_per_inch > 0 ? 25.4f / static_cast<float>(picks_per_inch) : kFromYarn;
    return true;
  }

  bool read_warp(std::vector<int>& warp_colors, std::vector<int>& weft_colors) {
    const std::vector<int> threading = in.list();
    warp_colors = in.list();
    weft_colors = in.list();
    if (in.short_) return truncated(tr("the file ends within its threading"));
    if (threading.empty()) return refuse(tr("the draft has no ends"), tr("choose another file"));
    d.warp.resize(static_cast<int>(threading.size()));
    d.threading = BitMatrix(d.ends(), d.shafts);
    for (int e = 0; e < d.ends(); ++e) {
      const int shaft = threading[static_cast<size_t>(e)];
      if (shaft > d.shafts)
        diagnostics.warn(-1, "shaft",
                         fill(tr("end {end} is on shaft {shaft}, and there are {count}"), arg("end", e + 1),
                              arg("shaft", shaft), arg("count", d.shafts)),
                         tr("the end was left on no shaft"));
      else if (shaft > 0) d.threading.set(e, shaft - 1, true);
    }
    return true;
  }

  bool set_picks(int picks) {
    if (picks < 1) return refuse(tr("the draft has no picks"), tr("choose another file"));
    d.weft.resize(picks);
    return true;
  }

  bool read_liftplan() {
    if (!set_picks(in.number())) return false;
    d.shed_control = ShedControl::kLiftplan;
    d.liftplan = in.masks(d.picks(), d.shafts);
    return !in.short_ || truncated(tr("the file ends within its liftplan"));
  }

  bool read_treadles() {
    d.tieup = in.masks(d.treadles, d.shafts);
    if (in.short_) return truncated(tr("the file ends within its tie-up"));
    if (kind == kManyTreadles) {
      if (!set_picks(in.number())) return false;
      d.treadling = in.masks(d.picks(), d.treadles);
      return !in.short_ || truncated(tr("the file ends within its treadling"));
    }
    const std::vector<int> treadles = in.list();
    if (in.short_) return truncated(tr("the file ends within its treadling"));
    if (!set_picks(static_cast<int>(treadles.size()))) return false;
    d.treadling = BitMatrix(d.picks(), d.treadles);
    for (int p = 0; p < d.picks(); ++p) {
      const int treadle = treadles[static_cast<size_t>(p)];
      if (treadle > d.treadles)
        diagnostics.warn(-1, "treadle",
                         fill(tr("pick {pick} names treadle {treadle}, and there are {count}"), arg("pick", p + 1),
                              arg("treadle", treadle), arg("count", d.treadles)),
                         tr("the pick was left without a treadle"));
      else if (treadle > 0) d.treadling.set(p, treadle - 1, true);
    }
    return true;
  }

  void read_palette() {
    in.skip(66);  // translation grids
    const int colors = in.byte(), most = version >= kFirstByteColors ? 255 : 63;
    for (int i = 0; i < colors && !in.short_; ++i) {
      const int r = in.byte(), g = in.byte(), b = in.byte();
      if (!in.short_) d.palette.push_back(color_of_bytes(r, g, b, most));
    }
    if (!d.palette.empty()) return;
    diagnostics.warn(-1, {}, tr("the file has no palette"), tr("the warp is black, the weft white"));
    d.palette = {{0, 0, 0}, {1, 1, 1}};
  }

  /// `pattern`: the message for a colour that does not exist.
  void set_colors(const std::vector<int>& colors, const char* pattern, Threads& threads) {
    for (size_t i = 0; i < threads.color.size(); ++i) {
      const int color = i < colors.size() ? colors[i] : colors.empty() ? 0 : colors.front();
      const bool there = static_cast<size_t>(color) < d.palette.size();
      if (!there)
        diagnostics.warn(-1, pattern, fill(pattern, arg("number", color + 1), arg("count", d.palette.size())),
                         tr("the first was used"));
      threads.color[i] = there ? color : 0;
    }
  }

  bool read() {
    std::vector<int> warp_colors, weft_colors;
    if (!read_head() || !read_warp(warp_colors, weft_colors)) return false;
    if (!(kind == kLiftplanKind ? read_liftplan() : read_treadles())) return false;
    if (static_cast<int64_t>(d.ends()) * d.picks() > kMaxCells)
      return refuse(tr("the draft is too large"), tr("make it smaller"));
    d.tieup.resize(d.treadles, d.shafts);
    d.treadling.resize(d.picks(), d.treadles);
    d.liftplan.resize(d.picks(), d.shafts);
    read_palette();
    set_colors(warp_colors, tr("an end names colour {number}, and there are {count}"), d.warp);
    set_colors(weft_colors, tr("a pick names colour {number}, and there are {count}"), d.weft);
    std::ranges::fill(d.warp.spacing_mm, spacing_mm[0]);
    std::ranges::fill(d.weft.spacing_mm, spacing_mm[1]);
    diagnostics.add(Severity::kNote, -1, {},
                    tr("thickness and spacing of single threads are stored in an unknown form"),
                    tr("all threads have the spacing of the header; set others by hand"));
    return true;
  }
};

}  // namespace

WifRead read_wpo(std::string_view bytes) {
  Diagnostics diagnostics;
  std::optional<WifFile> file;
  Wpo wpo{{bytes.substr(0, kMaxForeignBytes)}, diagnostics, {}};
  if (wpo.read()) {
    file.emplace();
    file->design.draft = std::move(wpo.d);
    file->source_program = "WeavePoint";
  }
  return foreign_file(std::move(file), "wpo", diagnostics);
}

}  // namespace weftlight::wif
