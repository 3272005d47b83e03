// The tunic: a smock, gathered into its neckband; its sleeves are gathered into cuffs.

#include "drape/bodice.h"
#include "drape/fabric_layers.h"
#include "drape/garments.h"

namespace weftlight::drape {

namespace {

constexpr BodiceCut kCut{.length = 775,
                         .neck_half = 148,
                         .front_dip = 88,
                         .back_dip = 26,
                         .shoulder_half = 266,
                         .shoulder_drop = 46,
                         .hem_half = 345,
                         .waist_half = 320,
                         .chest_half = 308,
                         .across_half = 264,
                         .tail = 0,
                         .armhole = 205,
                         .shoulder_columns = 16,
                         .neck_columns = 50,
                         .rows = 104,
                         .put_on_height = 1465,
                         .put_on_half = 212,
                         .put_on_depth = 122,
                         .put_on_neck = 86,
                         .neck_middle = -10,
                         .put_on_wave = 14,
                         .put_on_gathers = 8};
constexpr int kMiddle = kCut.last() / 2;  // a column
constexpr BandCut kBand{.rows = 6, .high = 28, .fraction = 0.88f, .firmness = 12};

constexpr SleeveCut kSleeve{.length = 444,
                            .cap = 45,
                            .end = 300,
                            .rows = 62,
                            .cuff_high = 45,
                            .cuff_round = 208,
                            .cuff_rows = 8,
                            .put_on = 265,
                            .past_elbow = 226};

constexpr float kSlit = 230, kPlacketHalf = 16;

void add_front_layers(Pattern& pattern, const Piece& front) {
  const float neck = kCut.length - kCut.front_dip;
  add_strip(pattern, front, strip_profile(-kPlacketHalf, kPlacketHalf, 4, 4, 8),
            strip_profile(neck - kSlit, neck - 0.5f, 6, 0, 7.5f), [&](float x, float v) {
              return grid_at(pattern, front, {x + kCut.hem_half, v});
            });
  for (int k = 0; k < 3; ++k) add_button(pattern, front, {kCut.hem_half, neck - 30 - 75 * static_cast<float>(k)});
}

void add_cuff_layers(Pattern& pattern, const Piece& cuff) {
  add_strip(pattern, cuff, strip_profile(0.4f, kSleeve.cuff_round - 0.4f, 5, 5, 5),
            strip_profile(0, kSleeve.cuff_high, 4, 4, 6), [&](float x, float y) {
              return grid_at(pattern, cuff, {x, y});
            });
  add_button(pattern, cuff, {11, kSleeve.cuff_high / 2});
}

void add_hem(Pattern& pattern, const Piece& panel) {
  add_strip(pattern, panel, strip_profile(0.5f, 2 * kCut.hem_half - 0.5f, 0, 0, 9), strip_profile(0.2f, 20, 0, 3.5f, 7),
            [&](float x, float v) {
              return grid_at(pattern, panel, {x, v});
            });
}

/// The layer runs all the way round, except at the middle of the back, where the band is joined.
void add_band_layer(Pattern& pattern, const Piece& band) {
  const float whole = pattern.uv_mm[band.vertex(band.columns - 1, 0)][0];
  add_strip(pattern, band, strip_profile(0.4f, whole - 0.4f, 0, 0, 6), strip_profile(0, kBand.high, 4, 4, 6),
            [&](float x, float y) {
              return grid_at(pattern, band, {x, y});
            });
}

}  // namespace

Drape tunic() {
  Drape drape;
  Pattern& pattern = drape.pattern;
  const Bodice bodice = add_bodice(pattern, kCut);
  const Sleeve right = add_sleeve(pattern, kSleeve, armhole(bodice, kCut, true), true);
  const Sleeve left = add_sleeve(pattern, kSleeve, armhole(bodice, kCut, false), false);
  for (const Piece& cuff : {right.cuff, left.cuff})
    interline(pattern, cuff, {0, cuff.columns - 1}, {0, cuff.rows - 1}, 12);
  const Piece band = add_band(pattern, kCut, bodice, kBand);
  interline(pattern, bodice.front.piece, {kMiddle - 2, kMiddle + 2}, {kCut.top() - 34, kCut.top()}, 5);
  for (const PatternPanel& panel : {bodice.front, bodice.back}) {
    interline(pattern, panel.piece, {0, kCut.last()}, {0, 3}, 2);
    add_hem(pattern, panel.piece);
  }
  add_front_layers(pattern, bodice.front.piece);
  add_band_layer(pattern, band);
  add_cuff_layers(pattern, right.cuff);
  add_cuff_layers(pattern, left.cuff);
  drop_unused_particles(pattern);
  put_on_form(drape);
  lower_arms(drape, kSleeve, right, left);
  drape.fabric.bending_n_m = 1.0e-5;
  drape.fabric.pucker = 0.02;
  drape.fabric.crease_per_mm = 0.03;
  drape.smoothing_passes = 2;
  drape.fall.seconds = 2.8;
  drape.fall.substeps = 20;
  drape.fall.rest_substeps = 60;
  drape.fall.cloth_gap_mm = 6;
  drape.fall.body_friction = 0.5;
  return drape;
}

}  // namespace weftlight::drape
