#pragma once
// The families of weaves beyond generators.h, one a file. Each tells in `why` what it could not take as written.

#include <string_view>

#include "draft/generators/table.h"

namespace weftlight::draft {

// ---- text of weavers (text.cpp)
std::string quoted(std::string_view text);
/// "2/2", "3/1/1/2", "3 1 1 2": threads over, under, over ... Empty when there is no such ratio.
OverUnder read_ratio(std::string_view text);
/// A profile: letters are blocks, a number after one its length, or the letter again and again: "A4 B2 CC".
std::vector<int> read_profile(std::string_view text);
/// Threads in sections with repeats: "1-4 3x(5 6) 8-5". Numbers from 1; 0-based in the answer. A tree of
/// sections is written as brackets in brackets.
struct SequenceRead {
  std::vector<int> threads;
  std::string why;  // what could not be read; empty: all was
};
SequenceRead read_sequence(std::string_view text, int most = kMaxShafts);
/// A run of threads of one colour each: "R8 K4 G24", "R/8 K4 G/24" (turns back at both ends, each turned once).
struct SettRead {
  std::vector<Rgb> palette;
  std::vector<Stripe> stripes;
  std::string why;
};
SettRead read_sett(std::string_view text);

// ---- simple.cpp
/// Steps that make a satin of so many shafts: neither 1 nor shafts - 1, and no factor in common.
std::vector<int> satin_steps(int shafts);
/// A straight threading and treadling, with half of the shafts tied to each treadle in turn.
Design straight_draw(int shafts, int treadles, ClothSize size);

// ---- network.cpp
/// A pattern line drawn over a network. Based on: Alice Schlein, Network Drafting: An Introduction, 1994: the
/// initial is repeated over ends and shafts; each end takes the first shaft of the network at or above the line.
/// `line`: height of the pattern line at each end, 0-based shafts; the initial's shafts are 0-based.
std::vector<int> network_threading(const std::vector<int>& initial, const std::vector<int>& line, int shafts);

// ---- substitution.cpp
/// A unit that stands for one block of a profile. Shafts 1..ties are shared by all blocks; a, b, c ... are each
/// block's own. In a pick small letters name the shafts of the blocks that it marks, capitals those of the others.
struct BlockTemplate {
  const char* id;
  const char* name;
  int ties;
  const char* warp;  // "1 a 2 a": the ends of a unit
  const char* weft;  // "1A 12 2A aA": the picks of a unit
};
std::span<const BlockTemplate> block_templates();
/// A profile draft woven by a template: `marks` (picks of the profile x its blocks) says which blocks each pick
/// weaves as pattern; empty: as drawn in.
GeneratedWeave substituted(const BlockTemplate& unit, const std::vector<int>& warp_profile,
                           const std::vector<int>& weft_profile, ClothSize size);

// ---- double_cloth.cpp
/// Two layers (woven with one shuttle, a tube), or one layer folded at a selvedge, twice as wide as the loom.
enum class DoubleCloth { kLayers, kDoubleWidth };
/// Two layers, each of 2-shaft plain weave or of a straight twill of the ratio.
Design double_cloth(DoubleCloth kind, const OverUnder& order, ClothSize size);

// ---- picture.cpp
/// Pixels, row by row from pick 1, end 1 first.
struct Pixels {
  int width = 0, height = 0;
  std::vector<Rgb> rgb;
};
struct PictureWeave {
  int colors = 2;         // 1..16 that the picture is reduced to
  int longest_float = 7;  // 1 and up, on both faces
  int shafts = 8;         // of the satins and twills that fill the regions
};
/// A drawdown as large as the picture: each of its colours a weave, the darkest the most warp-faced.
BitMatrix picture_weave(const Pixels& picture, const PictureWeave& how);
/// The same colours as a palette, dark to light, and which each pixel has.
struct Reduced {
  std::vector<Rgb> palette;
  std::vector<int> index;
};
Reduced reduced_colors(const Pixels& picture, int colors);
/// No float longer than `longest`, on either face and over the edges, for 2 and up; 1 is plain weave. Few crossings are
/// changed: of a shaded satin of 8, one in nine for floats of 5, one in five for floats of 3.
BitMatrix with_bounded_floats(BitMatrix cells, int longest);
/// A drawdown woven by a Jacquard machine: one shaft an end, the liftplan is the drawdown.
std::optional<Design> jacquard_design(const BitMatrix& cells);

}  // namespace weftlight::draft
