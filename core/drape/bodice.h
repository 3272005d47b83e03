#pragma once
// What the sewn tops share: front and back, sleeves, and how they are put on a form whose arms then come down in them.

#include <vector>

#include "drape/bodies.h"
#include "drape/garments.h"
#include "drape/names.h"

namespace weftlight::drape {

/// Front and back, sewn at shoulders and sides, in millimetres; heights are above the hem's lowest place.
struct BodiceCut {
  float length;  // hem to neck point
  float neck_half, front_dip, back_dip;
  float shoulder_half, shoulder_drop;
  float hem_half, waist_half, chest_half, across_half;
  float tail;     // how much higher the hem is at the sides
  float armhole;  // underarm to shoulder
  int shoulder_columns, neck_columns, rows;
  // As it is put on, above where it will rest.
  float put_on_height, put_on_half, put_on_depth, put_on_neck, neck_middle;
  float put_on_wave = 0;     // of what is flared, in and out
  float put_on_gathers = 0;  // of the neckline, in and out

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

struct Panel {
  Piece piece;
  std::vector<Vec2> top;  // its upper edge, a place a column: shoulder, neck, shoulder
};

struct Bodice {
  Panel front, back;
};

/// `open`: rows from the hem that are not sewn at the sides.
Bodice add_bodice(Pattern& pattern, const BodiceCut& cut, int open = 0);

/// The panels' vertices round an armhole from the underarm; the right arm's by way of the front.
std::vector<uint32_t> armhole(const Bodice& bodice, const BodiceCut& cut, bool right);

/// The neckline's vertices from the middle of the back by the left of the front to the back again.
std::vector<uint32_t> neck_ring(const Bodice& bodice, const BodiceCut& cut);

struct BandCut {
  int rows;
  float high, share;  // mm; of the neckline's length, which is gathered into it
  float firmness;
};
/// A straight band that stands on the neckline, from the middle of the back by the left; its first row is the seam.
Piece add_band(Pattern& pattern, const BodiceCut& cut, const Bodice& bodice, const BandCut& band);

struct SleeveCut {
  float length;    // of the seam under the arm, without the cuff
  float cap, end;  // height of the cap; width at the end
  int rows;
  float cuff_high = 0, cuff_round = 0;
  int cuff_rows = 0;         // 0: no cuff
  float put_on, past_elbow;  // where it ends on the arm beyond the elbow, at first and at last
  float round() const { return cuff_rows > 0 ? cuff_round : end; }
};

struct Sleeve {
  Piece cuff, sleeve;
  const Piece& lowest() const { return cuff.rows > 0 ? cuff : sleeve; }
};

/// Sewn into the armhole; its cuff first, if it has one.
Sleeve add_sleeve(Pattern& pattern, const SleeveCut& cut, const std::vector<uint32_t>& hole, bool right);

/// The arms come down in the sleeves, whose ends go with the wrists and are held there. After the pattern's unused
/// particles are dropped.
void lead_arms(Drape& drape, const SleeveCut& cut, const Sleeve& right, const Sleeve& left);

}  // namespace weftlight::drape
