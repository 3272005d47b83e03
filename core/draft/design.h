#pragma once
// The Design: the one value that is edited and saved. Draft, yarns, notes, look and
// scene; drawdown, maps, meshes and pictures are derived from it, never stored in it.

#include <string>
#include <utility>
#include <vector>

#include "draft/draft.h"
#include "draft/finish.h"
#include "draft/yarn.h"

namespace weftlight::draft {

/// Shading method of methods (MODEL, section 5); kAuto chooses by footprint.
enum class Method { kAuto, kFlat, kVrst03, kIrawan, kCloth, kRepeat, kCell, kYarn, kEngine, kReference };

struct Look {
  Method method = Method::kAuto;
  float tolerance = 0.15f;         // relative RMSE that kAuto may spend
  float exposure_ev = 0.0f;        // stops
  bool automatic_exposure = true;  // beside these, stops by what the cloth reflects; never in scene-linear pictures
  bool operator==(const Look&) const = default;
};

/// Angles in degrees. View and light azimuth 0 face the cloth's front (+z of the mesh), positive to
/// its right; elevation 90 is straight above.
struct Scene {
  std::string mesh = "tablecloth";  // name in presets/meshes, or a path to .glb/.gltf
  bool simulated_drape = false;     // simulated with this cloth's own stiffness, not with that of its kind
  float view_azimuth = 25, view_elevation = 22;
  float view_distance = 1.0f;  // 1 frames the mesh
  float pan_x = 0, pan_y = 0;  // in frame widths
  float light_azimuth = -50, light_elevation = 48;
  float light_strength = 1.0f;  // irradiance scale of the key light
  float sky_strength = 1.0f;    // scale of the soft environment
  Rgb background{0.93f, 0.925f, 0.91f};
  // A set-up's name (lights.h): the soft light around and the key light's colour. Or a path to an .hdr or .exr, whose
  // light all of it then is; the light's azimuth turns it, and it may show behind the cloth.
  std::string lights = "studio";
  bool surroundings = false;
  bool operator==(const Scene&) const = default;
};

/// Which grids rule and which follow: the threading with what lifts its shafts, the threading with the liftplan
/// alone, or the drawdown, from which threading and lifts are found.
enum class Leading { kThreading, kLiftplan, kDrawdown };

/// How a draft is worked, and on what loom.
struct Loom {
  Leading leading = Leading::kThreading;
  bool locked = false;           // what follows cannot be painted
  int shafts = 0, treadles = 0;  // 0..kMaxShafts that the loom has; 0: not said
  int next_pick = 0;             // the pick that is woven next, 0..kMaxThreads
  bool operator==(const Loom&) const = default;
};

/// A weave that was generated, and its numbers, so that they can be changed afterwards.
struct WeaveUse {
  std::string weave;                                        // its id (generators.h)
  std::vector<std::pair<std::string, std::string>> values;  // id of a number -> value as text; by id
  int first_end = 0, ends = 0, first_pick = 0, picks = 0;   // the threads that it made
  bool operator==(const WeaveUse&) const = default;
};

/// A view of the cloth under a name: what hangs, how it is lit, where the camera stands.
struct NamedView {
  std::string name;
  Scene scene;
  bool flat = false;  // a flat swatch in the place of the scene's mesh
  bool operator==(const NamedView&) const = default;
};

/// Ends or picks that are kept under a name, to be woven together with others. Colours and yarns that the design no
/// longer has are those of its first.
struct ThreadSection {
  std::string name;
  BitMatrix rows;  // threads x shafts (of ends), x treadles, or x shafts of a liftplan
  Threads threads;
  ShedControl drive = ShedControl::kTreadling;  // what the rows of picks name
  bool operator==(const ThreadSection&) const = default;
};

/// The sections of a system and the order in which they make its threads (generators/sections.h).
struct Assembly {
  std::vector<ThreadSection> sections;
  std::string order;  // "A 4x, (B C) 3x, A"
  bool operator==(const Assembly&) const = default;
};

struct Design {
  std::string title, author;
  std::vector<std::string> notes;
  Draft draft;
  std::vector<Yarn> yarns{Yarn{}};  // never empty; as they are spun
  Finish finish;                    // of the cloth: finished(yarns, finish) are those of it
  Look look;
  Scene scene;
  Loom loom;
  std::vector<WeaveUse> weaves;  // the last is the latest
  std::vector<NamedView> views;  // no two of one name
  Assembly warp_assembly, weft_assembly;
  bool operator==(const Design&) const = default;
};

/// True when the draft is consistent and every thread's yarn exists.
bool is_consistent(const Design& design);

}  // namespace weftlight::draft
