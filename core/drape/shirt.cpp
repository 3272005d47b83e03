// The shirt's pattern, how it is put on the form, and how the arms come down in it.

#include <algorithm>
#include <memory>
#include <numeric>

#include "drape/bodies.h"
#include "drape/garments.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

// Of a panel, front or back, in millimetres; heights are above the hem's lowest place.
constexpr float kLength = 740;  // hem to neck point
constexpr float kNeckHalf = 79, kFrontDip = 92, kBackDip = 24;
constexpr float kShoulderHalf = 216, kShoulderDrop = 45;
constexpr float kHemHalf = 257, kChestHalf = 250, kWaistHalf = 232, kAcrossHalf = 204;
constexpr float kTail = 75;      // how much higher the hem is at the sides
constexpr float kArmhole = 182;  // underarm to shoulder
constexpr int kShoulderColumns = 20, kNeckColumns = 30, kColumns = 2 * kShoulderColumns + kNeckColumns + 1;
constexpr int kRows = 96, kTop = kRows - 1, kLast = kColumns - 1, kMiddle = kLast / 2;
constexpr float kTip = kLength - kShoulderDrop;
constexpr int kUnderarm = static_cast<int>((kTip - kArmhole - kTail) / (kTip - kTail) * kTop);  // a row
constexpr int kRise = kTop - kUnderarm;

// As it is put on, above where it will rest.
constexpr float kPutOnHeight = 1485, kPutOnHalf = 212, kPutOnDepth = 115, kPutOnNeck = 68, kNeckMiddle = -8;

constexpr int kSleeveColumns = 2 * kRise + 1, kSleeveRows = 60;
constexpr float kSleeveLength = 378, kCap = 88, kSleeveEnd = 250;  // of the seam under the arm; width at the cuff
constexpr int kCuffRows = 11;
constexpr float kCuffRound = 214, kCuffHigh = 62;
constexpr float kCuffPutOn = 275, kCuffPastElbow = 232;  // where the cuff ends on the arm, at first and at last

constexpr int kStandRows = 6, kRingColumns = 2 * kNeckColumns + 1;
constexpr float kStandHigh = 31;
constexpr int kFallColumns = kRingColumns - 2, kFallRows = 9;
constexpr float kFallBack = 46, kFallPoint = 78, kFallRadius = 470, kFallSpread = 16;

constexpr float kLayer = 1.1f;  // thickness of a second layer with its turned edges

float share_of(int i, int count) { return static_cast<float>(i) / static_cast<float>(count - 1); }

/// Points of the neckline from one neck point to the other, as far apart as one another.
std::vector<Vec2> neckline(float dip) {
  constexpr int kFine = 600;
  const auto at = [&](int i) {
    const float across = static_cast<float>(i) / kFine;
    return Vec2{kNeckHalf * (2 * across - 1), kLength - dip * std::sin(kPi * across)};
  };
  std::vector<float> gone{0};
  for (int i = 1; i <= kFine; ++i) gone.push_back(gone.back() + length(at(i) - at(i - 1)));
  std::vector<Vec2> points;
  for (int c = 0; c <= kNeckColumns; ++c) {
    const float goal = gone.back() * share_of(c, kNeckColumns + 1);
    points.push_back(at(static_cast<int>(std::lower_bound(gone.begin(), gone.end(), goal) - gone.begin())));
  }
  return points;
}

/// A panel's top edge from left to right, a place a column: shoulder, neck, shoulder.
std::vector<Vec2> top_edge(float dip) {
  std::vector<Vec2> edge;
  const Vec2 tip{-kShoulderHalf, kTip}, neck{-kNeckHalf, kLength};
  for (int c = 0; c < kShoulderColumns; ++c) edge.push_back(tip + (neck - tip) * share_of(c, kShoulderColumns + 1));
  for (const Vec2& p : neckline(dip)) edge.push_back(p);
  for (int c = kShoulderColumns; c-- > 0;)
    edge.push_back({-edge[static_cast<size_t>(c)][0], edge[static_cast<size_t>(c)][1]});
  return edge;
}

