// `export`: texture sets of many drafts for several targets in one call. A draft's failure never stops the others; what
// failed is told together at the end.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>

#include "base/caught.h"
#include "base/loops.h"
#include "commands/commands.h"
#include "files/design_drape.h"
#include "files/files.h"
#include "files/zip.h"
#include "texture_set/material_files.h"
#include "texture_set/set_folder.h"
#include "texture_set/texture_set.h"

namespace weftlight::commands {
namespace {

namespace fs = std::filesystem;

constexpr auto kWatchStep = std::chrono::milliseconds(500);

struct Job {
  std::string file, folder;
  TextureSetOptions options;
  std::string form;         // of the folder
  fs::file_time_type seen;  // of the file, before it was read
};

/// What the jobs share and add to.
struct Run {
  const ExportOptions& options;
  const Mesh& mesh;
  std::mutex console;
  std::atomic<int> worst{kDone}, written{0}, kept{0};
  std::vector<std::string> failed;
};

bool is_power_of_two(int n) { return n > 0 && (n & (n - 1)) == 0; }

/// Files as they are; of folders every .wif within, in the order of their names.
std::vector<std::string> drafts_of(const std::vector<std::string>& given) {
  std::vector<std::string> out;
  std::error_code ec;
  for (const std::string& path : given) {
    if (!fs::is_directory(path, ec)) {
      out.push_back(path);
      continue;
    }
    std::vector<std::string> within;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path, ec)) {
      std::string extension = entry.path().extension().string();
      for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      if ((extension == ".wif" || extension == ".wifw") && entry.is_regular_file(ec))
        within.push_back(entry.path().string());
    }
    std::sort(within.begin(), within.end());
    out.insert(out.end(), within.begin(), within.end());
  }
  return out;
}

