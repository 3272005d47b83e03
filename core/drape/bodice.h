#pragma once
// Parts of the sewn tops: front, back, neckband and sleeves, and how they are put on a dress form with raised arms,
// which are then lowered.

#include <vector>

#include "drape/bodies.h"
#include "drape/garments.h"

namespace weftlight::drape {

/// The cut of front and back, sewn at shoulders and sides. Millimetres; heights are above the lowest point of the hem.
struct BodiceCut {
  float length;  // hem to neck point
  float neck_half, front_dip, back_dip;
  float shoulder_half, shoulder_drop;
  float hem_half, waist_half, chest_half, across_half;
  float tail;     // rise of the hem at the sides
  float armhole;  // underarm to shoulder
  int shoulder_columns, neck_columns, rows;
  // The start of the simulation, higher than where the garment comes to rest.
  float put_on_height, put_on_half, put_on_depth, put_on_neck, neck_middle;
  float put_on_wave = 0;     // amplitude of the waves of a flared panel
  float put_on_gathers = 0;  // amplitude of the gathers of the neckline

  constexpr float tip() const { return length - shoulder_drop; }
  constexpr int columns() const { return 2 * shoulder_columns + neck_columns + 1; }
  constexpr int last() const { return columns() - 1; }
  constexpr int top() const { return rows - 1; }
  constexpr int underarm() const {
    return static_cast<int>((tip() - armhole - tail) / (tip() - tail) * static_cast<float>(top()));
  }
  constexpr int rise() const { return top() - underarm(); }
  float hem_at(float across) const;  // across: -1 to 1
};

struct PatternPanel {
  Piece piece;
  std::vector<Vec2> top;  // upper edge, one point per column: shoulder, neck, shoulder
};

struct Bodice {
  PatternPanel front, back;
};

/// `open`: number of rows from the hem that are not sewn at the sides.
Bodice add_bodice(Pattern& pattern, const BodiceCut& cut, int open = 0);

/// The vertices around an armhole, from the underarm; that of the right arm runs over the front first.
std::vector<uint32_t> armhole(const Bodice& bodice, const BodiceCut& cut, bool right);

/// The vertices of the neckline from the middle of the back, over the left of the front, to the back again.
std::vector<uint32_t> neck_ring(const Bodice& bodice, const BodiceCut& cut);

struct BandCut {
  int rows;
  float high, fraction;  // mm; length as a fraction of the neckline, which is gathered into it
  float firmness;
};
/// A straight band on the neckline, from the middle of the back over the left; its first row is the seam.
Piece add_band(Pattern& pattern, const BodiceCut& cut, const Bodice& bodice, const BandCut& band);

struct SleeveCut {
  float length;    // of the underarm seam, without the cuff
  float cap, end;  // height of the cap; width at the end
  int rows;
  float cuff_high = 0, cuff_round = 0;
  int cuff_rows = 0;         // 0: no cuff
  float put_on, past_elbow;  // distance of its end beyond the elbow, at the start and at the end
  float round() const { return cuff_rows > 0 ? cuff_round : end; }
};

struct Sleeve {
  Piece cuff, sleeve;
  const Piece& lowest() const { return cuff.rows > 0 ? cuff : sleeve; }
};

/// Adds the cuff, if there is one, and the sleeve, sewn into the armhole.
Sleeve add_sleeve(Pattern& pattern, const SleeveCut& cut, const std::vector<uint32_t>& hole, bool right);

/// Lowers the arms inside the sleeves, whose ends are held at the wrists. Call it after drop_unused_particles().
void lower_arms(Drape& drape, const SleeveCut& cut, const Sleeve& right, const Sleeve& left);

}  // namespace weftlight::drape
