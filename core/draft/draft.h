#pragma once
// A draft: threading, tie-up, treadling or liftplan, and the tables of threads.
//
// Orientation and index base, stated here once: indices in memory are 0-based
// everywhere; WIF's are 1-based and are converted in core/wif alone. End 0 is WIF's
// end 1, pick 0 is WIF's pick 1. In cloth space u grows with the end (along the weft),
// v grows with the pick (along the warp), both in millimetres. A face is shown with end 1 at
// the right and pick 1 at the top: in pictures, cloth and textures, and in grids unless the user mirrors them.

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

/// Largest counts of a draft; readers reject larger ones before they allocate.
inline constexpr int kMaxThreads = 100000;              // ends or picks
inline constexpr int kMaxShafts = 4096;                 // shafts or treadles
inline constexpr int kMaxColors = 65536;                // palette entries
inline constexpr int64_t kMaxCells = int64_t{1} << 31;  // of any one grid

/// Stands for a spacing or thickness that follows from the yarn.
inline constexpr float kFromYarn = -1.0f;

/// The threads of one system; each of the four tables has one entry per thread.
struct Threads {
  std::vector<int> color;           // index into Draft::palette
  std::vector<float> spacing_mm;    // centre to centre (1 / sett), or kFromYarn
  std::vector<float> thickness_mm;  // diameter, or kFromYarn
  std::vector<int> yarn;            // index into Design::yarns

  int size() const { return static_cast<int>(color.size()); }
  void resize(int n, int new_color = 0);
  bool operator==(const Threads&) const = default;
};

/// Shed control: what lifts the shafts, treadles through the tie-up or the liftplan.
enum class ShedControl { kTreadling, kLiftplan };

/// Invariants: threading is ends x shafts, tieup treadles x shafts, treadling
/// picks x treadles, liftplan picks x shafts; colour and yarn indices are in range.
struct Draft {
  int shafts = 0, treadles = 0;
  bool rising = true;  // true: the tie-up and liftplan name the shafts that rise
  ShedControl shed_control = ShedControl::kTreadling;
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

/// True when all the invariants above hold for that many yarns (used in asserts and by the fuzzers).
bool is_consistent(const Draft& draft, size_t yarns = ~size_t{0});

}  // namespace weftlight::draft
