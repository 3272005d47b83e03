#pragma once
// The fibres of one thread: plies twisted about each other, in each of them fibres that wind about its axis, wander and
// migrate, and what stands off: hairs and loops. Positions are in the section of the thread, where the unit disc is the
// ellipse of the thread's body; the ray tracer lays them along the thread's centre line.
//
// Based on: Zhao, Luan, Bala 2016, "Fitting procedural yarn models for realistic cloth rendering" (plies of elliptic
//   section, migration, hairs and loops); Vogel 1979 (even places in a disc).

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "design/fibre_facts.h"

namespace weftlight::cloth {

using design::FibreFacts, design::Yarn;
using draft::System;

/// What a thread's fibres are made for.
struct FibreThread {
  Yarn yarn;
  System system = System::kWarp;
  float width_mm = 0, height_mm = 0;  // of the flattened section
  float diameter_mm = 0;              // of the round thread, which the count goes with
  float length_mm = 0;
  bool repeats = true;  // every length_mm: all waves along the thread have whole numbers in it
  uint32_t seed = 0;
  float raised = 0;  // finish: 0 to 1, more and longer hair
};

/// The dye of one fibre, which in a melange is not that of its neighbours.
struct FibreDye {
  float depth = 1;  // absorption, relative to the thread's
  float hue = 0;    // warmer above 0, cooler below, as Texel::hue

  /// A thread's colour with this hue; linear RGB, up to 1.
  glm::vec3 tinted(glm::vec3 thread_colour) const;
  /// What the fibre's own surface shows of it: that to the power of the depth (Bouguer).
  glm::vec3 on_surface(glm::vec3 thread_colour) const;
};

/// One fibre within its ply.
struct PlyFibre {
  int ply = 0;
  glm::vec2 place{0};  // distance (0..1 of the ply's radius) and angle at the start
  float radius_mm = 0;
  float migration = 0;  // phases of the waves
  glm::vec2 wander{0};
  FibreDye dye;
};

/// A hair leaves the surface of the thread and ends outside it; a loop comes back.
struct StrayFibre {
  bool loop = false;
  float start_mm = 0;  // along the thread
  float turn_rad = 0;  // around the section: 0 towards +across, pi / 2 up
  float length_mm = 0;
  float reach_mm = 0;          // of a loop
  glm::vec3 lean{0}, bend{0};  // of a hair: its first direction (across, up, along) and how it curves, 1/mm
  float radius_mm = 0;
  FibreDye dye;
};

struct YarnFibres {
  int plies = 1;
  float ply_offset = 0;        // of a ply's axis from the thread's, in the thread's radius
  glm::vec2 ply_half{1, 1};    // half a ply's section towards the axis and across that, in the thread's radius
  float phase = 0;             // of the plies, radians
  float ply_turns_per_mm = 0;  // signed: from +across towards up along the thread
  float fibre_turns_per_mm = 0;
  float migration = 0, migrations_per_mm = 0;
  float wander = 0, wander_per_mm = 0;  // amplitude in the ply's radius; waves
  std::vector<PlyFibre> fibres;
  std::vector<StrayFibre> strays;
};

/// Largest step along the thread that follows its twist, mm.
float fibre_step_mm(const Yarn& yarn);

/// Fibres in a section, all plies: of the count (tex) by the fineness, for the longer way of a twisted fibre.
int fibre_count(const FibreThread& thread);
/// Hairs and loops on the length of a thread.
int stray_count(const FibreThread& thread);
/// Mean length of a hair or loop with its bends, mm.
float stray_length_mm(const FibreThread& thread);

/// Deterministic by the seed.
YarnFibres yarn_fibres(const FibreThread& thread);

/// Place in the unit disc of the section, along mm from the start.
glm::vec2 fibre_place(const YarnFibres& yarn, const PlyFibre& fibre, float along_mm);

}  // namespace weftlight::cloth