/// Half a panel's width at a share of its rows.
float half_width(float t) {
  const float under = static_cast<float>(kUnderarm) / kTop;
  if (t <= under) {
    const float waist = std::pow(std::sin(kPi * t / under), 2.0f);
    return mix(mix(kHemHalf, kChestHalf, t / under), kWaistHalf, waist);
  }
  const float up = (t - under) / (1 - under), in = std::fmax(0.0f, 1 - up / 0.6f);
  return kAcrossHalf + (kChestHalf - kAcrossHalf) * in * in + (kShoulderHalf - kAcrossHalf) * ramp(0.5f, 1, up);
}

struct Panel {
  Piece piece;
  std::vector<Vec2> top;
};

Panel add_panel(Pattern& pattern, bool back) {
  Panel panel;
  panel.top = top_edge(back ? kBackDip : kFrontDip);
  const auto shape = [&](float s, float t) {
    const float across = 2 * s - 1, hem = kTail * ramp(0.4f, 1, std::fabs(across));
    const Vec2 top = panel.top[static_cast<size_t>(std::lround(s * kLast))];
    const float x = mix(across * half_width(t), top[0], t > 0 ? std::pow(t, 4.0f) : 0);
    return Vec2{x + kHemHalf, mix(hem, top[1], t)};
  };
  panel.piece = add_piece(pattern, kColumns, kRows, shape, [](Vec2) { return Vec3{}; });
  const float side = back ? -1 : 1;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const float across = 2 * share_of(column, kColumns) - 1, angle = across * kPi / 2;
      const Vec2 top = panel.top[static_cast<size_t>(column)];
      const uint32_t vertex = panel.piece.vertex(column, row);
      const float v = pattern.uv_mm[vertex][1];
      // A ring round the neck; beside it straight out.
      const float ring = kPi * std::clamp(share_of(column - kShoulderColumns, kNeckColumns + 1), 0.0f, 1.0f);
      const float out = std::fmax(0.0f, std::fabs(top[0]) - kNeckHalf) / (kShoulderHalf - kNeckHalf);
      const float top_x = -kPutOnNeck * std::cos(ring) + std::copysign((kPutOnHalf - kPutOnNeck) * out, top[0]);
      const float top_z = side * kPutOnNeck * std::sin(ring);
      const float round = ramp(0, 130, top[1] - v);
      const float gape = 55 * std::sin(kPi * std::clamp(static_cast<float>(row - kUnderarm) / kRise, 0.0f, 1.0f));
      const float x = mix(top_x, kPutOnHalf * std::sin(angle), round);
      const float z = mix(top_z, side * kPutOnDepth * std::cos(angle), round) + side * gape * std::pow(across, 4.0f);
      pattern.position_mm[pattern.particle[vertex]] = {side * x, kPutOnHeight - kLength + v, kNeckMiddle + z};
    }
  }
  return panel;
}

/// The panels' vertices round an armhole from the underarm; the right arm's by way of the front.
std::vector<uint32_t> armhole(const Piece& front, const Piece& back, bool right) {
  std::vector<uint32_t> round;
  for (int k = 0; k <= 2 * kRise; ++k) {
    const int row = k <= kRise ? kUnderarm + k : kUnderarm + 2 * kRise - k;
    const bool first = k <= kRise;
    round.push_back(right ? (first ? front.vertex(kLast, row) : back.vertex(0, row))
                          : (first ? back.vertex(kLast, row) : front.vertex(0, row)));
  }
  return round;
}

/// The neckline's vertices from the middle of the back by the left of the front to the back again.
std::vector<uint32_t> neck_ring(const Piece& front, const Piece& back) {
  std::vector<uint32_t> ring;
  constexpr int kQuarter = kNeckColumns / 2;
  for (int k = 0; k < kQuarter; ++k) ring.push_back(back.vertex(kMiddle + k, kTop));
  for (int k = 0; k < kNeckColumns; ++k) ring.push_back(front.vertex(kShoulderColumns + k, kTop));
  for (int k = 0; k <= kQuarter; ++k) ring.push_back(back.vertex(kShoulderColumns + k, kTop));
  return ring;
}

