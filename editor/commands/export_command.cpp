// `export`: texture sets of many drafts for several targets in one call. A draft that fails does not stop the others;
// the failures are listed at the end.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <thread>

#include "base/caught.h"
#include "base/hash.h"
#include "base/loops.h"
#include "base/text.h"
#include "base/version.h"
#include "commands/commands.h"
#include "commands/export_options.h"
#include "commands/open_design.h"
#include "commands/progress_line.h"
#include "design/versions.h"
#include "files/design_drape.h"
#include "files/files.h"
#include "files/zip.h"
#include "platform/clock.h"
#include "platform/files_below.h"
#include "platform/start.h"
#include "platform/stop_request.h"
#include "texture_set/export_progress.h"
#include "texture_set/material_files.h"
#include "texture_set/set_folder.h"
#include "texture_set/texture_set.h"
#include "wif/other_formats.h"

namespace weftlight::commands {

using base::arg, base::caught, base::fill, base::for_each_job, base::message, base::problem_of, base::tr, base::tr_n;
using design::Design, design::at_version, design::version_named;
using drape::Mesh;
using files::ZipEntry, files::ZipKind, files::can_drape, files::load_drape, files::load_worn_drape,
    files::plain_zip_size, files::write_zip;
using texture_set::Alpha, texture_set::ExportTarget, texture_set::TextureSetOptions, texture_set::UvUnit,
    texture_set::alpha_named, texture_set::digest, texture_set::file_name_of, texture_set::fill_template,
    texture_set::is_complete, texture_set::kTileOfYarns, texture_set::key_of, texture_set::listed_files,
    texture_set::lists_archive, texture_set::set_density, texture_set::target_named, texture_set::uv_unit_named,
    texture_set::warnings_of, texture_set::write_texture_set;
using texture_set::SharedWork, texture_set::at_lod, texture_set::kLods, texture_set::stopped;
using wif::is_draft_name, wif::is_wif_name;

namespace {

namespace fs = std::filesystem;

constexpr auto kWatchStep = std::chrono::milliseconds(500);

struct Job {
  std::string file, folder;
  std::string version;        // of the draft; empty: the draft as it is
  TextureSetOptions options;  // of the nearest level of detail
  int lod = 0;
  std::string form;         // template of the folder's name
  fs::file_time_type time;  // of the file, before it was read
};

/// A draft that several jobs export: it is read and its problems are printed once. It stays in memory until the last
/// of its jobs is done.
struct SharedDraft {
  std::mutex reading;
  std::shared_ptr<const OpenedDesign> opened;
  std::set<std::string> warnings;  // that were printed
  int jobs = 0;                    // that still need it
};

/// State that all jobs share.
struct ExportRun {
  const ExportOptions& options;
  const Mesh& mesh;
  std::string worn;                           // what sets that show the mesh were made of
  std::map<std::string, SharedDraft> drafts;  // by path
  std::mutex console;
  ProgressMeter progress;
  std::atomic<int> worst{kDone}, written{0}, kept{0}, failed_sets{0};
  std::vector<std::string> failed;
  std::stop_token stop = platform::stop_when_asked();
};

/// The name of the mesh and a hash of it: its file may change.
std::string worn_by(const std::string& name, const Mesh& mesh) {
  uint64_t hash = base::content_hash({});
  const auto add = [&hash](const auto& values) {
    hash = base::content_hash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]}, hash);
  };
  add(mesh.position_mm), add(mesh.normal), add(mesh.tangent), add(mesh.uv_mm), add(mesh.index);
  return name + " " + std::to_string(hash);
}

bool is_power_of_two(int n) { return n > 0 && (n & (n - 1)) == 0; }

/// The files themselves, and every draft below the folders, sorted by name; each once, however often it is named.
std::vector<std::string> drafts_of(const std::vector<std::string>& given) {
  std::vector<std::string> out;
  std::error_code ec;
  for (const std::string& path : given) {
    if (!fs::is_directory(path, ec)) {
      out.push_back(path);
      continue;
    }
    platform::FilesBelow within = platform::files_below(path);
    std::erase_if(within.files, [](const std::string& file) { return !is_draft_name(file); });
    out.insert(out.end(), within.files.begin(), within.files.end());
    for (const std::string& folder : within.unread)
      print_problem(fill(tr("{folder}: the folder cannot be read; its drafts are left out"), arg("folder", folder)));
  }
  std::set<fs::path> seen;
  std::erase_if(out,
                [&seen](const std::string& file) { return !seen.insert(fs::path(file).lexically_normal()).second; });
  return out;
}

