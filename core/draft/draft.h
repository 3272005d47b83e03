#pragma once
// A draft: what a weaver writes down. Threading, tie-up, treadling or liftplan, and
// the tables of threads.
//
// Orientation and index base, stated here once: indices in memory are 0-based
// everywhere; WIF's are 1-based and are converted in core/wif alone. End 0 is WIF's
// end 1, pick 0 is WIF's pick 1. In cloth space u grows with the end (along the weft),
// v grows with the pick (along the warp), both in millimetres. A face is shown with end 1 at
// the right, pick 1 at the top: in grids (there by choice mirrored), pictures, cloth, textures.

#include <string>
#include <vector>

#include "draft/bit_matrix.h"

namespace weftlight::draft {

/// Display-referred (sRGB-encoded) colour, each channel 0..1.
struct Rgb {
  float r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

enum class System { kWarp, kWeft };

/// Largest counts a draft may have; readers refuse more before memory is taken.
inline constexpr int kMaxThreads = 100000;              // ends or picks
inline constexpr int kMaxShafts = 4096;                 // shafts or treadles
inline constexpr int kMaxColors = 65536;                // palette entries
inline constexpr int64_t kMaxCells = int64_t{1} << 31;  // of any one grid

/// A spacing or thickness that the draft leaves to the yarn.
inline constexpr float kFromYarn = -1.0f;

/// The threads of one system; the four tables have one row a thread.
struct Threads {
  std::vector<int> color;           // index into Draft::palette
  std::vector<float> spacing_mm;    // centre to centre (1 / sett), or kFromYarn
  std::vector<float> thickness_mm;  // diameter, or kFromYarn
  std::vector<int> yarn;            // index into Design::yarns

  int size() const { return static_cast<int>(color.size()); }
  void resize(int n, int new_color = 0);
  bool operator==(const Threads&) const = default;
};

/// What lifts the shafts: treadles through the tie-up, or the liftplan.
enum class ShedControl { kTreadling, kLiftplan };

/// Invariants: threading is ends x shafts, tieup treadles x shafts, treadling
/// picks x treadles, liftplan picks x shafts; colour and yarn indices are in range.
struct Draft {
  int shafts = 0, treadles = 0;
  bool rising = true;  // true: the tie-up and liftplan name the shafts that rise
  ShedControl drive = ShedControl::kTreadling;
  BitMatrix threading, tieup, treadling, liftplan;
  Threads warp, weft;
  std::vector<Rgb> palette;

  int ends() const { return warp.size(); }
  int picks() const { return weft.size(); }
  const Threads& threads(System s) const { return s == System::kWarp ? warp : weft; }
  Threads& threads(System s) { return s == System::kWarp ? warp : weft; }
  bool operator==(const Draft&) const = default;
};

/// A draft of the given size with empty grids, palette black and white, warp colour 0, weft colour 1.
Draft blank_draft(int ends, int picks, int shafts, int treadles);

/// True when all the invariants above hold (used in asserts and by the fuzzers).
bool is_consistent(const Draft& draft);

}  // namespace weftlight::draft