/// Time of the last change, ISO 8601; the same for the same file.
std::string changed(const std::string& path) {
  std::error_code ec;
  const auto time = fs::last_write_time(path, ec);
  if (ec) return TextureSetOptions{}.modified;
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::file_clock::to_sys(time).time_since_epoch())
          .count();
  const std::time_t at = static_cast<std::time_t>(seconds);
  std::tm parts{};
  gmtime_r(&at, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

/// The folder's way from the output, by the template; no part of it leaves the output.
std::string folder_name(const std::string& form, const std::string& name, Target target, int size) {
  fs::path out;
  for (const fs::path& part :
       fs::path(filled(form, {{"name", name}, {"target", target_name(target)}, {"size", std::to_string(size)}})))
    if (part != "." && part != ".." && part != "/") out /= file_name_of(part.string());
  return out.string();
}

std::string folder_of(const std::string& out, const std::string& form, const TextureSetOptions& o) {
  return (fs::path(out) / folder_name(form, o.name, o.target, o.size)).string();
}

/// One folder a draft and target; drafts of the same name are numbered.
std::vector<Job> jobs_of(const ExportOptions& options, const std::vector<Target>& targets) {
  const std::string form = !options.name.empty() ? options.name : targets.size() > 1 ? "{name}/{target}" : "{name}";
  std::vector<Job> jobs;
  std::set<std::string> taken;
  for (const std::string& file : drafts_of(options.files)) {
    const fs::path path(file);
    const std::string stem = file_name_of(path.stem().string());
    std::string name = stem;
    for (int n = 2; !taken.insert(name).second; ++n) name = stem + "-" + std::to_string(n);
    for (const Target target : targets) {
      TextureSetOptions o;
      o.target = target, o.name = name, o.source = path.filename().string(), o.draft_path = file;
      o.program_version = WEFTLIGHT_VERSION, o.size = options.size, o.force = options.force;
      o.alpha = alpha_named(options.alpha).value_or(Alpha::kAuto);
      o.distance_m = options.distance_m, o.tile_mm = 10 * options.tile_cm;
      o.modified = changed(file);
      if (!options.mips.empty()) o.mips = options.mips == "dds" ? MipContainer::kDds : MipContainer::kKtx2;
      std::error_code ec;
      jobs.push_back({file, folder_of(options.out, form, o), o, form, fs::last_write_time(file, ec)});
    }
  }
  return jobs;
}

std::string write_archive(const Job& job, bool force) {
  std::error_code ec;
  const std::string path = job.folder + ".zip";
  if (!force && fs::exists(path, ec) && !lists_archive(job.folder)) {
    return path + ": is not an archive of this set; move it away, or --force to replace it";
  }
  std::vector<ZipEntry> entries;
  const std::string top = fs::path(job.folder).filename().string();
  for (const std::string& name : listed_files(job.folder))
    entries.push_back({top + "/" + name, (fs::path(job.folder) / name).string()});
  return write_zip(path, entries, ZipKind::kPlain);
}

void tell(Run& run, int code, const std::string& problem) {
  const std::lock_guard lock(run.console);
  for (int seen = run.worst; code > seen && !run.worst.compare_exchange_weak(seen, code);) {
  }
  std::fprintf(stderr, "%s\n", problem.c_str());
  run.failed.push_back(problem);
}

/// Of a shipped drape the limper or stiffer one; empty where the one that all drafts share is right.
std::optional<Mesh> hung_by_its_cloth(const Run& run, Design design) {
  design.scene.mesh = run.options.mesh;
  if (run.mesh.index.empty() || drape_key(design) == run.options.mesh) return {};
  return load_design_drape(design).mesh;
}

void run_job(Job job, Run& run) {
  const OpenedDesign opened = open_design(job.file);
  if (!opened.ok) return tell(run, kBadInput, job.file + ": not exported: it cannot be read");
  if (run.options.texels_per_mm > 0) {
    job.options.size = size_for(opened.design, run.options.texels_per_mm, job.options.tile_mm);
    job.folder = folder_of(run.options.out, job.form, job.options);
  }
  job.options.archived = run.options.zip;
  job.options.key = digest(opened.file.bytes + "\n" + key_of(job.options) + "\n" + run.options.mesh);
  if (run.options.resume && is_complete(job.folder, job.options.key)) {
    ++run.kept;
    return;
  }
  for (const std::string& w : warnings_of(opened.design, job.options)) {
    const std::lock_guard lock(run.console);
    std::fprintf(stderr, "%s: %s\n", job.file.c_str(), w.c_str());
  }
  const bool had_archive = lists_archive(job.folder);
  const std::optional<Mesh> hung = hung_by_its_cloth(run, opened.design);
  std::string problem = run.options.zip && !run.options.force && !had_archive && fs::exists(job.folder + ".zip")
                            ? job.folder + ".zip: is not an archive of this set; move it away, or --force to replace it"
                            : write_texture_set(job.folder, opened.design, hung ? *hung : run.mesh, job.options);
  if (problem.empty() && run.options.zip) problem = write_archive(job, true);
  if (!problem.empty()) return tell(run, kNotWritten, job.file + ": not exported: " + problem);
  ++run.written;
  const std::lock_guard lock(run.console);
  std::printf("%s\n", job.folder.c_str());
  std::fflush(stdout);
}

int run_all(const std::vector<Job>& jobs, const ExportOptions& options, const Mesh& mesh) {
  Run run{options, mesh, {}, kDone, 0, 0, {}};
  for_each_job(static_cast<int>(jobs.size()), options.jobs, [&](int j) {
    const Job& job = jobs[static_cast<size_t>(j)];
    const std::string thrown = caught([&] { run_job(job, run); });
    if (!thrown.empty()) tell(run, kNotWritten, job.file + ": not exported: " + thrown);
  });
  if (jobs.size() > 1) {
    std::fprintf(stderr, "weftlight: %d sets written, %d were complete, %zu failed\n", run.written.load(),
                 run.kept.load(), run.failed.size());
    for (const std::string& problem : run.failed) std::fprintf(stderr, "  %s\n", problem.c_str());
  }
  return run.worst;
}

/// Exports again whatever changes since its job was made, until the program is ended.
void watch(std::vector<Job> jobs, const ExportOptions& options, const Mesh& mesh) {
  std::fprintf(stderr, "weftlight: watching %zu sets; Ctrl+C ends\n", jobs.size());
  while (true) {
    std::this_thread::sleep_for(kWatchStep);
    std::vector<Job> changed_jobs;
    for (Job& job : jobs) {
      std::error_code ec;
      const auto now = fs::last_write_time(job.file, ec);
      if (!ec && now != job.seen) job.seen = now, changed_jobs.push_back(job);
    }
    if (!changed_jobs.empty()) run_all(changed_jobs, options, mesh);
  }
}

int usage(const std::string& what) {
  std::fprintf(stderr, "weftlight: %s\n", what.c_str());
  return kUsage;
}

}  // namespace

int export_command(const ExportOptions& options) {
  std::vector<Target> targets;
  for (const std::string& name : options.targets) {
    const std::optional<Target> target = target_named(name);
    if (!target) return usage("there is no target '" + name + "'");
    if (std::find(targets.begin(), targets.end(), *target) == targets.end()) targets.push_back(*target);
  }
  if (!is_power_of_two(options.size) || options.size < 16 || options.size > 8192)
    return usage("--size " + std::to_string(options.size) + ": give a power of two from 16 to 8192");
  if (targets.size() > 1 && !options.name.empty() && options.name.find("{target}") == std::string::npos)
    return usage("--name " + options.name + ": several targets need {target} in it");
  const bool mesh_wanted = std::any_of(targets.begin(), targets.end(), needs_mesh);
  const ReadMesh mesh = mesh_wanted ? load_drape(options.mesh) : ReadMesh{Mesh{}, {}};
  if (!mesh.mesh) {
    std::fprintf(stderr, "weftlight: --mesh: %s\n", mesh.error.c_str());
    return kBadInput;
  }
  const std::vector<Job> jobs = jobs_of(options, targets);
  if (jobs.empty()) {
    std::fprintf(stderr, "%s: there is no .wif in it; give drafts or a folder of drafts\n", options.files[0].c_str());
    return kBadInput;
  }
  const int code = run_all(jobs, options, *mesh.mesh);
  if (options.watch) watch(jobs, options, *mesh.mesh);
  return code;
}

}  // namespace weftlight::commands
