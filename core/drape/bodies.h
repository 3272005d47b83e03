#pragma once
// The bodies under the drapes, as signed distances for collisions and as meshes for drawing.

#include <array>

#include "drape/mesh.h"
#include "drape/solver.h"

namespace weftlight::drape {

constexpr float kBallRadius = 150;
constexpr float kTableRadius = 450, kTableHeight = 720;
constexpr float kRodHeight = 1890, kRodRadius = 11, kRodHalfLength = 480, kRingRadius = 21;
constexpr int kRings = 15;
constexpr float kWaistHeight = 1060;
// The forms have the heights of a standing woman; their stands are shorter than her legs by this much.
constexpr float kSkirtLowered = 390, kTunicLowered = 600;

float ground(Vec3 p);
float ball(Vec3 p);
float table(Vec3 p);
struct Arm;
/// A dress form from the hips to the neck, with the given arms.
float form_with(const Arm& arm, Vec3 p);
/// The same, with its arms held away from the body.
float dress_form(Vec3 p);
/// Its lower half, cut a little above the waist, without arms.
float skirt_form(Vec3 p);
/// That as it is drawn: a tape around the waist fills the slit under the skirt, which stands off the form.
float taped_skirt_form(Vec3 p);
/// A board on a foot, tilted towards the viewer.
float board(Vec3 p);
struct RoundedBox {
  Vec3 centre, half;
  float edge;      // radius of its edges
  float lean_rad;  // rotation backwards, about x
};
std::array<RoundedBox, 2> board_boxes();
/// From the directions of a box to those of the room.
Vec3 lean_back(Vec3 p, float lean_rad);
constexpr float kBoardHeight = 170, kBoardLean = -0.42f;  // mm, middle of its upper side; radians

/// Half width (x), half depth (z) and middle (z) of the form's trunk at a height.
struct TrunkSection {
  float half_width, half_depth, middle;
};
TrunkSection trunk_section(float height);

/// An arm of the dress form at +x; that at -x is its mirror image.
struct Arm {
  Vec3 shoulder, elbow, wrist;
  float shoulder_radius, elbow_radius, wrist_radius;
};
Arm arm();
/// The same arm between raised, to put a garment on (fraction 0), and lowered beside the body, slightly bent (1).
Arm lowered_arm(float fraction);

/// x of ring i of the curtain after gathering, mm.
float ring_x(int ring);

Mesh mesh_of_body(const std::string& name);

}  // namespace weftlight::drape
