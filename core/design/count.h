#pragma once
// Yarn counts in the units of the trade, and the diameter of a round thread of a given count.

#include <optional>
#include <string>
#include <string_view>

namespace weftlight::design {

/// Tex: grams a kilometre. Denier: grams in 9 km. Nm (metric): kilometres a kilogram. Ne (English cotton): hanks of
/// 840 yards a pound. Lea (linen): leas of 300 yards a pound.
enum class CountUnit { kTex, kDenier, kNm, kNe, kLea };

/// A count must be above 0. ISO 1144 (tex); the pound is 453.59237 g, the yard 0.9144 m.
double tex_of(double count, CountUnit unit);
double count_of(double tex, CountUnit unit);

/// A count as it is written on a label.
struct WrittenCount {
  double tex = 0;  // of the whole yarn
  int plies = 0;   // 0: not said
};
/// Reads "30 tex", "150 den", "Ne 8/2", "Nm 30/2", "16 lea". The number after the stroke is that of the plies; it is
/// the one before it where that is at most 4 and the other at least 5, as in "Nm 2/28". Ne, Nm and lea without a stroke
/// are singles. Empty if it cannot be read or lies outside 0.1 to 100,000 tex.
std::optional<WrittenCount> read_count(std::string_view text);
/// Its tex alone.
std::optional<double> tex_from_text(std::string_view text);
/// The count as a label says it: "Ne 16/2", "Nm 28/2", "16/2 lea", "150 den", "30 tex". In the `usual` unit if the
/// number has two digits at most, to within 0.05 %; else in the unit in which it has the fewest. What was typed so
/// comes back so. Denier is for filament alone, which is not sold by Ne or lea: 16.7 tex are 150 den, not 99 lea.
std::string count_text(double tex, int plies, CountUnit usual);
/// A count that is no label, in that unit: the fewest figures within half a percent.
std::string about_count_text(double tex, int plies, CountUnit unit);

/// Diameter of a round thread, mm: d = 2 sqrt(tex / (1000 pi rho phi)); rho: density of the fibre in g/cm3; phi
/// (`packing`): fraction of the thread's volume that is fibre, 0.4 (woollen) to 0.65 (hard twisted), filament 0.6
/// (Morton and Hearle, ch. 5).
double diameter_from_tex_mm(double tex, double density_g_cm3, double packing);
double tex_from_diameter(double diameter_mm, double density_g_cm3, double packing);

}  // namespace weftlight::design