/// Time of the last change of the file, ISO 8601.
std::string changed(const std::string& path) {
  std::error_code ec;
  const auto time = fs::last_write_time(path, ec);
  if (ec) return TextureSetOptions{}.modified;
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::file_clock::to_sys(time).time_since_epoch())
          .count();
  const std::tm parts = platform::utc_time(seconds);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

constexpr const char* kNameFields = "{name}, {target}, {size}";

/// What is wrong with a template of folders, or an empty string: a way out of the output folder, a field that there is
/// not, or a brace alone.
std::string template_problem(const std::string& form) {
  const fs::path folders(form);
  if (folders.has_root_path() || std::ranges::any_of(folders, [](const fs::path& p) { return p == "." || p == ".."; }))
    return fill(tr("--name {name}: give a name for a folder in the output folder, without . and .., and no path from "
                   "the root"),
                arg("name", form));
  const std::string rest = fill_template(form, {{"name", ""}, {"target", ""}, {"size", ""}});
  const size_t open = rest.find_first_of("{}");
  if (open == std::string::npos) return {};
  const size_t close = rest.find('}', open);
  const std::string field = rest.substr(open, close == std::string::npos ? close : close - open + 1);
  return fill(tr("--name {name}: there is no field {field}; the fields are {fields}"), arg("name", form),
              arg("field", field), arg("fields", kNameFields));
}

/// The path of a set below the output folder, from the template. Parts that would leave the output are dropped.
std::string folder_name(const std::string& form, const std::string& name, const ExportTarget& target, int size) {
  fs::path out;
  for (const fs::path& part :
       fs::path(fill_template(form, {{"name", name}, {"target", target.id}, {"size", std::to_string(size)}})))
    if (part != "." && part != ".." && part != "/") out /= file_name_of(part.string());
  return out.string();
}

std::string folder_of(const std::string& out, const std::string& form, const TextureSetOptions& o) {
  return (fs::path(out) / folder_name(form, o.name, *o.target, o.size)).string();
}

/// A name for each draft's set. Of drafts that differ only in their format, the WIF takes the name and the others
/// append their format. Remaining equal names are numbered.
std::vector<std::string> set_names(const std::vector<std::string>& files) {
  std::vector<std::string> names(files.size());
  std::set<std::string> taken;
  for (const bool wif : {true, false})
    for (size_t i = 0; i < files.size(); ++i) {
      const fs::path path(files[i]);
      if (is_wif_name(files[i]) != wif) continue;
      std::string stem = file_name_of(path.stem().string());
      if (!wif && taken.contains(stem) && path.has_extension())
        stem.append("-").append(file_name_of(path.extension().string().substr(1)));
      names[i] = stem;
      for (int n = 2; !taken.insert(names[i]).second; ++n) names[i] = stem + "-" + std::to_string(n);
    }
  return names;
}

/// The draft as it is, and its versions if they are asked for: their names, the first empty. A draft that cannot be
/// read has none; its own job says why.
std::vector<std::string> states_of(const std::string& file, const ExportOptions& options) {
  std::vector<std::string> names{""};
  if (!options.versions) return names;
  const base::Result<std::string> bytes = base::read_file(file, wif::kMaxDraftBytes);
  const wif::WifRead read = wif::read_draft(bytes ? *bytes : std::string());
  if (read.file)
    for (const design::Version& version : read.file->design.versions) names.push_back(version.name);
  return names;
}

/// A set's name for each state of a draft, `taken` by none before.
std::string state_name(const std::string& name, const std::string& version, std::set<std::string>& taken) {
  if (version.empty()) return name;
  const std::string stem = std::string(name).append("-").append(file_name_of(version));
  std::string out = stem;
  for (int n = 2; !taken.insert(out).second; ++n) out = std::string(stem).append("-").append(std::to_string(n));
  return out;
}

