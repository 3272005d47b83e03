#pragma once
// A list of stages, run in order. A stage is a function with inputs, a key and an output. Its inputs are parts of the
// design and outputs of stages above it. Its key is the versions that its inputs had when it ran last: it runs again
// only if one of them has a newer version. Errors, stopping and progress are handled here, once for all stages.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <stop_token>
#include <vector>

#include "base/result.h"

namespace weftlight::render_data {

struct StageWork;

/// What stages read and make: first the parts of the design, then one output a stage (stages.cpp).
enum class Node : uint8_t {
  kDraft,
  kThreadTable,
  kYarnShapes,
  kYarnLobes,
  kFinish,
  kShadows,
  kEngine,
  kDrape,
  kLights,

  kDrawdown,
  kPeriod,
  kFrontThreads,
  kBackThreads,
  kFrontMaps,
  kFrontMips,
  kBackMaps,
  kBackMips,
  kCubeMaps,
  kCrossings,
  kLobes,
  kClothBlock,
  kResponse,
  kThreadErrors,
  kEngineBlock,
  kThreadRecords,
  kClothLobes,
  kMesh,
  kLightRig,
};
inline constexpr size_t kNodes = static_cast<size_t>(Node::kLightRig) + 1;

/// How much of a node changed.
enum class Change : uint8_t { kNone, kPart, kAll };

/// kQuick: for the next frame. Full bakes use few texels and threads; painted cells update only the front, and of many
/// only the visible part; the far-field response is kept; sky visibility uses few rays. kFull brings everything up to
/// date. kOnce: like kFull for a single picture; only packed() is kept, and the next design is computed from scratch.
enum class Effort : uint8_t { kQuick, kFull, kOnce };

/// What a run of a stage did to its output.
struct Outcome {
  Change change = Change::kAll;
  bool rough = false;  // good enough for a quick update: the next full one makes it again as a whole
};

/// What a stage does in a quick update. What it leaves undone, the next full update does.
enum class WhenQuick : uint8_t {
  kRuns,
  kWaitsForWhole,  // runs only if an input changed as a whole
  kWaitsOnceMade,  // runs only if it has no output yet
  kWaits,
};

/// A few nodes, in a list that is known when the program is compiled.
class Nodes {
 public:
  constexpr Nodes(std::initializer_list<Node> nodes) : count_(nodes.size()) {
    std::ranges::copy(nodes, nodes_.begin());
  }
  constexpr const Node* begin() const { return nodes_.data(); }
  constexpr const Node* end() const { return nodes_.data() + count_; }

 private:
  std::array<Node, 8> nodes_{};
  size_t count_;
};

struct Stage {
  Node output;
  const char* name;
  Nodes inputs;
  base::Result<Outcome> (*run)(StageWork& work,
                               Change input);  // after an error the stages that depend on it do not run
  WhenQuick quick = WhenQuick::kRuns;
};

/// Follows an update from outside. Both functions of it may be called from several threads at once.
struct StageWatch {
  std::stop_token stop;                                                   // checked before each stage
  std::function<void(const char* stage, size_t done, size_t of)> starts;  // a stage starts; may be empty
};

/// The versions and keys of all nodes.
class StageKeys {
 public:
  /// A part of the design differs from that of the last update.
  void changed(Node part);
  /// Runs those stages of the list whose key changed. False if it was stopped: the next run goes on from there. Lists
  /// that share no outputs may run at the same time.
  bool run(std::span<const Stage> list, StageWork& work, Effort effort, const StageWatch& watch);
  /// Whether all outputs of the list are there, or the first error. It stays until its stage has run again.
  base::Result<void> made(std::span<const Stage> list) const;

 private:
  struct State {
    uint64_t version = 0, whole = 0;  // of the last change, and of the last change of all of it; 0: never made
    bool rough = false;
    base::Result<void> made;
    std::vector<uint64_t> key;
  };
  State& at(Node node) { return states_[static_cast<size_t>(node)]; }
  const State& at(Node node) const { return states_[static_cast<size_t>(node)]; }
  Change input_change(const Stage& stage) const;
  void run_stage(const Stage& stage, StageWork& work, Change input, bool quick);

  std::array<State, kNodes> states_;
};

}  // namespace weftlight::render_data
