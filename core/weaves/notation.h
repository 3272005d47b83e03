#pragma once
// How weavers write ratios, profiles, sequences and setts.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weaves/weaves.h"

namespace weftlight::weaves {

using draft::Rgb, draft::kMaxShafts;

/// "2/2", "3/1/1/2", "3 1 1 2": threads over, under, over ... One number counts for both. Empty if it cannot be read:
/// other signs, a 0, an odd number of numbers, or more than kMaxShafts threads.
OverUnder read_ratio(std::string_view text);
/// A profile: letters are blocks, each with its length or repeated: "A4 B2 CC". Counts may stand before or behind, also
/// of brackets, which may be nested: "3x(A B) C", "(C D)*3 A 4x".
Noted<std::vector<int>> read_profile(std::string_view text);
/// Threads with ranges and repeats: "1-4 3x(5 6) 8-5", "4x1 2x2". Numbers count from 1 in the text, from 0 in the
/// result. Brackets may be nested.
Noted<std::vector<int>> read_sequence(std::string_view text, int most = kMaxShafts);
/// One repeat of the numbers, which count from 0, as text that read_sequence gives back: "4x1 2x2". The last repeat may
/// have been cut.
std::string sequence_text(std::span<const int> threads);
/// A tartan sett, runs of threads of one colour: "R8 K4 G24"; with pivots "R/8 K4 G/24" it reverses at both ends.
/// Between dots, "...R8 K4 G24..." or with the sign for them, it repeats as it is written, as the Scottish Register of
/// Tartans gives a full sett.
struct Sett {
  std::vector<Rgb> palette;
  std::vector<Stripe> stripes;
};
Noted<Sett> read_sett(std::string_view text);

}  // namespace weftlight::weaves
