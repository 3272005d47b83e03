#pragma once
// What the drapes lie on, as signed distances to collide with and as meshes to draw.

#include <array>

#include "drape/mesh.h"
#include "drape/names.h"
#include "drape/solver.h"

namespace weftlight::drape {

constexpr float kBallRadius = 150;
constexpr float kTableRadius = 450, kTableHeight = 720;
constexpr float kRodHeight = 1890, kRodRadius = 11, kRodHalfLength = 480, kRingRadius = 21;
constexpr int kRings = 15;
constexpr float kWaistHeight = 1060;
// The forms have a standing woman's heights; their stands are shorter than her legs by this much.
constexpr float kSkirtLowered = 390, kTunicLowered = 600;

float ground(Vec3 p);
float ball(Vec3 p);
float table(Vec3 p);
struct Arm;
/// A dress form from the hips to the neck, with such arms.
float form_with(const Arm& arm, Vec3 p);
/// The same, arms hanging outwards.
float dress_form(Vec3 p);
/// Its lower half, cut a little above the waist, without arms.
float skirt_form(Vec3 p);
/// A board that leans towards the viewer, on its foot.
float board(Vec3 p);
struct Box {
  Vec3 centre, half;
  float edge;      // radius of its edges
  float lean_rad;  // backwards, about x
};
std::array<Box, 2> board_boxes();
/// From a box's own directions to those of the room.
Vec3 turned_back(Vec3 p, float lean_rad);
constexpr float kBoardHeight = 170, kBoardLean = -0.42f;  // of the middle of its upper side; radians

/// Half width (x), half depth (z) and middle (z) of the form's trunk at a height.
struct Section {
  float half_width, half_depth, middle;
};
Section trunk_section(float height);

/// An arm of the dress form at +x; that at -x is its mirror image.
struct Arm {
  Vec3 shoulder, elbow, wrist;
  float shoulder_radius, elbow_radius, wrist_radius;
};
Arm arm();
/// The same, raised to put a garment on (0), let down beside the body and a little bent (1), or between.
Arm arm_let_down(float share);

/// Where ring i of the curtain hangs once gathered.
float ring_x(int ring);

Mesh mesh_of_body(const std::string& name);

}  // namespace weftlight::drape