/// One folder for each draft, version and target.
std::vector<Job> jobs_of(const ExportOptions& options, const MaterialOptions& material,
                         const std::vector<const ExportTarget*>& targets) {
  const std::string form = !options.name.empty() ? options.name : targets.size() > 1 ? "{name}/{target}" : "{name}";
  std::vector<Job> jobs;
  const std::vector<std::string> files = drafts_of(options.files), names = set_names(files);
  std::set<std::string> taken(names.begin(), names.end());
  for (size_t i = 0; i < files.size(); ++i) {
    const std::string& file = files[i];
    for (const std::string& version : states_of(file, options)) {
      const std::string name = state_name(names[i], version, taken);
      for (const ExportTarget* target : targets) {
        TextureSetOptions o;
        o.target = target, o.name = name, o.source = fs::path(file).filename().string(), o.draft_path = file;
        o.program_version = base::version(), o.size = options.size, o.force = options.force;
        o.alpha = alpha_named(options.alpha).value_or(Alpha::kAuto);
        o.distance_m = options.distance_m, o.tile_mm = options.tile_cm <= 0 ? kTileOfYarns : 10 * options.tile_cm;
        o.modified = changed(file), o.masks = material.masks;
        o.uv = {uv_unit_named(material.uv).value_or(UvUnit::kMm), material.uv_right_mm, material.uv_up_mm};
        o.mips = files::mip_format_named(options.mips);
        std::error_code ec;
        for (int lod = 0; lod < (material.lods ? kLods : 1); ++lod)
          jobs.push_back({file, folder_of(options.out, form, at_lod(o, lod)), version, o, lod, form,
                          fs::last_write_time(file, ec)});
      }
    }
  }
  return jobs;
}

/// What is wrong where two sets would have one folder, so that the later one would replace the other; or an empty
/// string.
std::string shared_folder_problem(const std::vector<Job>& jobs) {
  std::set<std::string> folders;
  for (const Job& job : jobs)
    if (!folders.insert(job.folder).second)
      return fill(tr("{folder}: several sets would be in this folder; give a --name that has the fields to tell them "
                     "apart ({fields})"),
                  arg("folder", job.folder), arg("fields", kNameFields));
  return {};
}

std::string archive_of(const Job& job) { return job.folder + ".zip"; }

/// Whether the archive can be written, before its set is.
base::Result<void> check_archive(const Job& job, const ExportOptions& options) {
  std::error_code ec;
  if (!options.zip || options.force || lists_archive(job.folder) || !fs::exists(archive_of(job), ec)) return {};
  return base::failure(base::ErrorKind::kOutput,
                       tr("is not an archive of this set; move it away, or --force to replace it"), archive_of(job));
}

std::vector<ZipEntry> archive_entries(const Job& job) {
  std::vector<ZipEntry> entries;
  const std::string top = fs::path(job.folder).filename().string();
  for (const std::string& name : listed_files(job.folder))
    entries.push_back({top + "/" + name, (fs::path(job.folder) / name).string()});
  return entries;
}

base::Result<void> write_archive(const Job& job) {
  return write_zip(archive_of(job), archive_entries(job), ZipKind::kPlain);
}

/// True if no archive is wanted, or the one of the complete set has its size.
bool has_archive(const ExportRun& run, const Job& job) {
  if (!run.options.zip) return true;
  std::error_code ec;
  return lists_archive(job.folder) && fs::file_size(archive_of(job), ec) == plain_zip_size(archive_entries(job));
}

/// Counts the failure of a set; true if its text is new.
bool count_failure(ExportRun& run, int code, const std::string& problem) {
  ++run.failed_sets;
  for (int seen = run.worst; code > seen && !run.worst.compare_exchange_weak(seen, code);) {
  }
  if (std::ranges::find(run.failed, problem) != run.failed.end()) return false;
  run.failed.push_back(problem);
  return true;
}

/// Prints the failure of a set; the same text of several sets once.
void report(ExportRun& run, int code, const std::string& problem) {
  const std::lock_guard lock(run.console);
  if (!count_failure(run, code, problem)) return;
  run.progress.clear();
  std::fprintf(stderr, "%s\n", problem.c_str());
}

/// Of a draft whose problems were printed as it was read: the list at the end alone names it again.
void report_unread(ExportRun& run, const std::string& file) {
  const std::lock_guard lock(run.console);
  count_failure(run, kBadInput, fill(tr("{file}: not exported: it cannot be read"), arg("file", file)));
}

std::shared_ptr<const OpenedDesign> open_shared(ExportRun& run, const std::string& file) {
  SharedDraft& draft = run.drafts.at(file);
  const std::lock_guard lock(draft.reading);
  if (draft.opened) return draft.opened;
  {
    const std::lock_guard before_problems(run.console);
    run.progress.clear();
  }
  draft.opened = std::make_shared<const OpenedDesign>(open_design(file));
  return draft.opened;
}

void close_shared(ExportRun& run, const std::string& file) {
  SharedDraft& draft = run.drafts.at(file);
  const std::lock_guard lock(draft.reading);
  if (--draft.jobs == 0) draft.opened.reset();
}

void print_warnings(ExportRun& run, const Job& job, const Design& design) {
  for (const std::string& w : warnings_of(design, job.options)) {
    const std::lock_guard lock(run.console);
    if (!run.drafts.at(job.file).warnings.insert(w).second) continue;
    run.progress.clear();
    std::fprintf(stderr, "%s: %s\n", job.file.c_str(), w.c_str());
  }
}