float apart(const Pattern& pattern, uint32_t a, uint32_t b) { return length(pattern.uv_mm[a] - pattern.uv_mm[b]); }

float cap_height(float s) { return kCap * (0.5f - 0.5f * std::cos(2 * kPi * s)); }

/// The sleeve's width under its cap, so that the cap's edge is as long as the armhole.
float sleeve_width(float edge) {
  float low = 100, high = edge;
  for (int pass = 0; pass < 30; ++pass) {
    const float width = (low + high) / 2;
    float sum = 0;
    for (int i = 1; i <= 200; ++i)
      sum += std::hypot(width / 200, cap_height(share_of(i, 201)) - cap_height(share_of(i - 1, 201)));
    (sum > edge ? high : low) = width;
  }
  return low;
}

/// Shares of the sleeve's width at which its columns stand, so that each step along the cap is as long as the
/// armhole's.
std::vector<float> sleeve_columns(float width, const std::vector<float>& gone) {
  constexpr int kFine = 800;
  std::vector<float> along{0};
  for (int i = 1; i <= kFine; ++i)
    along.push_back(along.back() + std::hypot(width / kFine, cap_height(share_of(i, kFine + 1)) -
                                                                 cap_height(share_of(i - 1, kFine + 1))));
  std::vector<float> columns;
  for (const float g : gone) {
    const float goal = g / gone.back() * along.back();
    columns.push_back(
        share_of(static_cast<int>(std::lower_bound(along.begin(), along.end() - 1, goal) - along.begin()), kFine + 1));
  }
  return columns;
}

/// Where the edge of the cuff is held: a ring about the arm at +x; s from below by the front.
Vec3 cuff_end(const Arm& a, float past_elbow, float s) {
  const Vec3 axis = unit(a.wrist - a.elbow), over = unit(Vec3{-axis[1], axis[0], 0}), ahead = cross(axis, over);
  const float radius = kCuffRound / (2 * kPi), around = 2 * kPi * s;
  return a.elbow + axis * past_elbow - over * (std::cos(around) * radius) + ahead * (std::sin(around) * radius);
}

/// The same of either arm; the left one's runs by way of the back.
Vec3 cuff_end(const Arm& a, float past_elbow, float s, bool right) {
  if (right) return cuff_end(a, past_elbow, s);
  const Vec3 p = cuff_end(a, past_elbow, 1 - s);
  return {-p[0], p[1], p[2]};
}

struct Sleeve {
  Piece cuff, sleeve;
};

Sleeve add_sleeve(Pattern& pattern, const std::vector<uint32_t>& hole, bool right) {
  const auto nowhere = [](Vec2) { return Vec3{}; };
  std::vector<float> gone{0};
  for (int k = 1; k <= 2 * kRise; ++k) {
    const int from = k <= kRise ? k : 2 * kRise + 1 - k;  // the back's side is as long as the front's
    gone.push_back(gone.back() + apart(pattern, hole[static_cast<size_t>(from - 1)], hole[static_cast<size_t>(from)]));
  }
  const float width = sleeve_width(gone.back());
  const std::vector<float> columns = sleeve_columns(width, gone);
  const auto across = [&](float s) { return columns[static_cast<size_t>(std::lround(s * (kSleeveColumns - 1)))]; };
  Sleeve out;
  out.cuff = add_piece(
      pattern, kSleeveColumns, kCuffRows,
      [&](float s, float t) {
        return Vec2{across(s) * kCuffRound, t * kCuffHigh};
      },
      nowhere);
  out.sleeve = add_piece(
      pattern, kSleeveColumns, kSleeveRows,
      [&](float s, float t) {
        return Vec2{width / 2 + (across(s) - 0.5f) * mix(kSleeveEnd, width, t),
                    t * (kSleeveLength + cap_height(across(s)))};
      },
      nowhere);
  const Arm a = arm_let_down(0);
  for (int column = 0; column < kSleeveColumns; ++column) {
    const float s = columns[static_cast<size_t>(column)];
    const Vec3 to = pattern.position_mm[pattern.particle[hole[static_cast<size_t>(column)]]];
    const Vec3 end = cuff_end(a, kCuffPutOn, s, right);
    const float cuff_share = kCuffHigh / (kCuffHigh + kSleeveLength + cap_height(s));
    for (int row = 0; row < kCuffRows; ++row)
      pattern.position_mm[pattern.particle[out.cuff.vertex(column, row)]] =
          end + (to - end) * (cuff_share * share_of(row, kCuffRows));
    for (int row = 0; row < kSleeveRows; ++row)
      pattern.position_mm[pattern.particle[out.sleeve.vertex(column, row)]] =
          end + (to - end) * mix(cuff_share, 1, share_of(row, kSleeveRows));
  }
  for (int row = 0; row < kCuffRows; ++row)
    sew(pattern, out.cuff.vertex(0, row), out.cuff.vertex(kSleeveColumns - 1, row));
  for (int row = 0; row < kSleeveRows; ++row)
    sew(pattern, out.sleeve.vertex(0, row), out.sleeve.vertex(kSleeveColumns - 1, row));
  for (int column = 0; column < kSleeveColumns; ++column) {
    sew(pattern, out.cuff.vertex(column, kCuffRows - 1), out.sleeve.vertex(column, 0));
    sew(pattern, hole[static_cast<size_t>(column)], out.sleeve.vertex(column, kSleeveRows - 1));
  }
  interline(pattern, out.cuff, {0, kSleeveColumns - 1}, {0, kCuffRows - 1}, 12);
  return out;
}

