#include "drape/bodice.h"

#include <algorithm>
#include <memory>

#include "drape/vec.h"

namespace weftlight::drape {

namespace {

/// Points of the neckline from one neck point to the other, at equal distances.
std::vector<Vec2> neckline(const BodiceCut& cut, float dip) {
  constexpr int kFine = 600;
  const auto at = [&](int i) {
    const float across = static_cast<float>(i) / kFine;
    return Vec2{cut.neck_half * (2 * across - 1), cut.length - dip * std::sin(kPi * across)};
  };
  std::vector<float> arc{0};
  for (int i = 1; i <= kFine; ++i) arc.push_back(arc.back() + length(at(i) - at(i - 1)));
  std::vector<Vec2> points;
  for (int c = 0; c <= cut.neck_columns; ++c) {
    const float goal = arc.back() * fraction_of(c, cut.neck_columns + 1);
    points.push_back(at(static_cast<int>(std::lower_bound(arc.begin(), arc.end(), goal) - arc.begin())));
  }
  return points;
}

std::vector<Vec2> top_edge(const BodiceCut& cut, float dip) {
  std::vector<Vec2> edge;
  const Vec2 tip{-cut.shoulder_half, cut.tip()}, neck{-cut.neck_half, cut.length};
  for (int c = 0; c < cut.shoulder_columns; ++c)
    edge.push_back(tip + (neck - tip) * fraction_of(c, cut.shoulder_columns + 1));
  for (const Vec2& p : neckline(cut, dip)) edge.push_back(p);
  for (int c = cut.shoulder_columns; c-- > 0;)
    edge.push_back({-edge[static_cast<size_t>(c)][0], edge[static_cast<size_t>(c)][1]});
  return edge;
}

/// Half of a panel's width; t: fraction of its rows, from the hem.
float half_width(const BodiceCut& cut, float t) {
  const float under = static_cast<float>(cut.underarm()) / static_cast<float>(cut.top());
  if (t <= under) {
    const float waist = std::pow(std::sin(kPi * t / under), 2.0f);
    return mix(mix(cut.hem_half, cut.chest_half, t / under), cut.waist_half, waist);
  }
  const float up = (t - under) / (1 - under), in = std::fmax(0.0f, 1 - up / 0.6f);
  return cut.across_half + (cut.chest_half - cut.across_half) * in * in +
         (cut.shoulder_half - cut.across_half) * ramp(0.5f, 1, up);
}

/// Start position of a vertex: the neckline is a ring, the shoulders run straight out, the rest lies around the trunk.
Vec3 put_on(const BodiceCut& cut, const PatternPanel& panel, int column, int row, float v, float side) {
  const float across = 2 * fraction_of(column, cut.columns()) - 1, angle = across * kPi / 2;
  const Vec2 top = panel.top[static_cast<size_t>(column)];
  const float ring = kPi * std::clamp(fraction_of(column - cut.shoulder_columns, cut.neck_columns + 1), 0.0f, 1.0f);
  const float out = std::fmax(0.0f, std::fabs(top[0]) - cut.neck_half) / (cut.shoulder_half - cut.neck_half);
  // Eight columns per gather.
  const float gathers = cut.put_on_gathers * std::sin(ring) * std::sin(kPi / 4 * static_cast<float>(column)) *
                        ramp(0, 15, top[1] - v) * (1 - ramp(15, 160, top[1] - v));
  const float top_x =
      -cut.put_on_neck * std::cos(ring) + std::copysign((cut.put_on_half - cut.put_on_neck) * out, top[0]);
  const float top_z = side * (cut.put_on_neck * std::sin(ring) + gathers);
  const float round = ramp(0, 130, top[1] - v);
  const float up = std::clamp(static_cast<float>(row - cut.underarm()) / static_cast<float>(cut.rise()), 0.0f, 1.0f);
  const float gape = 55 * std::sin(kPi * up);
  // At its full width and already in waves, so that a flared panel falls in folds.
  const float down = ramp(cut.tip() - cut.armhole, 0, v);
  const float flared = 1 + std::fmax(0.0f, cut.hem_half / cut.chest_half - 1) * down;
  const float phase = 0.8f * side + 0.6f;
  const float waves = std::sin(7 * angle + phase) + 0.6f * std::sin(11 * angle - 2 * phase);
  const float waved = cut.put_on_wave * mix(0.6f, 1.3f, down) * waves;
  const float x = mix(top_x, flared * cut.put_on_half * std::sin(angle), round);
  const float z = mix(top_z, side * (flared * cut.put_on_depth + waved) * std::cos(angle), round) +
                  side * gape * std::pow(across, 4.0f);
  return {side * x, cut.put_on_height - cut.length + v, cut.neck_middle + z};
}

PatternPanel add_panel(Pattern& pattern, const BodiceCut& cut, bool back) {
  PatternPanel panel;
  panel.top = top_edge(cut, back ? cut.back_dip : cut.front_dip);
  const auto shape = [&](float s, float t) {
    const float across = 2 * s - 1;
    const Vec2 top = panel.top[static_cast<size_t>(std::lround(s * static_cast<float>(cut.last())))];
    const float x = mix(across * half_width(cut, t), top[0], t > 0 ? std::pow(t, 4.0f) : 0);
    return Vec2{x + cut.hem_half, mix(cut.hem_at(across), top[1], t)};
  };
  panel.piece = add_piece(pattern, cut.columns(), cut.rows, shape, [](Vec2) { return Vec3{}; });
  for (int row = 0; row < cut.rows; ++row) {
    for (int column = 0; column < cut.columns(); ++column) {
      const uint32_t vertex = panel.piece.vertex(column, row);
      pattern.position_mm[pattern.particle[vertex]] =
          put_on(cut, panel, column, row, pattern.uv_mm[vertex][1], back ? -1.0f : 1.0f);
    }
  }
  return panel;
}

float cap_height(const SleeveCut& cut, float s) { return cut.cap * (0.5f - 0.5f * std::cos(2 * kPi * s)); }

/// Arc length along the edge of the cap at each of `fine` steps.
std::vector<float> along_cap(const SleeveCut& cut, float width, int fine) {
  std::vector<float> along{0};
  for (int i = 1; i <= fine; ++i)
    along.push_back(along.back() +
                    std::hypot(width / static_cast<float>(fine), cap_height(cut, fraction_of(i, fine + 1)) -
                                                                     cap_height(cut, fraction_of(i - 1, fine + 1))));
  return along;
}

/// The width of the sleeve below its cap for which the edge of the cap is as long as the armhole.
float sleeve_width(const SleeveCut& cut, float edge) {
  float low = 100, high = edge;
  for (int pass = 0; pass < 30; ++pass) {
    const float width = (low + high) / 2;
    (along_cap(cut, width, 200).back() > edge ? high : low) = width;
  }
  return low;
}

/// Positions of the columns as fractions of the sleeve's width, for which each step along the cap is as long as that
/// along the armhole.
std::vector<float> sleeve_columns(const SleeveCut& cut, float width, const std::vector<float>& arc) {
  constexpr int kFine = 800;
  const std::vector<float> along = along_cap(cut, width, kFine);
  std::vector<float> columns;
  for (const float at : arc) {
    const float goal = at / arc.back() * along.back();
    columns.push_back(fraction_of(
        static_cast<int>(std::lower_bound(along.begin(), along.end() - 1, goal) - along.begin()), kFine + 1));
  }
  return columns;
}

/// Position of the end of a sleeve: a ring about the arm at +x; s runs from below over the front.
Vec3 ring_on_arm(const Arm& a, float round, float past_elbow, float s) {
  const Vec3 axis = unit(a.wrist - a.elbow), over = unit(Vec3{-axis[1], axis[0], 0}), ahead = cross(axis, over);
  const float radius = round / (2 * kPi), around = 2 * kPi * s;
  return a.elbow + axis * past_elbow - over * (std::cos(around) * radius) + ahead * (std::sin(around) * radius);
}

/// The same for either arm; that of the left arm runs over the back first.
Vec3 ring_on_arm(const Arm& a, float round, float past_elbow, float s, bool right) {
  if (right) return ring_on_arm(a, round, past_elbow, s);
  const Vec3 p = ring_on_arm(a, round, past_elbow, 1 - s);
  return {-p[0], p[1], p[2]};
}

void put_on(Pattern& pattern, const SleeveCut& cut, const Sleeve& out, const std::vector<float>& columns,
            const std::vector<uint32_t>& hole, bool right) {
  const Arm a = lowered_arm(0);
  for (int column = 0; column < out.sleeve.columns; ++column) {
    const float s = columns[static_cast<size_t>(column)];
    const Vec3 to = pattern.position_mm[pattern.particle[hole[static_cast<size_t>(column)]]];
    const Vec3 end = ring_on_arm(a, cut.round(), cut.put_on, s, right);
    const float cuff_share = cut.cuff_high / (cut.cuff_high + cut.length + cap_height(cut, s));
    for (int row = 0; row < out.cuff.rows; ++row)
      pattern.position_mm[pattern.particle[out.cuff.vertex(column, row)]] =
          end + (to - end) * (cuff_share * fraction_of(row, cut.cuff_rows));
    for (int row = 0; row < cut.rows; ++row)
      pattern.position_mm[pattern.particle[out.sleeve.vertex(column, row)]] =
          end + (to - end) * mix(cuff_share, 1, fraction_of(row, cut.rows));
  }
}

}  // namespace

float BodiceCut::hem_at(float across) const { return tail * ramp(0.4f, 1, std::fabs(across)); }

Bodice add_bodice(Pattern& pattern, const BodiceCut& cut, int open) {
  Bodice out{add_panel(pattern, cut, false), add_panel(pattern, cut, true)};
  const Piece &front = out.front.piece, &back = out.back.piece;
  for (int row = open; row <= cut.underarm(); ++row) {
    sew(pattern, front.vertex(cut.last(), row), back.vertex(0, row));
    sew(pattern, front.vertex(0, row), back.vertex(cut.last(), row));
  }
  for (int column = 0; column <= cut.shoulder_columns; ++column) {
    sew(pattern, front.vertex(column, cut.top()), back.vertex(cut.last() - column, cut.top()));
    sew(pattern, front.vertex(cut.last() - column, cut.top()), back.vertex(column, cut.top()));
  }
  return out;
}

std::vector<uint32_t> armhole(const Bodice& bodice, const BodiceCut& cut, bool right) {
  const Piece &front = bodice.front.piece, &back = bodice.back.piece;
  std::vector<uint32_t> round;
  for (int k = 0; k <= 2 * cut.rise(); ++k) {
    const bool first = k <= cut.rise();
    const int row = first ? cut.underarm() + k : cut.underarm() + 2 * cut.rise() - k;
    round.push_back(right ? (first ? front.vertex(cut.last(), row) : back.vertex(0, row))
                          : (first ? back.vertex(cut.last(), row) : front.vertex(0, row)));
  }
  return round;
}

std::vector<uint32_t> neck_ring(const Bodice& bodice, const BodiceCut& cut) {
  const Piece &front = bodice.front.piece, &back = bodice.back.piece;
  const int quarter = cut.neck_columns / 2, from = cut.shoulder_columns;
  std::vector<uint32_t> ring;
  for (int k = 0; k < quarter; ++k) ring.push_back(back.vertex(cut.last() / 2 + k, cut.top()));
  for (int k = 0; k < cut.neck_columns; ++k) ring.push_back(front.vertex(from + k, cut.top()));
  for (int k = 0; k <= quarter; ++k) ring.push_back(back.vertex(from + k, cut.top()));
  return ring;
}

Piece add_band(Pattern& pattern, const BodiceCut& cut, const Bodice& bodice, const BandCut& band) {
  const std::vector<uint32_t> ring = neck_ring(bodice, cut);
  const int count = static_cast<int>(ring.size());
  std::vector<float> along{0};
  for (int k = 1; k < count; ++k) {
    // Both vertices must be of one panel: the first and the last quarter belong to the back.
    const bool is_changing = k == cut.neck_columns / 2 || k == 3 * cut.neck_columns / 2;
    const auto to = static_cast<size_t>(is_changing ? k - 1 : k);
    along.push_back(along.back() + band.fraction * pattern_distance(pattern, ring[to - 1], ring[to]));
  }
  const auto shape = [&](float s, float t) {
    return Vec2{along[static_cast<size_t>(std::lround(s * static_cast<float>(count - 1)))], t * band.high};
  };
  const Piece piece = add_piece(pattern, count, band.rows, shape, [](Vec2) { return Vec3{}; });
  for (int row = 0; row < band.rows; ++row) {
    for (int k = 0; k < count; ++k) {
      const Vec3 base = pattern.position_mm[pattern.particle[ring[static_cast<size_t>(k)]]];
      pattern.position_mm[pattern.particle[piece.vertex(k, row)]] =
          base + Vec3{0, band.high * fraction_of(row, band.rows), 0};
    }
    sew(pattern, piece.vertex(0, row), piece.vertex(count - 1, row));
  }
  for (int k = 0; k < count; ++k) sew(pattern, ring[static_cast<size_t>(k)], piece.vertex(k, 0));
  interline(pattern, piece, {0, count - 1}, {0, band.rows - 1}, band.firmness);
  return piece;
}

Sleeve add_sleeve(Pattern& pattern, const SleeveCut& cut, const std::vector<uint32_t>& hole, bool right) {
  const auto nowhere = [](Vec2) { return Vec3{}; };
  const int count = static_cast<int>(hole.size()), rise = count / 2;
  std::vector<float> arc{0};
  for (int k = 1; k < count; ++k) {
    const int from = k <= rise ? k : count - k;  // the back edge is as long as the front edge
    arc.push_back(arc.back() +
                  pattern_distance(pattern, hole[static_cast<size_t>(from - 1)], hole[static_cast<size_t>(from)]));
  }
  const float width = sleeve_width(cut, arc.back());
  const std::vector<float> columns = sleeve_columns(cut, width, arc);
  const auto across = [&](float s) {
    return columns[static_cast<size_t>(std::lround(s * static_cast<float>(count - 1)))];
  };
  Sleeve out;
  if (cut.cuff_rows > 0)
    out.cuff = add_piece(
        pattern, count, cut.cuff_rows,
        [&](float s, float t) {
          return Vec2{across(s) * cut.cuff_round, t * cut.cuff_high};
        },
        nowhere);
  out.sleeve = add_piece(
      pattern, count, cut.rows,
      [&](float s, float t) {
        return Vec2{width / 2 + (across(s) - 0.5f) * mix(cut.end, width, t),
                    t * (cut.length + cap_height(cut, across(s)))};
      },
      nowhere);
  put_on(pattern, cut, out, columns, hole, right);
  for (const Piece& tube : {out.cuff, out.sleeve})
    for (int row = 0; row < tube.rows; ++row) sew(pattern, tube.vertex(0, row), tube.vertex(count - 1, row));
  for (int column = 0; column < count; ++column) {
    if (out.cuff.rows > 0) sew(pattern, out.cuff.vertex(column, out.cuff.rows - 1), out.sleeve.vertex(column, 0));
    sew(pattern, hole[static_cast<size_t>(column)], out.sleeve.vertex(column, cut.rows - 1));
  }
  return out;
}

void lower_arms(Drape& drape, const SleeveCut& cut, const Sleeve& right, const Sleeve& left) {
  constexpr float kFrom_s = 0.3f, kTo_s = 1.4f;
  struct End {
    uint32_t particle;
    float round;
    bool right;
  };
  std::vector<End> ends;
  for (const bool is_right : {true, false}) {
    const Piece& piece = (is_right ? right : left).lowest();
    const float first = drape.pattern.uv_mm[piece.vertex(0, 0)][0];
    for (int column = 0; column + 1 < piece.columns; ++column) {
      const uint32_t vertex = piece.vertex(column, 0);
      const float along = drape.pattern.uv_mm[vertex][0] - first;
      ends.push_back({drape.pattern.particle[vertex], along / cut.round(), is_right});
      drape.held.push_back(ends.back().particle);
    }
  }
  const auto arm = std::make_shared<Arm>(lowered_arm(0));
  drape.body = [arm](Vec3 p) { return form_with(*arm, p); };
  drape.fall.move_held = [=](SimulatedCloth& cloth, double time, double until) {
    const float down = ramp(kFrom_s, kTo_s, static_cast<float>(until));
    *arm = lowered_arm(down);
    for (const End& end : ends) {
      const Vec3d goal =
          Vec3d(ring_on_arm(*arm, cut.round(), mix(cut.put_on, cut.past_elbow, down), end.round, end.right));
      cloth.velocity[end.particle] = (goal - cloth.position[end.particle]) * (1 / (until - time));
    }
  };
}

}  // namespace weftlight::drape
