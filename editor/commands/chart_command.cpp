// `weftlight chart`: speed against accuracy, measured. Rows that an earlier run of the same program left in
// DIR/chart.csv are kept, so that a run can be stopped and taken up again. `auto` comes last: it chooses by
// the ladder that this run has measured.

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/files.h"
#include "commands/chart_bench.h"
#include "commands/chart_figures.h"
#include "commands/commands.h"
#include "commands/picture_setup.h"

namespace weftlight::commands {
namespace {

constexpr std::array<double, 7> kAlbedoViews{0, 20, 40, 55, 70, 80, 85};

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Every row to be measured, in the order of the file.
std::vector<ChartRow> cells_of(const std::vector<Method>& methods) {
  std::vector<ChartRow> cells;
  for (const ChartScene& scene : kChartScenes) {
    for (const int view : kChartViews) {
      for (const double footprint : kChartFootprints) {
        for (const Method method : methods) {
          ChartRow cell;
          cell.scene = scene.name, cell.view_deg = view, cell.yarns_per_pixel = footprint, cell.method = method;
          cells.push_back(cell);
        }
      }
    }
  }
  return cells;
}

class Run {
 public:
  Run(ChartBench& bench, std::string dir) : bench_(bench), dir_(std::move(dir)), cells_(cells_of(bench.methods())) {}

  int all() {
    keep_earlier();
    for (const bool automatic : {false, true}) {
      if (automatic) bench_.use_ladder(ladder_of(rows_));
      for (const ChartRow& cell : cells_) {
        if ((cell.method == Method::kAuto) != automatic || known(cell)) continue;
        if (const int code = add(cell); code != kDone) return code;
      }
    }
    return finish();
  }

 private:
  bool known(const ChartRow& cell) const {
    return std::any_of(rows_.begin(), rows_.end(), [&cell](const ChartRow& r) { return r.same_cell(cell); });
  }

  void keep_earlier() {
    if (read_text(dir_ + "/chart.state") != bench_.fingerprint()) return;
    for (const ChartRow& row : read_chart(read_text(dir_ + "/chart.csv"))) {
      const bool asked =
          std::any_of(cells_.begin(), cells_.end(), [&row](const ChartRow& c) { return c.same_cell(row); });
      if (asked && !known(row)) rows_.push_back(row);
    }
  }

  void tell(const ChartRow& cell) const {
    char line[128];
    std::snprintf(line, sizeof line, "%3zu/%zu  %s, %d degrees, %g yarns a pixel, %s", rows_.size() + 1, cells_.size(),
                  cell.scene.c_str(), cell.view_deg, cell.yarns_per_pixel,
                  std::string(method_name(cell.method)).c_str());
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r%-78s", line);
    else if (rows_.size() % 20 == 0) std::fprintf(stderr, "%s\n", line);
  }

  int add(const ChartRow& cell) {
    tell(cell);
    std::string error;
    const std::optional<ChartRow> row = bench_.measure(cell, error);
    if (!row) return fail(kBadInput, error);
    rows_.push_back(*row);
    return save();
  }

  std::vector<ChartRow> in_order() const {
    std::vector<ChartRow> sorted;
    for (const ChartRow& cell : cells_) {
      const auto found =
          std::find_if(rows_.begin(), rows_.end(), [&cell](const ChartRow& r) { return r.same_cell(cell); });
      if (found != rows_.end()) sorted.push_back(*found);
    }
    mark_front(sorted);
    return sorted;
  }

  int save() const {
    std::string error = write_file_atomically(dir_ + "/chart.csv", chart_csv(in_order()));
    if (error.empty() && rows_.size() == 1) error = write_file_atomically(dir_ + "/chart.state", bench_.fingerprint());
    return error.empty() ? kDone : fail(kNotWritten, error);
  }

  int finish() {
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r%-78s\n", "drawing");
    const std::vector<ChartRow> rows = in_order();
    std::string error = write_file_atomically(dir_ + "/ladder.csv", ladder_csv(ladder_of(rows)));
    const std::vector<Brightness> brightness = albedo(error);
    const std::vector<TruthNoise> noise = truth_noise(error);
    if (error.empty()) error = write_chart_figures(dir_, bench_.device(), rows, brightness, noise);
    return error.empty() ? kDone : fail(kNotWritten, error);
  }

  std::vector<Brightness> albedo(std::string& error) {
    std::vector<Brightness> values;
    const std::vector<Method> methods = bench_.methods();
    for (size_t scene = 0; scene < kChartScenes.size(); ++scene) {
      for (const double view : kAlbedoViews) {
        if (const auto traced = bench_.brightness(scene, view, {}, error))
          values.push_back({kChartScenes[scene].name, "truth", view, *traced});
        for (const Method method : methods) {
          if (const auto drawn = bench_.brightness(scene, view, method, error)) {
            values.push_back({kChartScenes[scene].name, std::string(method_name(method)), view, *drawn});
          }
        }
      }
    }
    return values;
  }

  std::vector<TruthNoise> truth_noise(std::string& error) {
    std::vector<TruthNoise> noise;
    for (const ChartRow& cell : cells_of({Method::kFlat})) {
      noise.push_back({cell.scene, cell.view_deg, cell.yarns_per_pixel, bench_.truth_noise(cell, error)});
    }
    return noise;
  }

  ChartBench& bench_;
  std::string dir_;
  std::vector<ChartRow> cells_, rows_;
};

}  // namespace

int chart_command(const ChartOptions& options) {
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (!std::filesystem::is_directory(options.out))
    return fail(kNotWritten, options.out + ": the folder cannot be made");
  int code = kDone;
  std::string error;
  const auto bench = ChartBench::create(chart_effort(options.quick), code, error);
  if (!bench) return fail(code, error);
  return Run(*bench, options.out).all();
}

}  // namespace weftlight::commands