Piece add_stand(Pattern& pattern, const std::vector<uint32_t>& ring) {
  std::vector<float> along{0};
  for (size_t k = 1; k < ring.size(); ++k) {
    // Of the panel that both are of: the first and the last quarter are the back's.
    const bool is_changing = k == kNeckColumns / 2 || k == 3 * kNeckColumns / 2;
    along.push_back(along.back() +
                    (is_changing ? apart(pattern, ring[k - 2], ring[k - 1]) : apart(pattern, ring[k - 1], ring[k])));
  }
  const auto shape = [&](float s, float t) {
    return Vec2{along[static_cast<size_t>(std::lround(s * (kRingColumns - 1)))], t * kStandHigh};
  };
  const Piece stand = add_piece(pattern, kRingColumns, kStandRows, shape, [](Vec2) { return Vec3{}; });
  for (int row = 0; row < kStandRows; ++row) {
    for (int k = 0; k < kRingColumns; ++k) {
      const Vec3 base = pattern.position_mm[pattern.particle[ring[static_cast<size_t>(k)]]];
      pattern.position_mm[pattern.particle[stand.vertex(k, row)]] =
          base + Vec3{0, kStandHigh * share_of(row, kStandRows), 0};
    }
    sew(pattern, stand.vertex(0, row), stand.vertex(kRingColumns - 1, row));
  }
  for (int k = 0; k < kRingColumns; ++k) sew(pattern, ring[static_cast<size_t>(k)], stand.vertex(k, 0));
  interline(pattern, stand, {0, kRingColumns - 1}, {0, kStandRows - 1}, 20);
  return stand;
}

/// Which of the stand's columns one of the fall's hangs from: it runs the other way round, its face outwards.
int stand_column(int fall_column) {
  const int k = kNeckColumns - 1 - fall_column;
  return k < 0 ? k + kRingColumns - 1 : k;
}

float fall_height(float s) { return mix(kFallBack, kFallPoint, std::pow(std::fabs(2 * s - 1), 3.0f)); }

