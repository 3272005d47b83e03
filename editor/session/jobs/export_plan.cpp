#include "session/jobs/export_plan.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/decimals.h"
#include "base/text.h"
#include "texture_set/set_folder.h"

namespace weftlight::session {

using base::tr;
using texture_set::ThreadDetail, texture_set::at_lod, texture_set::check_set_folder, texture_set::file_name_of,
    texture_set::kLods, texture_set::kTileOfYarns, texture_set::listed_files, texture_set::set_density;

namespace fs = std::filesystem;

std::vector<ExportJob> jobs_of(const ExportPlan& plan, const Design& design, const std::string& draft_path,
                               const std::string& version) {
  const fs::path file(draft_path.empty() ? "untitled.wif" : draft_path);
  const std::string name = file_name_of(file.stem().string());
  std::vector<ExportJob> out;
  for (const ExportTarget* target : plan.targets) {
    TextureSetOptions o;
    o.target = target, o.name = name, o.source = file.filename().string(), o.draft_path = draft_path;
    o.program_version = version, o.size = plan.size, o.alpha = plan.alpha;
    o.tile_mm = plan.tile_cm < 0 ? kTileOfYarns : 10 * plan.tile_cm;
    if (plan.by_density) set_density(o, design, plan.texels_per_mm);
    if (!target->raw) o.mips = plan.mips;
    for (int lod = 0; lod < (plan.lods && !target->raw ? kLods : 1); ++lod) {
      const TextureSetOptions level = at_lod(o, lod);
      fs::path folder = fs::path(plan.folder) / level.name;
      if (plan.targets.size() > 1) folder /= target->id;
      out.push_back({folder.string(), level});
    }
  }
  return out;
}

ExportFigures figures_of(const Design& design, const std::vector<ExportJob>& jobs) {
  ExportFigures out;
  for (const ExportJob& job : jobs) {
    const SetFigures set = texture_set::figures_of(design, job.options);
    if (out.images == 0) out.set = set;
    out.texel_bytes += set.texel_bytes;
    if (job.options.detail == ThreadDetail::kAll) out.images += set.images;
  }
  const SetFigures& s = out.set;
  if (s.ends == 0 || s.picks == 0) {
    out.why.emplace_back(tr("There is no cloth: the draft needs at least one end and one pick."));
    return out;
  }
  out.texels_a_thread = std::min(static_cast<float>(s.size.width) / static_cast<float>(s.ends),
                                 static_cast<float>(s.size.height) / static_cast<float>(s.picks));
  constexpr float kMinTexels = 2;
  if (out.texels_a_thread < kMinTexels)
    out.why.emplace_back(tr("Threads are less than two texels wide and blur; use more texels or a smaller tile."));
  return out;
}

std::vector<std::string> in_the_way(const std::vector<ExportJob>& jobs) {
  std::vector<std::string> out;
  for (const ExportJob& job : jobs) {
    std::string there = problem_of(check_set_folder(job.folder, job.options));
    if (!there.empty()) out.push_back(std::move(there));
  }
  return out;
}

int replaced_files(const std::vector<ExportJob>& jobs) {
  int count = 0;
  for (const ExportJob& job : jobs) count += static_cast<int>(listed_files(job.folder).size());
  return count;
}

void toggle(ExportPlan& plan, const ExportTarget* target) {
  const auto at = std::find(plan.targets.begin(), plan.targets.end(), target);
  if (at == plan.targets.end()) plan.targets.push_back(target);
  else if (plan.targets.size() > 1) plan.targets.erase(at);
}

std::string shown_bytes(int64_t bytes) {
  constexpr const char* kUnits[] = {"kB", "MB", "GB"};
  double shown = static_cast<double>(bytes) / 1000;
  size_t unit = 0;
  while (shown >= 999.5 && unit + 1 < std::size(kUnits)) shown /= 1000, ++unit;
  char text[32];
  std::snprintf(text, sizeof text, shown < 9.95 ? "%.1f %s" : "%.0f %s", shown, kUnits[unit]);
  return base::with_decimal_point(text);
}

}  // namespace weftlight::session
