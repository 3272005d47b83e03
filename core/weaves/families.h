#pragma once
// The families of weaves beyond weaves.h, one per file.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "weaves/notation.h"
#include "weaves/weave_values.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using design::Design;
using draft::BitMatrix, draft::Rgb, draft::kMaxShafts;

// ---- draws.cpp
/// Steps that make a satin on so many shafts: neither 1 nor shafts - 1, and without a common factor.
std::vector<int> satin_steps(int shafts);
/// A straight threading and treadling, with half of the shafts tied to each treadle, shifted by one.
Design straight_draw(int shafts, int treadles, ClothSize size);

/// A wave from 0 up to `height` and down again, in whole numbers; `way`: of the wave, 0 to 1. Halves go down while it
/// rises and up while it falls, which keeps its mean; the last bit of a cosine, another one on another system, would
/// decide otherwise.
int wave_at(double way, double height);

// ---- network.cpp
/// Network drafting. Based on: Alice Schlein, Network Drafting: An Introduction, 1994: the initial is repeated over
/// ends and shafts; each end takes the first shaft of this network at or above the pattern line. `line`: height of the
/// pattern line at each end; shafts are 0-based.
std::vector<int> network_threading(const std::vector<int>& initial, const std::vector<int>& line, int shafts);

/// A pattern line over `ends` ends, from 0 to `height` shafts; `form`: "wave", "points" or "saw".
std::vector<int> pattern_line(std::string_view form, int ends, int height);

// ---- echo.cpp
/// Parallel threadings: two warps, end by end, the second `interval` shafts above the first.
std::vector<int> parallel_threading(const std::vector<int>& line, int interval, int shafts);

// ---- substitution.cpp
/// The unit that replaces one block of a profile. Shafts 1..ties are shared by all blocks; a, b, c ... belong to each
/// block. In a pick small letters are shafts of the marked block, capitals those of the other blocks. "3(1 a)" repeats,
/// "n(1 a)" as often as the weaver chooses. "1 2|1 3": units of block A and of block B.
struct BlockTemplate {
  const char* id;
  int ties;
  const char* warp;               // "1 a 2 a": the ends of a unit
  const char* weft;               // "1A 12 2A aA": the picks of a unit
  const char* warp_colors = "0";  // of the unit's threads, repeated: 0 light, 1 dark
  const char* weft_colors = "1";  // p: dark, in the pattern yarn
  int least_blocks = 1;           // fewer make no cloth
};
/// Units that are rows of the table and templates of "substitution", too.
inline constexpr BlockTemplate kSummerAndWinterUnit{"summer_winter", 2, "1 a 2 a", "1A 12 2A aA", "0", "1 0"};
inline constexpr BlockTemplate kBronsonLaceUnit{"bronson", 2, "n(1 a) 1 2", "2aA 1 n(2A 1)"};
inline constexpr BlockTemplate kDoubleWeaveUnit{"double", 0, "a b c d", "aABD abcB cBCD acdD", "0 1 0 1", "0 1 0 1"};
constexpr BlockTemplate renamed(const char* id, BlockTemplate unit) {
  unit.id = id;
  return unit;
}
/// The templates of the weave "substitution".
std::span<const BlockTemplate> block_templates();
/// The order of the blocks in warp and weft; an empty weft is woven as drawn in.
struct Profile {
  std::vector<int> warp, weft = {};
};
/// A profile woven with a template, `n` times what its brackets repeat; `turn`: as turned().
GeneratedWeave substituted(const BlockTemplate& unit, const Profile& profile, ClothSize size, int n = 2,
                           bool turn = false);
/// By the values of a weave whose variants are `units`: kind, profile, weft_profile, size, turned.
GeneratedWeave make_units(std::span<const BlockTemplate> units, const WeaveValues& values, ClothSize size);

// ---- double_cloth.cpp
/// Layers that are separate, that are one tube, or one cloth folded at the selvedges (double width if there are two).
enum class DoubleCloth { kLayers, kTube, kDoubleWidth };
/// Each layer weaves a straight twill of the ratio; {1, 1} is plain weave. Of a tube or a folded cloth every second
/// layer is mirrored, so that the twill goes on round the fold.
Design double_cloth(DoubleCloth kind, const OverUnder& order, ClothSize size, int layers = 2);
/// Two layers, joined at `stitches` crossings of a repeat of the twill, where floats hide them best. `from_below`:
/// lower ends rise over upper picks; otherwise upper ends sink under lower picks.
Design stitched_cloth(const OverUnder& order, int stitches, bool from_below, ClothSize size);

// ---- iso_code.cpp
/// A weave as ISO 9354 codes it: "20-02 02-01-01". Based on: ISO 9354:1989, Textiles, Weaves, Coding system and
/// examples, as Neon22's iso-weaves-explorer describes it. The parts are
/// - the kind: 1 plain and its derivatives, 2 twill, 3 satin; then 0 if end 1 begins above pick 1, 1 if below;
/// - the picks that end 1 passes over and under in turn;
/// - how many neighbouring ends weave alike: of plain weaves one number or a list, each group opposite to the last;
/// - by how many picks each group rises above the one before: 00 of plain weaves; several numbers of irregular satins.
/// The repeat of the weave, picks x ends, or why the code cannot be read.
base::Result<BitMatrix> read_iso_code(std::string_view code);
/// The code of the weave whose repeat `cells` begins with; empty if there is none. Picks and ends may begin anywhere.
std::string iso_code(const BitMatrix& cells, ClothSize repeat);

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
  // The repeats of the weaver's own weaves, picks x ends, for the colours from dark to light; an empty one, and those
  // that are missing: a shaded satin by the place of the colour between dark and light.
  std::vector<BitMatrix> weaves{};
};
/// The reduced colours, dark to light, and the index of each pixel's colour.
struct Reduced {
  std::vector<Rgb> palette;
  std::vector<int> index;
};
Reduced reduced_colors(const Pixels& picture, int colors);
/// A drawdown of the size of the picture: one weave per colour, the darkest the most warp-faced.
BitMatrix picture_weave(const Pixels& picture, const PictureWeave& how);
/// The same of a picture that is reduced already; `how.colors` has no effect.
BitMatrix picture_weave(const Pixels& picture, const Reduced& reduced, const PictureWeave& how,
                        const base::TaskProgress& progress = {});
/// A repeat of a satin with so many of its ends up in each pick: 1 of 8 is weft-faced, 7 of 8 warp-faced.
BitMatrix shaded_satin(int shafts, int up);
/// A repeat, picks x ends, from words: "plain", "twill 2/1", "twill 1/3 left", "satin 8/3" (3 of 8 ends up), or a code
/// of ISO 9354; an empty matrix for "auto". Or why they name no weave.
base::Result<BitMatrix> read_weave_words(std::string_view words);
/// Changes crossings until no float is longer than `longest`, on either face and over the edges; 1 gives plain weave.
/// Asked to stop, it leaves the rest as it is. In a shaded satin on 8 shafts one crossing in nine changes for floats of
/// 5, one in five for floats of 3.
BitMatrix with_bounded_floats(BitMatrix cells, int longest, const base::TaskProgress& progress = {});
/// A drawdown for a Jacquard machine: one shaft per end, the liftplan is the drawdown. Empty if it is too large.
std::optional<Design> jacquard_design(const BitMatrix& cells);

}  // namespace weftlight::weaves
