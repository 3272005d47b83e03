#pragma once
// The plan of a cloth: how large it shall be, and how it goes onto the loom. Kept with the draft. What follows from it
// (ends, widths, yarn) is computed in core/analysis: measures.h, reeds.h, warping.h, yarn_need.h.

#include <string>
#include <string_view>
#include <vector>

namespace weftlight::design {

/// A reed by the number on its end: dents in 10 cm, or in an inch.
struct Reed {
  float dents = 0;  // 0: none chosen
  bool per_inch = false;
  bool operator==(const Reed&) const = default;
};

/// How a yarn is bought: in cones or skeins of a weight or a length, or by the kilogram if neither is known. It
/// belongs to the yarns of that name.
struct YarnPurchase {
  std::string yarn;
  float cone_g = 0, cone_m = 0;  // of a cone or skein; 0: not known. The length rules if both are known
  float price = 0;               // of a cone or skein, or of a kilogram; 0: not known
  bool operator==(const YarnPurchase&) const = default;
};

/// Lengths in mm, of the finished cloth unless said otherwise. Shrinkage, take-up and spare are fractions (0.1: 10%).
/// Take-up is how much longer a thread is than the cloth that it is woven into, on the loom: that of the weft is the
/// draw-in, since a pick is as long as the reed is wide. Shrinkage is the fraction that the woven cloth loses off the
/// loom and in washing.
struct ClothPlan {
  float width_mm = 0, length_mm = 0;  // 0: as drafted
  int pieces = 1;                     // of that length, one after the other on one warp
  float fringe_mm = 0;                // warp left unwoven for each piece
  float loom_waste_mm = 600;          // warp that cannot be woven (thrums)
  float warp_take_up = 0.08f, weft_take_up = 0.06f;
  float warp_shrinkage = 0.08f, weft_shrinkage = 0.08f;
  float spare = 0.05f;  // yarn lost in winding and in shuttles
  // Threads in a cm on the loom; 0: what becomes the draft's sett in the finished cloth. A reed decides the warp's.
  float ends_per_cm = 0, picks_per_cm = 0;
  Reed reed;
  std::vector<int> sleying{1};          // ends in each dent, repeated over the reed
  bool floating_selvedges = false;      // an end beside each edge, through no heddle
  float bout_mm = 100, raddle_mm = 10;  // width of a bout, and of a group in the raddle
  std::vector<YarnPurchase> purchases;  // by name, each once; others are not known
  bool operator==(const ClothPlan&) const = default;
};

inline constexpr float kMaxClothMm = 1e7f;  // 10 km
inline constexpr float kMaxSettPerCm = 400, kMaxDents = 400;
inline constexpr float kMaxTakeUp = 2, kMaxShrinkage = 0.9f, kMaxSpare = 1;
inline constexpr float kMaxCone = 1e6f, kMaxPrice = 1e6f;  // g or m; in any currency
inline constexpr int kMaxPieces = 10'000, kMaxSleyingDents = 24, kMaxEndsPerDent = 24;

/// Whether a cloth shrinks by the same fractions in washing.
bool same_shrinkage(const ClothPlan& a, const ClothPlan& b);

/// Every number within its limits; NaN becomes the default. No purchase without a figure.
ClothPlan clamped(ClothPlan plan);

/// "1-1-2"; "2" is two ends in every dent.
std::string sleying_text(const std::vector<int>& sleying);
/// Reads it, with -, blanks or commas between the numbers. Empty if it is no sleying: up to kMaxSleyingDents dents, at
/// least one of them with an end.
std::vector<int> sleying_from_text(std::string_view text);
/// Ends in a dent, on average.
double ends_per_dent(const std::vector<int>& sleying);

/// How the yarn of that name is bought; its figures are 0 where that is not known.
YarnPurchase purchase_of(const ClothPlan& plan, std::string_view yarn);
/// Replaces what is known of that yarn. Without a figure it is forgotten.
ClothPlan with_purchase(ClothPlan plan, YarnPurchase purchase);

}  // namespace weftlight::design
