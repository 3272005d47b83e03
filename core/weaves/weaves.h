#pragma once
// Weaves by name. Each function returns a whole Design (threading, tie-up, treadling, colours, sett) of the requested
// size, the pattern repeated or cut to fill it. Sizes below 1 count as 1. Parameters that make no weave are changed to
// the nearest that do, so that a slider cannot break the draft.

#include <string>
#include <vector>

#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::weaves {

using design::Design;
using draft::Face, draft::Rgb;

struct ClothSize {
  int ends = 64, picks = 64;
};

/// A value, and for the user what could not be used as written and what was used instead; empty: all was.
template <class T>
struct Noted {
  T value;
  std::string note;
};
/// A whole draft of the requested size, with its note.
struct GeneratedWeave {
  Design design;
  std::string note;
};

/// The repeat of a draft, as shaft and treadle numbers.
struct Recipe {
  int shafts = 1;
  std::vector<int> threading;           // shaft of each end
  std::vector<std::vector<int>> tieup;  // shafts that each treadle lifts
  std::vector<int> treadling;           // treadle of each pick
};
Design make_design(const Recipe& recipe, ClothSize size);
/// A shaft for each different end of a drawdown (picks x ends), and a treadle for each different pick.
Recipe recipe_of(const draft::BitMatrix& repeat);
/// The same cloth turned by a quarter: ends become picks, and what lay on top lies below, so that a weave of two
/// shuttles is woven with one. Shafts and treadles change places.
Recipe turned(const Recipe& recipe);

/// Direction of a twill line with pick 1 at the bottom and end 1 on the left.
enum class Lean { kRight, kLeft };
/// Twill ratio: threads the warp passes over, then under, then over ... e.g. {2, 2} or {3, 2, 1, 2}.
using OverUnder = std::vector<int>;

Design plain(ClothSize size);
/// Groups of `group` ends and picks weave as one.
Design basket(int group, ClothSize size);
Design twill(const OverUnder& order, Lean lean, ClothSize size);
/// The repeat of twill(): straight draws over as many shafts as treadles.
Recipe twill_recipe(const OverUnder& order, Lean lean);
/// `step` is lowered to the next that has no common factor with `shafts`.
Design satin(int shafts, int step, Face face, ClothSize size);
/// Point threading; straight treadling gives chevrons, point treadling diamonds.
Design pointed_twill(const OverUnder& order, bool diamonds, ClothSize size);
/// Bands of `band` ends that lean right and left in turn, with a clean break between them.
Design herringbone(const OverUnder& order, int band, ClothSize size);
/// Warp threads that bind each other in a cord of steep twill lines: over (shafts + 1) / 2 picks, each end half a
/// repeat after its neighbour. An even number of shafts is raised by one. kBack: the weft makes the cords.
Design corkscrew(int shafts, Face face, Lean lean, ClothSize size);
/// Straight draws of `run` ends, each starting `advance` shafts further; woven as drawn in.
Design advancing_twill(const OverUnder& order, int run, int advance, ClothSize size);
/// The twill line steepens and flattens: up to `widest` successive ends on one shaft. `diamonds`: the draw is mirrored
/// and woven as drawn in, which makes stars.
Design undulating_twill(const OverUnder& order, int widest, bool diamonds, ClothSize size);
/// Point draw on 4 or more shafts whose floats pull the cloth into cells.
Design waffle(int shafts, ClothSize size);

/// How the blocks of overshot are woven. Star fashion follows the order of the threading; rose fashion exchanges A with
/// B, C with D and so on.
struct OvershotTreadling {
  bool rose = false;
  bool as_writ =
      false;      // tromp as writ: a pattern pick for each pair of neighbouring ends, not a number for each block
  int picks = 0;  // pattern picks in a block; 0: half of its ends, which weaves it square
};
/// Blocks of two neighbouring shafts each, on as many shafts as there are blocks, rounded up to an even number of at
/// least four, with tabby between the pattern picks. Each has `length` ends, the last of an even number being the first
/// of the next block, so that a profile that reads the same both ways gives such a threading. The pattern weft covers
/// its block, passes below the block opposite and half of the others. Weft yarn 1 is the pattern's, 0 the tabby's.
/// Based on: Mary Meigs Atwater, The Shuttle-Craft Book of American Hand-Weaving, 1928.
Design overshot(const std::vector<int>& blocks, int length, ClothSize size, OvershotTreadling treadling = {});
/// Two tie-down shafts and one shaft a block; `blocks` is the order of units of four ends.
Design summer_and_winter(const std::vector<int>& blocks, ClothSize size);
/// Two blocks of four-shaft twill, warp-faced against weft-faced with a clean cut. `blocks` is the order of
/// units of four threads, in warp and weft alike.
Design twill_damask(const std::vector<int>& blocks, ClothSize size);
/// Dark and light threads in turn; the blocks of warp and weft make lines along or across. Eight shafts, four blocks;
/// `blocks` is the order of pairs.
Design shadow_weave(const std::vector<int>& blocks, ClothSize size);
/// Plain weave, dark and light in turn, the order reversed every `block` threads.
Design log_cabin(int block, ClothSize size);
/// A twill in stripes of so many dark and as many light threads, in warp and weft alike.
Design houndstooth(const OverUnder& order, int threads, ClothSize size);
/// Checks of coarse stripes against checks of fine ones. `threads` of a stripe, `pairs` of dark and light ones.
struct GlenCheck {
  int threads = 4, pairs = 6, fine_threads = 2, fine_pairs = 12;
  int overcheck = 0;  // threads of a third colour in the middle of each coarse check
};
Design glen_check(const OverUnder& order, const GlenCheck& check, ClothSize size);

/// A run of threads of one colour.
struct Stripe {
  int color = 0, threads = 1;
};
/// Colours of the palette in stripes, repeated. An empty order leaves the system unchanged.
Design with_colors(Design design, std::vector<Rgb> palette, const std::vector<Stripe>& warp,
                   const std::vector<Stripe>& weft);
/// The marked threads of a system, repeated, in a second yarn: thicker and softer, so that it covers the ground.
Design with_pattern_yarn(Design design, draft::System system, const std::vector<bool>& marked);
/// The draft in another ground yarn. A pattern yarn stays as much thicker as it is, and as soft.
Design with_ground_yarn(Design design, const design::Yarn& yarn);
/// Spacing of finished cloth from yarn and weave (see recipe.cpp). `openness` 1 is a firm cloth; 2 has
/// twice the spacing.
Design with_sett(Design design, float openness = 1.0f);

}  // namespace weftlight::weaves
