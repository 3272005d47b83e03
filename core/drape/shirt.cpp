// The shirt: bodice, sleeves with cuffs, a collar stand, a collar that falls over it, and second layers.

#include "drape/bodice.h"
#include "drape/fabric_layers.h"
#include "drape/garments.h"

namespace weftlight::drape {

namespace {

constexpr BodiceCut kCut{.length = 740,
                         .neck_half = 79,
                         .front_dip = 92,
                         .back_dip = 24,
                         .shoulder_half = 216,
                         .shoulder_drop = 45,
                         .hem_half = 257,
                         .waist_half = 232,
                         .chest_half = 250,
                         .across_half = 204,
                         .tail = 75,
                         .armhole = 182,
                         .shoulder_columns = 20,
                         .neck_columns = 30,
                         .rows = 96,
                         .put_on_height = 1468,
                         .put_on_half = 212,
                         .put_on_depth = 115,
                         .put_on_neck = 68,
                         .neck_middle = -8,
                         .put_on_wave = 9};
constexpr int kMiddle = kCut.last() / 2;  // a column

constexpr SleeveCut kSleeve{.length = 378,
                            .cap = 88,
                            .end = 250,
                            .rows = 60,
                            .cuff_high = 62,
                            .cuff_round = 214,
                            .cuff_rows = 11,
                            .put_on = 275,
                            .past_elbow = 232};

constexpr int kStandRows = 6, kRingColumns = 2 * kCut.neck_columns + 1;
constexpr float kStandHigh = 31;
constexpr int kFallColumns = kRingColumns - 2, kFallRows = 9;
constexpr float kFallBack = 46, kFallPoint = 78, kFallRadius = 470, kFallSpread = 16;

/// The column of the stand from which a column of the fall hangs. The fall runs the other way round, with its face
/// outwards.
int stand_column(int fall_column) {
  const int k = kCut.neck_columns - 1 - fall_column;
  return k < 0 ? k + kRingColumns - 1 : k;
}

float fall_height(float s) { return mix(kFallBack, kFallPoint, std::pow(std::fabs(2 * s - 1), 3.0f)); }

Piece add_fall(Pattern& pattern, const Piece& stand) {
  const float whole = pattern.uv_mm[stand.vertex(kRingColumns - 1, 0)][0];
  const auto shape = [&](float s, float t) {
    // Measured from the middle of the back, like the columns of the stand.
    const int column = static_cast<int>(std::lround(s * (kFallColumns - 1))), k = stand_column(column);
    const float along = pattern.uv_mm[stand.vertex(k, 0)][0],
                from_back = k <= kCut.neck_columns ? -along : whole - along;
    const float out = 2 * from_back / whole, radius = kFallRadius + t * fall_height(s);
    const float phi = (from_back + kFallSpread * t * std::pow(out, 5.0f)) / kFallRadius;
    return Vec2{radius * std::sin(phi) + whole, radius * std::cos(phi) - kFallRadius / 2};
  };
  const Piece fall = add_piece(pattern, kFallColumns, kFallRows, shape, [](Vec2) { return Vec3{}; });
  for (int column = 0; column < kFallColumns; ++column) {
    const uint32_t seam = stand.vertex(stand_column(column), kStandRows - 1);
    const Vec3 from = pattern.position_mm[pattern.particle[seam]];
    const Vec3 out = unit(Vec3{from[0], 0, from[2] - kCut.neck_middle});
    for (int row = 0; row < kFallRows; ++row) {
      const float t = fraction_of(row, kFallRows), down = t * fall_height(fraction_of(column, kFallColumns));
      pattern.position_mm[pattern.particle[fall.vertex(column, row)]] =
          from + out * (10 * std::fmin(1.0f, 4 * t) + 0.5f * down) + Vec3{0, 4 * std::sin(kPi * t) - 0.8f * down, 0};
    }
    sew(pattern, seam, fall.vertex(column, 0));
  }
  interline(pattern, fall, {0, kFallColumns - 1}, {0, kFallRows - 1}, 10);
  interline(pattern, fall, {0, kFallColumns - 1}, {0, 1}, 0.03f);  // pressed into a fold
  return fall;
}

void add_front_layers(Pattern& pattern, const PatternPanel& front) {
  const auto at = [&](float x, float v) { return grid_at(pattern, front.piece, {x + kCut.hem_half, v}); };
  constexpr float kPlacketHalf = 17, kStitch = 5;
  const float neck = kCut.length - kCut.front_dip;
  add_strip(pattern, front.piece, strip_profile(-kPlacketHalf, kPlacketHalf, kStitch, kStitch, 9),
            strip_profile(0.5f, neck - 0.5f, 0, 0, 7.5f), at);
  for (int k = 0; k < 7; ++k) add_button(pattern, front.piece, {kCut.hem_half, neck - 48 - 84 * static_cast<float>(k)});
  constexpr float kPocketWide = 108, kPocketHigh = 118, kPocketIn = 58, kPocketTop = 545, kPoint = 16;
  const auto pocket = [&](float x, float y) {
    const float middle = 1 - std::fabs(2 * x / kPocketWide - 1);
    return at(kPocketIn + x, kPocketTop - kPocketHigh + y - kPoint * middle * (1 - y / kPocketHigh));
  };
  add_strip(pattern, front.piece, strip_profile(0, kPocketWide, 4, 4, 7.5f), strip_profile(0, kPocketHigh, 4, 24, 7.5f),
            pocket);
}

void add_yoke(Pattern& pattern, const PatternPanel& back) {
  constexpr float kDown = 108;
  const auto grid = [&](float fraction, float up) {
    const float column = fraction * kCut.last();
    const auto c = static_cast<size_t>(std::lround(column));
    const float hem = kCut.hem_at(2 * fraction - 1), top = back.top[c][1];
    const float from = (kCut.length - kDown - hem) / (top - hem);
    return Vec2{column, mix(from, 1, up) * kCut.top()};
  };
  std::vector<ProfilePoint> across, along;
  for (int c = 0; c <= kCut.last(); ++c)
    across.push_back({fraction_of(c, kCut.columns()), c == 0 || c == kCut.last() ? 0.06f : 1.0f, 0});
  for (const ProfilePoint& k : strip_profile(0, kDown, 4, 0, 7.5f))
    along.push_back({k.at_mm / kDown, k.thickness, k.extra_mm});
  add_strip(pattern, back.piece, across, along, grid, true);
}

void add_collar_layers(Pattern& pattern, const Piece& stand, const Piece& fall) {
  // Near the outer edge at the distances of the profile, then evenly up to the fold.
  constexpr float kEdge = 8, kFoldRow = 1.3f;
  const auto grid = [&](float fraction, float down_mm) {
    const float last = kFallRows - 1, edge_row = last * (1 - kEdge / fall_height(fraction)),
                to_edge = kFallBack - down_mm;
    const float row = to_edge < kEdge ? mix(last, edge_row, to_edge / kEdge)
                                      : mix(edge_row, kFoldRow, (to_edge - kEdge) / (kFallBack - kEdge));
    return Vec2{fraction * (kFallColumns - 1), row};
  };
  std::vector<ProfilePoint> across;
  const float whole = length(pattern.uv_mm[fall.vertex(0, 0)] - pattern.uv_mm[fall.vertex(kFallColumns - 1, 0)]);
  for (const ProfilePoint& k : strip_profile(0, whole, 5, 5, 7))
    across.push_back({k.at_mm / whole, k.thickness, k.extra_mm});
  add_strip(pattern, fall, across, strip_profile(0, kFallBack, 0, 5, 7), grid);
  add_button(pattern, stand, {pattern.uv_mm[stand.vertex(kCut.neck_columns, 0)][0], kStandHigh / 2});
}

void add_cuff_layers(Pattern& pattern, const Piece& cuff) {
  const auto grid = [&](float x, float y) { return grid_at(pattern, cuff, {x, y}); };
  add_strip(pattern, cuff, strip_profile(0.4f, kSleeve.cuff_round - 0.4f, 5, 5, 5),
            strip_profile(0, kSleeve.cuff_high, 5, 5, 6), grid);
  add_button(pattern, cuff, {11, kSleeve.cuff_high / 2});
}

}  // namespace

Drape shirt() {
  Drape drape;
  Pattern& pattern = drape.pattern;
  const Bodice bodice = add_bodice(pattern, kCut);
  interline(pattern, bodice.front.piece, {kMiddle - 2, kMiddle + 2}, {0, kCut.top()}, 3);
  const Sleeve right = add_sleeve(pattern, kSleeve, armhole(bodice, kCut, true), true);
  const Sleeve left = add_sleeve(pattern, kSleeve, armhole(bodice, kCut, false), false);
  for (const Piece& cuff : {right.cuff, left.cuff})
    interline(pattern, cuff, {0, cuff.columns - 1}, {0, cuff.rows - 1}, 12);
  const Piece stand = add_band(pattern, kCut, bodice, {kStandRows, kStandHigh, 1, 20});
  const Piece fall = add_fall(pattern, stand);
  add_front_layers(pattern, bodice.front);
  add_yoke(pattern, bodice.back);
  add_collar_layers(pattern, stand, fall);
  add_cuff_layers(pattern, right.cuff);
  add_cuff_layers(pattern, left.cuff);
  drop_unused_particles(pattern);
  put_on_form(drape);
  lower_arms(drape, kSleeve, right, left);
  drape.fabric.bending_n_m = 1.0e-5;
  drape.fabric.pucker = 0.02;
  drape.fabric.crease_per_mm = 0.03;
  drape.smoothing_passes = 2;
  drape.fall.slow_start_s = 0.3;
  drape.fall.seconds = 2.8;
  drape.fall.contact_updates_per_second = 320;
  drape.fall.substeps = 10;
  drape.fall.rest_substeps = 25;
  drape.fall.cloth_gap_mm = 6;
  drape.fall.body_friction = 0.4;
  return drape;
}

}  // namespace weftlight::drape
