#pragma once
// Which threads of the cloth have their fibres made for a patch, and what that costs.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/yarn_fibres.h"
#include "reference/fibre_patch.h"
#include "reference/thread_paths.h"

namespace weftlight::reference {

using cloth::FibreThread;

// Straight pieces of one hair and of one loop.
inline constexpr int kHairPieces = 16, kLoopPieces = 8;
// Hairs of threads up to this far outside a patch that repeats reach into it.
inline constexpr float kHairReach_mm = 1;

/// One thread across the patch.
struct PlannedThread {
  System system = System::kWarp;
  int thread = 0;
  float centre_mm = 0;   // across; may be a wrapped copy outside the patch
  bool core = true;      // false: only its hairs reach into the patch
  FibreThread made_for;  // length and seed are those of the whole patch
  int points = 0;        // of each fibre
};

struct FibrePlan {
  glm::vec2 low{0}, high{0};         // of what is made, with margins
  bool repeats[2] = {false, false};  // along u, along v
  bool cut = false;                  // along the edges of the patch
  float pad_mm = 0;                  // how far fibres run beyond both ends
  std::vector<PlannedThread> threads;
  FibreFigures figures;

  float start(System s) const { return s == System::kWarp ? low.y : low.x; }
  float length(System s) const { return s == System::kWarp ? high.y - low.y : high.x - low.x; }
  float middle(System s) const { return start(s) + 0.5f * length(s); }
  bool repeats_along(System s) const { return repeats[s == System::kWarp ? 1 : 0]; }
};

/// For a picture: with margins, so that no ray of the patch sees an edge. Hairs and loops are counted roughly.
FibrePlan plan_fibres(const ThreadPaths& paths, const FibreOptions& options);
/// As if cut out along the edges of the patch: the threads whose centre lines lie in it, from edge to edge.
FibrePlan plan_cut_patch(const ThreadPaths& paths, const FibreOptions& options);

/// The most memory that these fibres, strays and curves take while they are made.
int64_t bytes_of(const FibreFigures& figures);

}  // namespace weftlight::reference
