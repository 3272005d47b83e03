#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>

#include "base/loops.h"
#include "commands/commands.h"
#include "files/files.h"
#include "texture_set/material_files.h"
#include "texture_set/texture_set.h"

namespace weftlight::commands {
namespace {

struct Job {
  std::string file, folder;
  TextureSetOptions options;
};

bool is_power_of_two(int n) { return n > 0 && (n & (n - 1)) == 0; }

/// One folder a draft, named after its file; drafts of the same name are numbered.
std::vector<Job> jobs_of(const ExportOptions& options, Target target) {
  std::vector<Job> jobs;
  std::set<std::string> taken;
  for (const std::string& file : options.files) {
    const std::filesystem::path path(file);
    const std::string stem = file_name_of(path.stem().string());
    std::string name = stem;
    for (int n = 2; !taken.insert(name).second; ++n) name = stem + "-" + std::to_string(n);
    jobs.push_back({file,
                    (std::filesystem::path(options.out) / name).string(),
                    {target, name, path.filename().string(), file, WEFTLIGHT_VERSION, options.size, options.force}});
  }
  return jobs;
}

int run_job(const Job& job, const Mesh& mesh, std::mutex& console) {
  const OpenedDesign opened = open_design(job.file);
  if (!opened.ok) return kBadInput;
  const std::string problem = write_texture_set(job.folder, opened.design, mesh, job.options);
  const std::lock_guard lock(console);
  if (!problem.empty()) {
    std::fprintf(stderr, "%s:0: not exported: %s\n", job.file.c_str(), problem.c_str());
    return kNotWritten;
  }
  std::printf("%s\n", job.folder.c_str());
  return kDone;
}

}  // namespace

int export_command(const ExportOptions& options) {
  const std::optional<Target> target = target_named(options.target);
  if (!target) {
    std::fprintf(stderr, "weftlight: there is no target '%s'\n", options.target.c_str());
    return kUsage;
  }
  if (!is_power_of_two(options.size) || options.size < 16 || options.size > 8192) {
    std::fprintf(stderr, "weftlight: --size %d: give a power of two from 16 to 8192\n", options.size);
    return kUsage;
  }
  const ReadMesh mesh = needs_mesh(*target) ? load_drape(options.mesh) : ReadMesh{Mesh{}, {}};
  if (!mesh.mesh) {
    std::fprintf(stderr, "weftlight: --mesh: %s\n", mesh.error.c_str());
    return kBadInput;
  }
  const std::vector<Job> jobs = jobs_of(options, *target);
  std::vector<int> codes(jobs.size(), kDone);
  std::mutex console;
  for_each_job(static_cast<int>(jobs.size()), options.jobs, [&](int j) {
    const size_t job = static_cast<size_t>(j);
    codes[job] = run_job(jobs[job], *mesh.mesh, console);
  });
  return *std::max_element(codes.begin(), codes.end());
}

}  // namespace weftlight::commands
