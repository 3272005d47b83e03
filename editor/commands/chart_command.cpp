// `weftlight chart`: measures speed against accuracy. Rows of an earlier run of the same program in DIR/chart.csv are
// kept, so that a run can be stopped and resumed, or done part by part. `auto` comes last: it uses the LOD table that
// this run has measured.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/text.h"
#include "base/whole_files.h"
#include "chart/bench.h"
#include "chart/drapes.h"
#include "chart/figures.h"
#include "commands/commands.h"
#include "commands/picture_setup.h"
#include "platform/environment_variables.h"

namespace weftlight::commands {

using base::tr, base::write_file_atomically;
using chart::Brightness, chart::ChartBench, chart::ChartEffort, chart::ChartLight, chart::ChartRow,
    chart::ChartSelection, chart::CountedDraw, chart::DrapeRow, chart::DrawCounter, chart::TruthNoise, chart::FibreRow,
    chart::chart_cells, chart::chart_csv, chart::chart_effort, chart::drape_cells, chart::drapes_csv, chart::fibres_csv,
    chart::kChartScenes, chart::kFibreFootprints, chart::kFibreViews, chart::kFrameFootprints, chart::kFrameSizes,
    chart::kFrameTolerances, chart::light_name, chart::lod_table_csv, chart::lod_table_of, chart::mark_pareto_front,
    chart::read_chart, chart::write_chart_figures;
using design::Look, design::Method, design::method_name;
using light::LodTable;

namespace {

constexpr std::array<double, 7> kAlbedoViews{0, 20, 40, 55, 70, 80, 85};

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class ChartRun {
 public:
  ChartRun(ChartBench& bench, std::string dir, ChartSelection part)
      : bench_(bench), dir_(std::move(dir)), part_(std::move(part)) {}

  base::Result<void> all() {
    auto methods = bench_.methods();
    if (!methods) return failed(methods);
    methods_ = std::move(*methods);
    cells_ = chart_cells(methods_);
    keep_earlier();
    // `auto` last: it goes by the LOD table that ships, as in every picture.
    for (const bool automatic : {false, true}) {
      for (const ChartRow& cell : cells_) {
        if ((cell.method == Method::kAuto) != automatic || !part_.holds(cell) || known(cell)) continue;
        if (auto added = add(cell); !added) return added;
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

  /// The scenes that have rows, from this run or an earlier one.
  std::vector<size_t> scenes() const {
    std::vector<size_t> measured;
    for (size_t scene = 0; scene < kChartScenes.size(); ++scene) {
      const auto of_it = [scene](const ChartRow& r) { return r.scene == kChartScenes[scene].name; };
      if (std::any_of(rows_.begin(), rows_.end(), of_it)) measured.push_back(scene);
    }
    return measured;
  }

  void report(const ChartRow& cell) const {
    char line[128];
    std::snprintf(line, sizeof line, "%3zu/%zu  %s, %d degrees, %g yarns a pixel, %s", rows_.size() + 1, cells_.size(),
                  cell.scene.c_str(), cell.view_deg, cell.yarns_per_pixel,
                  std::string(method_name(cell.method)).c_str());
    if (platform::errors_go_to_terminal()) std::fprintf(stderr, "\r%-78s", line);
    else if (rows_.size() % 20 == 0) std::fprintf(stderr, "%s\n", line);
  }

  base::Result<void> add(const ChartRow& cell) {
    report(cell);
    const base::Result<ChartRow> row = bench_.measure(cell);
    if (!row) return failed(row);
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
    mark_pareto_front(sorted);
    return sorted;
  }

  base::Result<void> write(const char* name, const base::Result<std::string>& text) const {
    if (!text) return failed(text);
    return write_file_atomically(dir_ + "/" + name, *text);
  }

  base::Result<void> save() const {
    auto saved = write("chart.csv", chart_csv(in_order()));
    return saved && rows_.size() == 1 ? write("chart.state", bench_.fingerprint()) : saved;
  }

  base::Result<void> finish() {
    if (platform::errors_go_to_terminal()) std::fprintf(stderr, "\r%-78s\n", "drawing");
    const std::vector<ChartRow> rows = in_order();
    if (auto done = write("lod_table.csv", lod_table_csv(lod_table_of(rows))); !done) return done;
    const auto brightness = albedo();
    if (!brightness) return failed(brightness);
    const auto noise = truth_noise();
    if (!noise) return failed(noise);
    if (auto done = write_chart_figures(dir_, bench_.device(), rows, *brightness, *noise); !done) return done;
    if (auto done = write("light.csv", other_lights()); !done) return done;
    if (auto done = write("drapes.csv", drapes().map(drapes_csv)); !done) return done;
    if (auto done = write("fibres.csv", fibres().map(fibres_csv)); !done) return done;
    return write("frames.csv", frames());
  }

  /// Under other lights: close up and from afar, at normal and oblique views.
  base::Result<std::string> other_lights() {
    std::ostringstream out;
    out << "light,scene,view_deg,yarns_per_pixel,method,rel_rmse_model,energy_ratio\n";
    for (const ChartLight light : {ChartLight::kSky, ChartLight::kBehind}) {
      for (const size_t scene : scenes()) {
        for (const int view : {0, 60}) {
          for (const double footprint : {0.125, 2.0}) {
            for (const Method method : {Method::kYarn, Method::kRepeat, Method::kCloth}) {
              ChartRow cell;
              cell.scene = kChartScenes[scene].name, cell.view_deg = view;
              cell.yarns_per_pixel = footprint, cell.method = method;
              if (method == Method::kYarn) cell.samples = formulas::kMaxYarnSamples;
              const auto row = bench_.measure_under(light, cell);
              if (!row) return failed(row);
              out << light_name(light) << ',' << cell.scene << ',' << view << ',' << footprint << ','
                  << method_name(method) << ',' << row->cell.model_error << ',' << row->cell.energy_ratio << '\n';
            }
          }
        }
      }
    }
    return out.str();
  }

  base::Result<std::vector<DrapeRow>> drapes() {
    std::vector<DrapeRow> rows;
    for (const DrapeRow& cell : drape_cells(methods_, bench_.effort())) {
      const auto of_it = [&cell](size_t scene) { return cell.scene == kChartScenes[scene].name; };
      const std::vector<size_t> measured = scenes();
      if (std::none_of(measured.begin(), measured.end(), of_it)) continue;
      const base::Result<DrapeRow> row = bench_.draped(cell);
      if (!row) return failed(row);
      rows.push_back(*row);
    }
    return rows;
  }

  /// Near the threads, against traced fibres.
  base::Result<std::vector<FibreRow>> fibres() {
    std::vector<FibreRow> rows;
    for (const size_t scene : scenes())
      for (const int view : kFibreViews)
        for (size_t f = kFibreFootprints.size() - bench_.effort().fibre_footprints; f < kFibreFootprints.size(); ++f) {
          const auto more = bench_.against_fibres(scene, view, kFibreFootprints[f]);
          if (!more) return failed(more);
          rows.insert(rows.end(), more->begin(), more->end());
        }
    return rows;
  }

  /// The cost of a whole picture of cloth, by method and by the tolerance of `auto`.
  base::Result<std::string> frames() {
    std::vector<Look> looks;
    for (const Method method : methods_) {
      if (method != Method::kAuto) looks.push_back({method});
    }
    for (const float tolerance : kFrameTolerances) looks.push_back({Method::kAuto, tolerance});
    std::ostringstream out;
    out << "device,method,tolerance,yarns_per_pixel,width,height,ms\n";
    for (const Look& look : looks) {
      for (const double footprint : kFrameFootprints) {
        for (const auto& size : kFrameSizes) {
          const auto ms = bench_.frame_ms(scenes().back(), look, footprint, size);
          if (!ms) return failed(ms);
          out << '"' << bench_.device() << "\"," << method_name(look.method) << ',' << look.tolerance << ','
              << footprint << ',' << size[0] << ',' << size[1] << ',' << *ms << '\n';
        }
      }
    }
    return out.str();
  }

  base::Result<std::vector<Brightness>> albedo() {
    std::vector<Brightness> values;
    for (const size_t scene : scenes()) {
      for (const double view : kAlbedoViews) {
        const auto traced = bench_.brightness(scene, view, {});
        if (!traced) return failed(traced);
        values.push_back({kChartScenes[scene].name, "truth", view, *traced});
        for (const Method method : methods_) {
          const auto drawn = bench_.brightness(scene, view, method);
          if (!drawn) return failed(drawn);
          values.push_back({kChartScenes[scene].name, std::string(method_name(method)), view, *drawn});
        }
      }
    }
    return values;
  }

  base::Result<std::vector<TruthNoise>> truth_noise() {
    std::vector<TruthNoise> all;
    for (const ChartRow& cell : chart_cells({Method::kFlat})) {
      if (!part_.holds(cell)) continue;
      const base::Result<double> noise = bench_.truth_noise(cell);
      if (!noise) return failed(noise);
      all.push_back({cell.scene, cell.view_deg, cell.yarns_per_pixel, *noise});
    }
    return all;
  }

  ChartBench& bench_;
  std::string dir_;
  ChartSelection part_;
  std::vector<Method> methods_;         // that this renderer draws
  std::vector<ChartRow> cells_, rows_;  // all cells of the chart; those measured so far
};

/// Starts the process that counts instructions; it has a bench of its own.
std::unique_ptr<DrawCounter> start_counter(const ChartEffort& effort) {
  return DrawCounter::start([effort, bench = std::shared_ptr<ChartBench>()](
                                const CountedDraw& what, const LodTable& lod_table, int pixels) mutable {
    if (!bench)
      if (auto made = ChartBench::create(effort, nullptr)) bench = std::move(*made);
    return bench && bench->draw_counted(what, lod_table, pixels);
  });
}

}  // namespace

int chart_command(const ChartOptions& options) {
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (!std::filesystem::is_directory(options.out))
    return fail({base::ErrorKind::kOutput, tr("the folder cannot be created"), options.out});
  ChartEffort effort = chart_effort(options.quick);
  effort.count_instructions = options.count;
  const auto bench = ChartBench::create(effort, effort.count_instructions ? start_counter(effort) : nullptr);
  if (!bench) return fail(bench.error());
  return finish(ChartRun(**bench, options.out, options.part).all());
}

}  // namespace weftlight::commands