/// The version of a shipped drape for the fabric; empty if the set wears none, or a mesh that is the same for all.
std::optional<Mesh> drape_for_fabric(const ExportRun& run, const Job& job, Design design) {
  design.scene.mesh = run.options.mesh;
  if (!job.options.target->wears_mesh || !can_drape(design)) return {};
  base::Result<Mesh> read = load_worn_drape(design);
  if (!read) return {};
  return std::move(*read);
}

void run_job(Job job, int index, ExportRun& run, SharedWork& work) {
  const std::shared_ptr<const OpenedDesign> shared = open_shared(run, job.file);
  const OpenedDesign& opened = *shared;
  if (!opened.ok) return report_unread(run, job.file);
  const design::Version* version = version_named(opened.design, job.version);
  if (!version && !job.version.empty())
    return report(run, kBadInput,
                  fill(tr("{file}: not exported: it has no version '{name}' any more"), arg("file", job.file),
                       arg("name", job.version)));
  const Design design = version ? at_version(opened.design, *version) : opened.design;
  if (run.options.texels_per_mm > 0) {
    set_density(job.options, design, run.options.texels_per_mm);
    job.folder = folder_of(run.options.out, job.form, at_lod(job.options, job.lod));
  }
  job.options = at_lod(job.options, job.lod);
  job.options.archived = run.options.zip;
  const std::string& worn = job.options.target->wears_mesh ? run.worn : run.options.mesh;
  job.options.key = digest(opened.file.bytes + "\n" + key_of(job.options) + "\n" + worn + "\n" + job.version);
  if (run.options.resume && is_complete(job.folder, job.options.key) && has_archive(run, job)) {
    ++run.kept;
    const std::lock_guard lock(run.console);
    run.progress.skip(index, job.folder);
    return;
  }
  print_warnings(run, job, design);
  const auto report_progress = [&](float fraction) {
    const std::lock_guard lock(run.console);
    run.progress.set(index, std::min(static_cast<double>(fraction), 0.999), job.folder);
  };
  const std::optional<Mesh> drape = drape_for_fabric(run, job, design);
  base::Result<void> done = check_archive(job, run.options);
  if (done)
    done = write_texture_set(job.folder, design, drape ? *drape : run.mesh, job.options,
                             {.report = report_progress, .stop = run.stop}, &work);
  if (!done && done.error().kind == base::ErrorKind::kCancelled) return;
  if (done && run.options.zip) done = write_archive(job);
  if (!done)
    return report(run, kNotWritten,
                  fill(tr("{file}: not exported: {problem}"), arg("file", job.file), arg("problem", problem_of(done))));
  ++run.written;
  if (run.options.quiet) return;
  const std::lock_guard lock(run.console);
  run.progress.clear();
  std::printf("%s\n", job.folder.c_str());
  std::fflush(stdout);
}

/// Whether a set goes on with the work of the one before: a level of detail always, and another target where sets are
/// made one by one.
bool goes_on(const Job& job, const Job& before, int at_once) {
  return job.file == before.file && job.version == before.version &&
         (at_once == 1 || (job.lod > 0 && job.options.target == before.options.target));
}

/// A set and those that go on with its work.
void run_sets(const std::vector<Job>& jobs, size_t first, size_t end, ExportRun& run) {
  SharedWork work;
  for (size_t j = first; j < end; ++j) {
    if (run.stop.stop_requested()) return;
    const Job& job = jobs[j];
    const int index = static_cast<int>(j);
    if (const base::Result<void> done = caught([&] { run_job(job, index, run, work); }); !done)
      report(run, kNotWritten,
             fill(tr("{file}: not exported: {problem}"), arg("file", job.file), arg("problem", message(done.error()))));
    close_shared(run, job.file);
    const std::lock_guard lock(run.console);
    run.progress.set(index, 1, job.folder);
  }
}

