#include "chart/chart_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <set>

#include "chart/scene.h"
#include "light/formulas.h"

namespace weftlight::chart {

using design::method_from_name, design::method_name;
using light::LodPoint, light::expected_cost, light::expected_error;

namespace {

std::string number(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", v);
  return text.data();
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') cells.emplace_back();
    else if (c != '\r') cells.back() += c;
  }
  return cells;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

double value(const std::string& cell, bool& good) {
  char* end = nullptr;
  const double v = std::strtod(cell.c_str(), &end);
  good = good && !cell.empty() && *end == '\0' && std::isfinite(v);
  return v;
}

bool read_row(std::string_view line, ChartRow& row) {
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != 14) return false;
  const auto method = method_from_name(cells[3]);
  bool good = method.has_value();
  row.scene = cells[0];
  row.view_deg = static_cast<int>(value(cells[1], good));
  row.yarns_per_pixel = value(cells[2], good);
  row.method = method.value_or(Method::kAuto);
  row.samples = static_cast<int>(value(cells[4], good));
  double* const numbers[] = {&row.ns_per_pixel, &row.instructions_per_pixel, &row.model_error, &row.filtering_error,
                             &row.flip,         &row.energy_ratio,           &row.flicker,     &row.bytes};
  for (size_t i = 0; i < std::size(numbers); ++i) *numbers[i] = value(cells[5 + i], good);
  row.on_front = cells[13] == "1";
  return good;
}

double cosine(int view_deg) { return std::cos(view_deg * std::numbers::pi / 180); }

/// A method with a number of samples.
struct SampledMethod {
  Method method;
  int samples;
};

std::vector<SampledMethod> methods() {
  std::vector<SampledMethod> all;
  for (int i = 0; i < formulas::kLattices; ++i) all.push_back({Method::kYarn, formulas::lattice_of(i).x});
  for (const Method m : {Method::kCell, Method::kRepeat, Method::kCloth}) all.push_back({m, 1});
  return all;
}

/// The rows of one method on one scene and view, with the footprints of the shaders.
LodTable scene_lod_table(const std::vector<ChartRow>& rows, const ChartRow& place, const SampledMethod& sampled) {
  LodTable lod_table;
  for (const ChartRow& r : rows) {
    if (r.method != sampled.method || r.samples != sampled.samples) continue;
    if (r.scene != place.scene || r.view_deg != place.view_deg) continue;
    lod_table.push_back({r.method, static_cast<float>(r.yarns_per_pixel / std::sqrt(cosine(r.view_deg))),
                         static_cast<float>(r.ns_per_pixel), static_cast<float>(r.filtering_error),
                         static_cast<float>(r.model_error), r.samples});
  }
  return lod_table;
}

float error_at(LodTable lod_table, const SampledMethod& sampled, float yarns, float LodPoint::*error) {
  for (LodPoint& p : lod_table) p.filtering_error = p.model_error = p.*error;
  return expected_error(lod_table, sampled.method, yarns, sampled.samples);
}

/// The cost is the mean over scenes and views. The error of method yarn is that of the worst one, since more samples
/// reduce it; that of the other methods is the root mean square, since otherwise the glossiest cloth alone would make
/// all cloths thirty times as expensive.
LodPoint point_of(const std::vector<LodTable>& places, const SampledMethod& sampled, float yarns) {
  LodPoint p{sampled.method, yarns, 0, 0, 0, sampled.samples};
  const float weight = 1.0f / static_cast<float>(places.size());
  const auto gathered = [&](float LodPoint::*error) {
    float worst = 0, squares = 0;
    for (const LodTable& place : places) {
      const float e = error_at(place, sampled, yarns, error);
      worst = std::max(worst, e), squares += e * e * weight;
    }
    return sampled.method == Method::kYarn ? worst : std::sqrt(squares);
  };
  for (const LodTable& place : places)
    p.cost_ns += expected_cost(place, sampled.method, yarns, sampled.samples) * weight;
  p.filtering_error = gathered(&LodPoint::filtering_error), p.model_error = gathered(&LodPoint::model_error);
  return p;
}

/// The numbers of samples with which a method is measured.
std::vector<int> samples_of(Method method) {
  if (method == Method::kAuto) return {0};
  if (method != Method::kYarn) return {1};
  std::vector<int> all;
  for (int i = 0; i < formulas::kLattices; ++i) all.push_back(formulas::lattice_of(i).x);
  return all;
}

template <typename T, typename V>
bool is_selected(const std::vector<T>& selected, const V& value) {
  return selected.empty() || std::find(selected.begin(), selected.end(), value) != selected.end();
}

}  // namespace