Piece add_fall(Pattern& pattern, const Piece& stand) {
  const float whole = pattern.uv_mm[stand.vertex(kRingColumns - 1, 0)][0];
  const auto shape = [&](float s, float t) {
    // From the middle of the back, as the stand's columns are.
    const int column = static_cast<int>(std::lround(s * (kFallColumns - 1))), k = stand_column(column);
    const float along = pattern.uv_mm[stand.vertex(k, 0)][0], from_back = k <= kNeckColumns ? -along : whole - along;
    const float out = 2 * from_back / whole, radius = kFallRadius + t * fall_height(s);
    const float phi = (from_back + kFallSpread * t * std::pow(out, 5.0f)) / kFallRadius;
    return Vec2{radius * std::sin(phi) + whole, radius * std::cos(phi) - kFallRadius / 2};
  };
  const Piece fall = add_piece(pattern, kFallColumns, kFallRows, shape, [](Vec2) { return Vec3{}; });
  for (int column = 0; column < kFallColumns; ++column) {
    const uint32_t seam = stand.vertex(stand_column(column), kStandRows - 1);
    const Vec3 from = pattern.position_mm[pattern.particle[seam]];
    const Vec3 out = unit(Vec3{from[0], 0, from[2] - kNeckMiddle});
    for (int row = 0; row < kFallRows; ++row) {
      const float t = share_of(row, kFallRows), down = t * fall_height(share_of(column, kFallColumns));
      pattern.position_mm[pattern.particle[fall.vertex(column, row)]] =
          from + out * (10 * std::fmin(1.0f, 4 * t) + 0.5f * down) + Vec3{0, 4 * std::sin(kPi * t) - 0.8f * down, 0};
    }
    sew(pattern, seam, fall.vertex(column, 0));
  }
  interline(pattern, fall, {0, kFallColumns - 1}, {0, kFallRows - 1}, 10);
  interline(pattern, fall, {0, kFallColumns - 1}, {0, 1}, 0.03f);  // pressed into a fold
  return fall;
}

/// A place across a layer and how much of its thickness it has there: turned edges, a seam's groove beside them.
struct Knot {
  float at_mm, thick;
  float more_mm = 0;  // of cloth, as it goes up and down on its way from the middle
};

/// From `from` to `to`, stitched that far from its edges (0: not at all), in steps of about step_mm.
std::vector<Knot> knots(float from, float to, float stitch_from, float stitch_to, float step_mm) {
  std::vector<Knot> out{{from, 0.06f}, {from + 0.8f, 1}};
  const auto stitch = [&](float at) { out.insert(out.end(), {{at - 0.9f, 1}, {at, 0.35f}, {at + 0.9f, 1}}); };
  if (stitch_from > 0) stitch(from + stitch_from);
  const float begin = out.back().at_mm, end = to - (stitch_to > 0 ? stitch_to + 0.9f : 0.8f);
  const int steps = std::max(1, static_cast<int>((end - begin) / step_mm));
  for (int k = 1; k < steps; ++k)
    out.push_back({mix(begin, end, static_cast<float>(k) / static_cast<float>(steps)), 1});
  if (stitch_to > 0) stitch(to - stitch_to);
  else out.push_back({to - 0.8f, 1});
  out.push_back({to, 0.06f});
  const auto more = [&](size_t a, size_t b) {
    const float flat = out[b].at_mm - out[a].at_mm;
    return std::hypot(flat, kLayer * (out[b].thick - out[a].thick)) - flat;
  };
  const size_t middle = out.size() / 2;
  for (size_t k = middle; k > 0; --k) out[k - 1].more_mm = out[k].more_mm - more(k - 1, k);
  for (size_t k = middle; k + 1 < out.size(); ++k) out[k + 1].more_mm = out[k].more_mm + more(k, k + 1);
  return out;
}

/// Lays a strip on: across and along in mm, put into the piece's columns and rows by `grid`.
template <class Grid>
void lay_strip(Pattern& pattern, const Piece& piece, const std::vector<Knot>& across, const std::vector<Knot>& along,
               const Grid& grid, bool turned = false) {
  lay_on(
      pattern, piece, static_cast<int>(across.size()), static_cast<int>(along.size()),
      [&](int i, int j) {
        const Knot x = across[static_cast<size_t>(i)], y = along[static_cast<size_t>(j)];
        const Vec2 at = grid(x.at_mm, y.at_mm);
        return LaidAt{at[0], at[1], kLayer * std::fmin(x.thick, y.thick), {x.more_mm, y.more_mm}};
      },
      turned);
}

