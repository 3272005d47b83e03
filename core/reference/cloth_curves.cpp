#include "reference/cloth_curves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/text.h"
#include "design/fibre_facts.h"
#include "reference/fibre_plan.h"
#include "reference/thread_curves.h"

namespace weftlight::reference {

using base::ErrorKind, base::arg, base::failure, base::fill, base::tr;
using cloth::Cloth, cloth::CurveGroup, cloth::Curves, cloth::FibreDye, cloth::Linear, cloth::fibre_count,
    cloth::stray_count;
using design::Twist, design::Yarn;

namespace {

int64_t points_of(const PlannedThread& thread, CurveDetail detail) {
  const int64_t along = thread.points;
  if (detail == CurveDetail::kThreads) return along;
  if (detail == CurveDetail::kPlies) return along * std::max(thread.made_for.yarn.plies, 1);
  return along * fibre_count(thread.made_for) + int64_t{kHairPieces + 1} * stray_count(thread.made_for);
}

base::Result<void> within(const FibrePlan& plan, const CurveOptions& options) {
  if (plan.threads.empty()) return failure(ErrorKind::kInput, tr("no thread lies in this patch; make it larger"));
  int64_t points = 0;
  for (const PlannedThread& thread : plan.threads) points += points_of(thread, options.detail);
  if (points <= options.max_points) return {};
  return failure(ErrorKind::kInput,
                 fill(tr("this patch has {points} points, and {most} are allowed; make it smaller, or give plies or "
                         "threads instead of fibres"),
                      arg("points", points), arg("most", options.max_points)));
}

CurveGroup group_of(System system, int index, const Yarn& yarn) {
  CurveGroup group;
  group.name = (system == System::kWarp ? "Warp_" : "Weft_") + std::to_string(index + 1);
  group.ior = yarn.lobes.ior;
  // A distribution of micro-slopes is sqrt(2) times as wide as their RMS; roughness is the root of that width.
  group.roughness = std::clamp(std::sqrt(std::sqrt(2.0f) * yarn.lobes.across_width), 0.05f, 1.0f);
  group.metallic = design::fibre_facts(yarn).metallic;
  const float sign = yarn.twist == Twist::kNone ? 0.0f : yarn.twist == Twist::kZ ? 1.0f : -1.0f;
  group.turns_per_m = sign * yarn.turns_per_m;
  return group;
}

/// Appends the curves of one thread to its group.
class ThreadWriter {
 public:
  ThreadWriter(CurveGroup& group, const ThreadCurves& curves, const ThreadFibres& made, Linear colour)
      : group_(group), curves_(curves), made_(made), colour_(colour) {}

  void write(CurveDetail detail) {
    const int along = made_.plan->points;
    if (detail == CurveDetail::kThreads) curves_.thread(add(along));
    if (detail == CurveDetail::kPlies)
      for (int ply = 0; ply < made_.yarn.plies; ++ply) curves_.ply(ply, add(along));
    if (detail != CurveDetail::kFibres) return;
    for (const PlyFibre& fibre : made_.yarn.fibres) curves_.fibre(fibre, add(along, fibre.dye));
    for (const PlacedStray& stray : made_.strays)
      curves_.stray(stray, add(pieces_of(stray.fibre) + 1, stray.fibre.dye));
  }

 private:
  glm::vec4* add(int points, const FibreDye& dye = {}) {
    const glm::vec3 shown = dye.on_surface({colour_.r, colour_.g, colour_.b});
    group_.points_in.push_back(points);
    group_.colour.push_back({shown.r, shown.g, shown.b});
    group_.thread.push_back(made_.plan->thread + 1);
    const size_t first = group_.points.size();
    group_.points.resize(first + static_cast<size_t>(points));
    return group_.points.data() + first;
  }

  CurveGroup& group_;
  const ThreadCurves& curves_;
  const ThreadFibres& made_;
  Linear colour_;
};

}  // namespace

base::Result<Curves> cloth_curves(const Cloth& cloth, const CurveOptions& options) {
  if (cloth.ends.empty() || cloth.picks.empty() || !(cloth.width_mm > 0) || !(cloth.depth_mm > 0))
    return failure(ErrorKind::kInput, tr("the cloth has no size"));
  ThreadPaths paths(cloth);
  FibreOptions patch;
  patch.low_mm = options.low_mm, patch.high_mm = options.high_mm;
  patch.raised = options.raised, patch.seed = options.seed;
  const FibrePlan plan = plan_cut_patch(paths, patch);
  if (auto room = within(plan, options); !room) return base::failed(room);
  paths.compute_lines();
  std::map<std::pair<System, int>, CurveGroup> groups;
  for (const PlannedThread& thread : plan.threads) {
    const ThreadBody& body = paths.threads(thread.system)[static_cast<size_t>(thread.thread)];
    const auto [at, first] = groups.try_emplace({thread.system, body.yarn});
    if (first) at->second = group_of(thread.system, body.yarn, cloth.yarns[static_cast<size_t>(body.yarn)]);
    const ThreadFibres made = thread_fibres(plan, thread);
    // A curve has one colour: that of its thread in the middle of the patch.
    const Linear& colour = colour_along(cloth, thread.system, thread.thread, plan.middle(thread.system));
    ThreadWriter(at->second, ThreadCurves(paths, plan, made), made, colour).write(options.detail);
  }
  Curves curves{options.high_mm - options.low_mm, {}};
  for (auto& [key, group] : groups) {
    for (glm::vec4& p : group.points) p = glm::vec4(glm::vec3(p) - glm::vec3(options.low_mm, 0), 2 * p.w);
    curves.groups.push_back(std::move(group));
  }
  return curves;
}

}  // namespace weftlight::reference