int run_all(const std::vector<Job>& jobs, const ExportOptions& options, const Mesh& mesh) {
  const ProgressForm form = options.progress_json ? ProgressForm::kJson
                            : options.quiet       ? ProgressForm::kNone
                                                  : ProgressForm::kTerminal;
  ExportRun run{options, mesh, worn_by(options.mesh, mesh),
                {},      {},   ProgressMeter(form, static_cast<int>(jobs.size())),
                kDone,   0,    0,
                0,       {}};
  for (const Job& job : jobs) ++run.drafts[job.file].jobs;
  std::vector<size_t> firsts;  // of sets that begin anew
  for (size_t j = 0; j < jobs.size(); ++j)
    if (j == 0 || !goes_on(jobs[j], jobs[j - 1], options.jobs)) firsts.push_back(j);
  for_each_job(static_cast<int>(firsts.size()), options.jobs, [&](int k) {
    const size_t i = static_cast<size_t>(k);
    run_sets(jobs, firsts[i], i + 1 < firsts.size() ? firsts[i + 1] : jobs.size(), run);
  });
  run.progress.clear();
  if (jobs.size() > 1 && (!options.quiet || run.worst != kDone)) {
    print_problem(fill(tr_n("{written} set written, {complete} already complete, {failed} failed",
                            "{written} sets written, {complete} already complete, {failed} failed", run.written.load()),
                       arg("written", run.written.load()), arg("complete", run.kept.load()),
                       arg("failed", run.failed_sets.load())));
    // Again only where the names of sets came between.
    if (run.written > 0 && !options.quiet)
      for (const std::string& problem : run.failed) std::fprintf(stderr, "  %s\n", problem.c_str());
  }
  if (run.stop.stop_requested()) {
    print_problem(message(stopped().value()));
    platform::end_as_asked();
  }
  return run.worst;
}

/// Exports a draft again whenever its file changes, until the program is ended.
void watch(std::vector<Job> jobs, const ExportOptions& options, const Mesh& mesh) {
  if (!options.quiet)
    print_problem(fill(tr_n("watching {count} set; press Ctrl+C to stop", "watching {count} sets; press Ctrl+C to stop",
                            static_cast<long long>(jobs.size())),
                       arg("count", jobs.size())));
  const std::stop_token stop = platform::stop_when_asked();
  while (!stop.stop_requested()) {
    std::this_thread::sleep_for(kWatchStep);
    std::vector<Job> changed_jobs;
    for (Job& job : jobs) {
      std::error_code ec;
      const auto now = fs::last_write_time(job.file, ec);
      if (ec || now == job.time) continue;
      job.time = now, job.options.modified = changed(job.file);
      changed_jobs.push_back(job);
    }
    if (!changed_jobs.empty()) run_all(changed_jobs, options, mesh);
  }
  platform::end_as_asked();
}

}  // namespace

int export_command(const ExportOptions& options) { return export_command(options, {}); }

int export_command(const ExportOptions& options, const MaterialOptions& material) {
  std::vector<const ExportTarget*> targets;
  for (const std::string& name : options.targets) {
    const ExportTarget* const target = target_named(name);
    if (!target) return refuse(fill(tr("there is no target '{name}'"), arg("name", name)));
    if (std::find(targets.begin(), targets.end(), target) == targets.end()) targets.push_back(target);
  }
  if (!is_power_of_two(options.size) || options.size < 16 || options.size > 8192)
    return refuse(fill(tr("--size {size}: give a power of two from 16 to 8192"), arg("size", options.size)));
  if (targets.size() > 1 && !options.name.empty() && options.name.find("{target}") == std::string::npos)
    return refuse(fill(tr("--name {name}: several targets need {{target}} in it"), arg("name", options.name)));
  if (material.lods && std::ranges::any_of(targets, &ExportTarget::raw))
    return refuse(
        tr("--lods: a raw set has no material that levels of detail could make simpler; leave raw out, or export it by "
           "itself, without --lods"));
  if (const std::string wrong = template_problem(options.name); !wrong.empty()) return refuse(wrong);
  const bool mesh_wanted = std::ranges::any_of(targets, &ExportTarget::wears_mesh);
  const base::Result<Mesh> mesh = mesh_wanted ? load_drape(options.mesh) : Mesh{};
  if (!mesh)
    return fail({base::ErrorKind::kInput, fill(tr("--mesh: {problem}"), arg("problem", message(mesh.error())))});
  std::error_code ec;
  if (fs::exists(options.out, ec) && !fs::is_directory(options.out, ec))
    return fail({base::ErrorKind::kOutput, tr("is a file"), options.out});
  const std::vector<Job> jobs = jobs_of(options, material, targets);
  if (jobs.empty()) {
    return fail({base::ErrorKind::kInput,
                 tr("there is no draft in it (.wif, .dtx, .wpo); give drafts or a folder of drafts"),
                 options.files[0]});
  }
  if (const std::string shared = shared_folder_problem(jobs); !shared.empty()) return refuse(shared);
  platform::keep_freed_memory();
  const int code = run_all(jobs, options, *mesh);
  if (options.watch) watch(jobs, options, *mesh);
  return code;
}

}  // namespace weftlight::commands