/// A button covered with the cloth, about a place of the piece, on a layer or two.
void lay_button(Pattern& pattern, const Piece& piece, Vec2 uv) {
  constexpr int kAcross = 9;
  constexpr float kRadius = 5.6f;
  // Of the rings from the middle outwards: how high, and how much longer its cloth is than its radius.
  constexpr std::array<float, 5> kHigh{1.7f, 1.7f, 1.9f, 2.3f, 0.2f}, kMore{0, 0, 0.01f, 0.07f, 1.2f};
  lay_on(pattern, piece, kAcross, kAcross, [&](int i, int j) {
    const Vec2 square{2 * share_of(i, kAcross) - 1, 2 * share_of(j, kAcross) - 1};
    // A square's rings made round: Shirley and Chiu's idea, by the larger of the two.
    const float ring = std::fmax(std::fabs(square[0]), std::fabs(square[1])), l = length(square);
    const Vec2 at = grid_at(pattern, piece, uv + (l > 0 ? square * (ring / l * kRadius) : square));
    const auto k = static_cast<size_t>(std::lround(4 * ring));
    return LaidAt{at[0], at[1], kLayer + kHigh[k], l > 0 ? square * (kMore[k] / l) : square};
  });
}

void lay_on_front(Pattern& pattern, const Panel& front) {
  const auto at = [&](float x, float v) { return grid_at(pattern, front.piece, {x + kHemHalf, v}); };
  constexpr float kPlacketHalf = 17, kStitch = 5;
  const float neck = kLength - kFrontDip;
  lay_strip(pattern, front.piece, knots(-kPlacketHalf, kPlacketHalf, kStitch, kStitch, 9),
            knots(0.5f, neck - 0.5f, 0, 0, 7.5f), at);
  for (int k = 0; k < 7; ++k) lay_button(pattern, front.piece, {kHemHalf, neck - 48 - 84 * static_cast<float>(k)});
  constexpr float kPocketWide = 108, kPocketHigh = 118, kPocketIn = 58, kPocketTop = 545, kPoint = 16;
  const auto pocket = [&](float x, float y) {
    const float middle = 1 - std::fabs(2 * x / kPocketWide - 1);
    return at(kPocketIn + x, kPocketTop - kPocketHigh + y - kPoint * middle * (1 - y / kPocketHigh));
  };
  lay_strip(pattern, front.piece, knots(0, kPocketWide, 4, 4, 7.5f), knots(0, kPocketHigh, 4, 24, 7.5f), pocket);
}

void lay_yoke(Pattern& pattern, const Panel& back) {
  constexpr float kDown = 108;
  const auto grid = [&](float share, float up) {
    const float column = share * kLast;
    const auto c = static_cast<size_t>(std::lround(column));
    const float hem = kTail * ramp(0.4f, 1, std::fabs(2 * share - 1)), top = back.top[c][1];
    const float from = (kLength - kDown - hem) / (top - hem);
    return Vec2{column, mix(from, 1, up) * kTop};
  };
  std::vector<Knot> across, along;
  for (int c = 0; c <= kLast; ++c) across.push_back({share_of(c, kColumns), c == 0 || c == kLast ? 0.06f : 1.0f, 0});
  for (const Knot& k : knots(0, kDown, 4, 0, 7.5f)) along.push_back({k.at_mm / kDown, k.thick, k.more_mm});
  lay_strip(pattern, back.piece, across, along, grid, true);
}

void lay_on_collar(Pattern& pattern, const Piece& stand, const Piece& fall) {
  // As far from the outer edge as the knots say near it, then evenly up to the fold.
  constexpr float kEdge = 8, kFoldRow = 1.3f;
  const auto grid = [&](float share, float down_mm) {
    const float last = kFallRows - 1, edge_row = last * (1 - kEdge / fall_height(share)), to_edge = kFallBack - down_mm;
    const float row = to_edge < kEdge ? mix(last, edge_row, to_edge / kEdge)
                                      : mix(edge_row, kFoldRow, (to_edge - kEdge) / (kFallBack - kEdge));
    return Vec2{share * (kFallColumns - 1), row};
  };
  std::vector<Knot> across;
  const float whole = length(pattern.uv_mm[fall.vertex(0, 0)] - pattern.uv_mm[fall.vertex(kFallColumns - 1, 0)]);
  for (const Knot& k : knots(0, whole, 5, 5, 7)) across.push_back({k.at_mm / whole, k.thick, k.more_mm});
  lay_strip(pattern, fall, across, knots(0, kFallBack, 0, 5, 7), grid);
  lay_button(pattern, stand, {pattern.uv_mm[stand.vertex(kNeckColumns, 0)][0], kStandHigh / 2});
}