bool ChartRow::same_conditions(const ChartRow& o) const {
  return scene == o.scene && view_deg == o.view_deg && yarns_per_pixel == o.yarns_per_pixel;
}
bool ChartRow::same_cell(const ChartRow& o) const {
  return same_conditions(o) && method == o.method && samples == o.samples;
}

bool ChartSelection::holds(const ChartRow& row) const {
  return is_selected(scenes, row.scene) && is_selected(views_deg, row.view_deg) &&
         is_selected(yarns_per_pixel, row.yarns_per_pixel);
}

std::vector<ChartRow> chart_cells(const std::vector<Method>& methods) {
  std::vector<ChartRow> cells;
  for (const ChartScene& scene : kChartScenes) {
    for (const int view : kChartViews) {
      for (const double footprint : kChartFootprints) {
        for (const Method method : methods) {
          ChartRow cell;
          cell.scene = scene.name, cell.view_deg = view, cell.yarns_per_pixel = footprint, cell.method = method;
          for (const int samples : samples_of(method)) cell.samples = samples, cells.push_back(cell);
        }
      }
    }
  }
  return cells;
}

std::string chart_csv(const std::vector<ChartRow>& rows) {
  std::string text(kChartColumns);
  text += '\n';
  for (const ChartRow& r : rows) {
    text += r.scene + ',' + std::to_string(r.view_deg) + ',' + number(r.yarns_per_pixel) + ',' +
            std::string(method_name(r.method)) + ',' + std::to_string(r.samples);
    for (const double v : {r.ns_per_pixel, r.instructions_per_pixel, r.model_error, r.filtering_error, r.flip,
                           r.energy_ratio, r.flicker, r.bytes}) {
      text += ',' + number(v);
    }
    text += r.on_front ? ",1\n" : ",0\n";
  }
  return text;
}

std::vector<ChartRow> read_chart(std::string_view csv) {
  const std::vector<std::string_view> lines = lines_of(csv);
  std::vector<ChartRow> rows;
  if (lines.empty() || lines.front() != kChartColumns) return rows;
  for (size_t i = 1; i < lines.size(); ++i) {
    ChartRow row;
    if (read_row(lines[i], row)) rows.push_back(row);
  }
  return rows;
}

ChartRow as_written(const ChartRow& row) {
  const std::vector<ChartRow> read = read_chart(chart_csv({row}));
  return read.empty() ? row : read.front();
}

void mark_pareto_front(std::vector<ChartRow>& rows) {
  for (ChartRow& row : rows) {
    row.on_front = std::none_of(rows.begin(), rows.end(), [&row](const ChartRow& o) {
      return o.same_conditions(row) && o.ns_per_pixel < row.ns_per_pixel && o.model_error < row.model_error;
    });
  }
}

LodTable lod_table_of(const std::vector<ChartRow>& rows) {
  std::set<float> footprints;
  std::vector<ChartRow> places;
  for (const ChartRow& row : rows) {
    footprints.insert(static_cast<float>(row.yarns_per_pixel));
    footprints.insert(static_cast<float>(row.yarns_per_pixel) * 2);  // the pixels of a tilted view are larger
    const bool seen = std::any_of(places.begin(), places.end(), [&row](const ChartRow& p) {
      return p.scene == row.scene && p.view_deg == row.view_deg;
    });
    if (!seen) places.push_back(row);
  }
  LodTable lod_table;
  for (const SampledMethod& sampled : methods()) {
    std::vector<LodTable> measured;
    for (const ChartRow& place : places) {
      if (LodTable one = scene_lod_table(rows, place, sampled); !one.empty()) measured.push_back(std::move(one));
    }
    for (const float yarns : footprints) {
      if (!measured.empty()) lod_table.push_back(point_of(measured, sampled, yarns));
    }
  }
  return lod_table;
}

std::string lod_table_csv(const LodTable& lod_table) {
  std::string text = "method,samples,yarns_per_pixel,ns_per_pixel,rel_rmse_filtering,rel_rmse_model\n";
  for (const LodPoint& p : lod_table) {
    text += std::string(method_name(p.method)) + ',' + std::to_string(p.samples);
    for (const float v : {p.yarns_per_pixel, p.cost_ns, p.filtering_error, p.model_error})
      text += ',' + number(static_cast<double>(v));
    text += '\n';
  }
  return text;
}

}  // namespace weftlight::chart
