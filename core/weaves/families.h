#pragma once
// The families of weaves beyond weaves.h, one per file.

#include <optional>
#include <span>
#include <string_view>

#include "weaves/weaves.h"

namespace weftlight::weaves {

using design::Design;
using draft::BitMatrix, draft::Rgb, draft::kMaxShafts;

// ---- weavers' notations (text.cpp)
/// "2/2", "3/1/1/2", "3 1 1 2": threads over, under, over ... One number counts for both. Empty if it cannot be read:
/// other signs, a 0, an odd number of numbers, or more than kMaxShafts threads.
OverUnder read_ratio(std::string_view text);
/// A profile: letters are blocks, each with its length or repeated: "A4 B2 CC".
std::vector<int> read_profile(std::string_view text);
/// Threads with ranges and repeats: "1-4 3x(5 6) 8-5". Numbers count from 1 in the text, from 0 in the result. Brackets
/// may be nested.
Noted<std::vector<int>> read_sequence(std::string_view text, int most = kMaxShafts);
/// A tartan sett, runs of threads of one colour: "R8 K4 G24"; with pivots "R/8 K4 G/24" it reverses at both ends.
struct Sett {
  std::vector<Rgb> palette;
  std::vector<Stripe> stripes;
};
Noted<Sett> read_sett(std::string_view text);

// ---- draws.cpp
/// Steps that make a satin on so many shafts: neither 1 nor shafts - 1, and without a common factor.
std::vector<int> satin_steps(int shafts);
/// A straight threading and treadling, with half of the shafts tied to each treadle, shifted by one.
Design straight_draw(int shafts, int treadles, ClothSize size);

// ---- network.cpp
/// Network drafting. Based on: Alice Schlein, Network Drafting: An Introduction, 1994: the initial is repeated over
/// ends and shafts; each end takes the first shaft of this network at or above the pattern line. `line`: height of the
/// pattern line at each end; shafts are 0-based.
std::vector<int> network_threading(const std::vector<int>& initial, const std::vector<int>& line, int shafts);

// ---- substitution.cpp
/// The unit that replaces one block of a profile. Shafts 1..ties are shared by all blocks; a, b, c ... belong to each
/// block. In a pick small letters are shafts of the marked blocks, capitals those of the other blocks.
struct BlockTemplate {
  const char* id;
  const char* name;  // show tr(name)
  int ties;
  const char* warp;  // "1 a 2 a": the ends of a unit
  const char* weft;  // "1A 12 2A aA": the picks of a unit
};
std::span<const BlockTemplate> block_templates();
/// A profile draft woven with a template. Each pick weaves the block of `weft_profile` as pattern; empty: as drawn in.
GeneratedWeave substituted(const BlockTemplate& unit, const std::vector<int>& warp_profile,
                           const std::vector<int>& weft_profile, ClothSize size);

// ---- double_cloth.cpp
/// Two layers (a tube, if woven with one shuttle), or one layer of double width, folded at a selvedge.
enum class DoubleCloth { kLayers, kDoubleWidth };
/// Each layer weaves a straight twill of the ratio; {1, 1} is plain weave.
Design double_cloth(DoubleCloth kind, const OverUnder& order, ClothSize size);

// ---- picture.cpp
/// Pixels, row by row from pick 1, end 1 first.
struct Pixels {
  int width = 0, height = 0;
  std::vector<Rgb> rgb;
};
struct PictureWeave {
  int colors = 2;         // 1..16, of the reduced picture
  int longest_float = 7;  // from 1, on both faces
  int shafts = 8;         // of the satins that fill the regions
};
/// A drawdown of the size of the picture: one weave per colour, the darkest the most warp-faced.
BitMatrix picture_weave(const Pixels& picture, const PictureWeave& how);
/// The reduced colours, dark to light, and the index of each pixel's colour.
struct Reduced {
  std::vector<Rgb> palette;
  std::vector<int> index;
};
Reduced reduced_colors(const Pixels& picture, int colors);
/// Changes crossings until no float is longer than `longest`, on either face and over the edges; 1 gives plain weave.
/// In a shaded satin on 8 shafts one crossing in nine changes for floats of 5, one in five for floats of 3.
BitMatrix with_bounded_floats(BitMatrix cells, int longest);
/// A drawdown for a Jacquard machine: one shaft per end, the liftplan is the drawdown. Empty if it is too large.
std::optional<Design> jacquard_design(const BitMatrix& cells);

}  // namespace weftlight::weaves