void lay_on_cuff(Pattern& pattern, const Piece& cuff) {
  const auto grid = [&](float x, float y) { return grid_at(pattern, cuff, {x, y}); };
  lay_strip(pattern, cuff, knots(0.4f, kCuffRound - 0.4f, 5, 5, 5), knots(0, kCuffHigh, 5, 5, 6), grid);
  lay_button(pattern, cuff, {11, kCuffHigh / 2});
}

/// The arms come down in the sleeves; the cuffs go with the wrists.
void lead_arms(Drape& drape, const std::vector<std::pair<uint32_t, Vec2>>& cuff_ends) {
  constexpr float kFrom_s = 0.3f, kTo_s = 1.4f;
  const auto arm = std::make_shared<Arm>(arm_let_down(0));
  drape.body = [arm](Vec3 p) { return form_with(*arm, p); };
  drape.fall.lead = [arm, cuff_ends](Cloth& cloth, double time, double until) {
    const float down = ramp(kFrom_s, kTo_s, static_cast<float>(until));
    *arm = arm_let_down(down);
    for (const auto& [particle, end] : cuff_ends) {
      const Vec3d goal = Vec3d(cuff_end(*arm, mix(kCuffPutOn, kCuffPastElbow, down), end[0], end[1] > 0));
      cloth.velocity[particle] = (goal - cloth.position[particle]) * (1 / (until - time));
    }
  };
}

}  // namespace

Drape shirt() {
  Drape drape;
  Pattern& pattern = drape.pattern;
  const Panel front = add_panel(pattern, false), back = add_panel(pattern, true);
  for (int row = 0; row <= kUnderarm; ++row) {
    sew(pattern, front.piece.vertex(kLast, row), back.piece.vertex(0, row));
    sew(pattern, front.piece.vertex(0, row), back.piece.vertex(kLast, row));
  }
  for (int column = 0; column <= kShoulderColumns; ++column) {
    sew(pattern, front.piece.vertex(column, kTop), back.piece.vertex(kLast - column, kTop));
    sew(pattern, front.piece.vertex(kLast - column, kTop), back.piece.vertex(column, kTop));
  }
  interline(pattern, front.piece, {kMiddle - 2, kMiddle + 2}, {0, kTop}, 3);
  const Sleeve right = add_sleeve(pattern, armhole(front.piece, back.piece, true), true);
  const Sleeve left = add_sleeve(pattern, armhole(front.piece, back.piece, false), false);
  const Piece stand = add_stand(pattern, neck_ring(front.piece, back.piece));
  const Piece fall = add_fall(pattern, stand);
  lay_on_front(pattern, front);
  lay_yoke(pattern, back);
  lay_on_collar(pattern, stand, fall);
  lay_on_cuff(pattern, right.cuff);
  lay_on_cuff(pattern, left.cuff);
  drop_unused_particles(pattern);
  std::vector<std::pair<uint32_t, Vec2>> cuff_ends;
  for (const bool is_right : {true, false}) {
    for (int column = 0; column + 1 < kSleeveColumns; ++column) {
      const uint32_t particle = pattern.particle[(is_right ? right : left).cuff.vertex(column, 0)];
      const float round = pattern.uv_mm[(is_right ? right : left).cuff.vertex(column, 0)][0] / kCuffRound;
      cuff_ends.push_back({particle, {round, is_right ? 1.0f : -1.0f}});
      drape.held.push_back(particle);
    }
  }
  wear(drape);
  lead_arms(drape, cuff_ends);
  drape.fabric.bending_n_m = 1.0e-5;
  drape.fabric.pucker = 0.02;
  drape.fall.seconds = 2.8;
  drape.fall.substeps = 20;
  drape.fall.rest_substeps = 40;
  drape.fall.apart_mm = 6;
  drape.fall.body_friction = 0.4;
  return drape;
}

}  // namespace weftlight::drape
