#pragma once
// The Design: the one value that is edited and saved. Draft, yarns, finish, notes,
// plan of the cloth, look, scene and loom. Drawdown, maps, meshes and pictures are derived from it, never stored in it.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "design/cloth_plan.h"
#include "design/finish.h"
#include "design/yarn.h"
#include "draft/draft.h"

namespace weftlight::design {

using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::System, draft::Threads;

/// Shading method (methods.h); kAuto chooses by the pixel footprint.
enum class Method { kAuto, kFlat, kVrst03, kIrawan, kCloth, kRepeat, kCell, kYarn, kEngine, kReference };

struct Look {
  Method method = Method::kAuto;
  float tolerance = 0.15f;         // relative RMSE that kAuto may reach
  float exposure_ev = 0.0f;        // EV (stops)
  bool automatic_exposure = true;  // adds an exposure by the cloth's reflectance; not in scene-linear pictures
  bool operator==(const Look&) const = default;
};

/// Angles in degrees. View and light azimuth 0 face the cloth's front (+z of the mesh), positive to
/// its right; elevation 90 is straight above.
struct Scene {
  std::string mesh = "tablecloth";  // name in presets/meshes, or a path to .glb/.gltf
  bool simulated_drape = false;     // simulate this fabric's weight and stiffness; false: a generic drape
  float view_azimuth = 25, view_elevation = 22;
  float view_distance = 1.0f;  // 1 frames the mesh
  float pan_x = 0, pan_y = 0;  // in frame widths
  float light_azimuth = -50, light_elevation = 48;
  float light_strength = 1.0f;  // irradiance scale of the key light
  float sky_strength = 1.0f;    // scale of the soft environment
  Rgb background{0.93f, 0.925f, 0.91f};
  // Id of a lighting preset (lights.h): environment light and the key light's colour. Or the path of an .hdr or .exr
  // environment map, then the only light; the light's azimuth turns it, and `surroundings` shows it behind the cloth.
  std::string lights = "studio";
  bool surroundings = false;
  bool operator==(const Scene&) const = default;
};

/// Which grids lead; the others follow. The threading with tie-up and treadling, the threading with the liftplan, or
/// the drawdown, from which threading and lifts are factored.
enum class Leading { kThreading, kLiftplan, kDrawdown };

/// Dents of a reed: every end in one of its own, and as many empty ones as a sleying can have between them.
inline constexpr int kMaxLoomDents = draft::kMaxThreads * kMaxSleyingDents;

/// How the draft is edited, the limits of the loom, and the places kept at it.
struct Loom {
  Leading leading = Leading::kThreading;
  bool locked = false;           // grids that follow cannot be painted
  int shafts = 0, treadles = 0;  // of the loom, 0..kMaxShafts; 0: unknown
  int next_pick = 0;             // woven next, 0..kMaxThreads
  int next_end = 0;              // threaded next: those before it are in their heddles; 0..kMaxThreads
  int next_dent = 0;             // sleyed next, 0..kMaxLoomDents
  bool tabby_between = false;    // a tabby pick before each pattern pick
  bool at_tabby = false;         // a tabby pick is woven before next_pick
  bool second_tabby = false;     // it is, or the next one will be, the second of the two tabby sheds
  bool operator==(const Loom&) const = default;
};

/// A generated weave with its parameters, kept so that they can be changed later.
struct WeaveUse {
  std::string weave;                                        // its id (generators/table.h)
  std::vector<std::pair<std::string, std::string>> values;  // parameter id -> value as text; sorted by id
  int first_end = 0, ends = 0, first_pick = 0, picks = 0;   // the threads it covers
  bool operator==(const WeaveUse&) const = default;
};

/// A named view of the cloth: mesh, lighting and camera.
struct NamedView {
  std::string name;
  Scene scene;
  bool flat = false;  // a flat swatch instead of the scene's mesh
  bool operator==(const NamedView&) const = default;
};

/// A named section of ends or picks, for use in an Assembly. A colour or yarn that the design no longer has is read as
/// its first.
struct ThreadSection {
  std::string name;
  BitMatrix rows;  // threads x shafts (of ends), x treadles, or x shafts of a liftplan
  Threads threads;
  ShedControl shed_control = ShedControl::kTreadling;  // what the rows of picks name: treadles or shafts
  bool operator==(const ThreadSection&) const = default;
};

/// The sections of a system and the order in which they make its threads (generators/sections.h).
struct Assembly {
  std::vector<ThreadSection> sections;
  std::string order;  // "A 4x, (B C) 3x, A"
  bool operator==(const Assembly&) const = default;
};

struct Design;

/// A state of the design kept under a name, as version_of() leaves it (versions.h). It is never changed, so that copies
/// of the design share it.
struct Version {
  std::string name;
  std::shared_ptr<const Design> design;  // never null; without versions of its own
  /// By the values of the designs.
  bool operator==(const Version& other) const;
};

struct Design {
  std::string title, author;
  std::vector<std::string> notes;
  Draft draft;
  std::vector<Yarn> yarns{Yarn{}};  // never empty; before finishing
  Finish finish;                    // finished(yarns, finish) are the yarns of the cloth
  ClothPlan plan;
  Look look;
  Scene scene;
  Loom loom;
  std::vector<WeaveUse> weaves;  // latest last
  std::vector<NamedView> views;  // names are unique
  Assembly warp_assembly, weft_assembly;
  std::vector<Version> versions;  // names are unique
  bool operator==(const Design&) const = default;
};

/// Distance from thread to thread, in mm: the thread's own, otherwise its thickness, otherwise its yarn's.
double spacing_of(const Design& design, System system, int thread);

/// True when the draft is consistent and every thread's yarn exists.
bool is_consistent(const Design& design);

}  // namespace weftlight::design
