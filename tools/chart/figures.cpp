#include "chart/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

#include "base/whole_files.h"
#include "chart/charted_methods.h"
#include "chart/scene.h"

namespace weftlight::chart {

using base::write_file_atomically;
using design::Method, design::method_name;
using plot::PlotAxis, plot::Curve, plot::Figure, plot::Ink, plot::KeyEntry, plot::Marker, plot::PlotPanel,
    plot::PlotPoint, plot::fit_log, plot::write_figure;

namespace {

constexpr double kModelGoal = 0.15, kFilteringGoal = 0.05;
constexpr double kMinError = 1e-4;  // smaller errors are drawn here

constexpr std::array<Ink, 6> kFootprintInks{{{0.60, 0.15, 0.35},
                                             {0.75, 0.22, 0.17},
                                             {0.88, 0.53, 0.17},
                                             {0.55, 0.60, 0.20},
                                             {0.15, 0.55, 0.55},
                                             {0.17, 0.30, 0.60}}};
const std::vector<std::string> kFootprintNames{"1/16", "1/8", "1/2", "1", "2", "8"};

std::string scene_title(const std::string& scene, int view_deg) {
  const std::map<std::string, std::string> titles{{"plain", "Plain weave"},
                                                  {"twill", "2/2 twill"},
                                                  {"satin", "Satin on 8 shafts"},
                                                  {"black_white", "Taffeta, black and white"},
                                                  {"damask", "Twill damask, two colours"}};
  const auto found = titles.find(scene);
  return (found == titles.end() ? scene : found->second) + ", " + std::to_string(view_deg) + "°";
}

std::vector<ChartRow> rows_at(const std::vector<ChartRow>& rows, const std::string& scene, int view) {
  std::vector<ChartRow> picked;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(picked),
               [&](const ChartRow& r) { return r.scene == scene && r.view_deg == view; });
  return picked;
}

/// One column for each scene that has rows, so that its views stand one above the other.
int scenes_in(const std::vector<ChartRow>& rows) {
  return static_cast<int>(std::count_if(kChartScenes.begin(), kChartScenes.end(), [&rows](const ChartScene& scene) {
    return std::any_of(rows.begin(), rows.end(), [&scene](const ChartRow& r) { return r.scene == scene.name; });
  }));
}

/// False for method yarn with fewer than all samples.
bool has_all_samples(const ChartRow& r) { return r.method != Method::kYarn || r.samples == formulas::kMaxYarnSamples; }

std::vector<KeyEntry> method_key(const std::vector<ChartRow>& rows, bool coloured, bool line) {
  std::vector<KeyEntry> key;
  for (const ChartMethod& s : kChartMethods) {
    const bool there = std::any_of(rows.begin(), rows.end(), [&s](const ChartRow& r) { return r.method == s.method; });
    if (there)
      key.push_back({std::string(method_name(s.method)), coloured ? s.ink : Ink{0.3, 0.32, 0.35}, s.marker, line});
  }
  return key;
}

std::vector<double> values_of(const std::vector<ChartRow>& rows, double ChartRow::*field) {
  std::vector<double> values;
  for (const ChartRow& r : rows) values.push_back(std::max(r.*field, kMinError));
  return values;
}

PlotAxis log_axis(const std::string& title, const std::vector<double>& values) {
  PlotAxis axis;
  axis.title = title;
  fit_log(axis, values);
  return axis;
}

/// Points of one footprint by cost; the curve joins those on the Pareto front.
std::vector<Curve> cost_curves(const std::vector<ChartRow>& rows, size_t footprint) {
  std::vector<ChartRow> here;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(here),
               [footprint](const ChartRow& r) { return r.yarns_per_pixel == kChartFootprints[footprint]; });
  std::sort(here.begin(), here.end(),
            [](const ChartRow& a, const ChartRow& b) { return a.ns_per_pixel < b.ns_per_pixel; });
  Curve all, front;
  all.ink = front.ink = kFootprintInks[footprint];
  all.width = 0, front.width = 1.8;
  front.label = kFootprintNames[footprint];
  for (const ChartRow& r : here) {
    const PlotPoint p{
        r.ns_per_pixel, std::max(r.model_error, kMinError), chart_method(r.method).marker, r.on_front, {}};
    all.points.push_back(p);
    if (r.on_front) front.points.push_back({p.x, p.y, Marker::kNone, false, {}});
  }
  return {front, all};
}

Figure cost_figure(const std::vector<ChartRow>& rows, const std::string& device) {
  Figure figure;
  figure.title = "Error against cost";
  figure.subtitle =
      "Relative RMSE against traced threads; for each footprint (yarns per pixel, at the end of the curve) the "
      "Pareto front. " +
      device;
  figure.key = method_key(rows, false, false);
  figure.columns = scenes_in(rows);
  const PlotAxis x = log_axis("nanoseconds per pixel", values_of(rows, &ChartRow::ns_per_pixel));
  const PlotAxis y = log_axis("error", values_of(rows, &ChartRow::model_error));
  for (const int view : kChartViews) {
    for (const ChartScene& scene : kChartScenes) {
      PlotPanel panel{scene_title(scene.name, view), x, y, {}, kModelGoal, "goal 0.15"};
      const std::vector<ChartRow> here = rows_at(rows, scene.name, view);
      if (here.empty()) continue;
      for (size_t f = 0; f < kChartFootprints.size(); ++f) {
        for (Curve& curve : cost_curves(here, f)) panel.curves.push_back(std::move(curve));
      }
      figure.panels.push_back(std::move(panel));
    }
  }
  return figure;
}

Figure footprint_figure(const std::vector<ChartRow>& rows, double ChartRow::*error, const std::string& title,
                        const std::string& subtitle, double goal) {
  Figure figure;
  figure.title = title, figure.subtitle = subtitle;
  figure.columns = scenes_in(rows);
  PlotAxis x{"yarns per pixel", 0.05, 10, true, {kChartFootprints.begin(), kChartFootprints.end()}, kFootprintNames};
  const PlotAxis y = log_axis("error", values_of(rows, error));
  for (const int view : kChartViews) {
    for (const ChartScene& scene : kChartScenes) {
      std::ostringstream goal_name;
      goal_name << "goal " << goal;
      PlotPanel panel{scene_title(scene.name, view), x, y, {}, goal, goal_name.str()};
      const std::vector<ChartRow> here = rows_at(rows, scene.name, view);
      if (here.empty()) continue;
      for (const ChartMethod& s : kChartMethods) {
        Curve curve{std::string(method_name(s.method)),
                    s.ink,
                    s.method == Method::kAuto ? 2.2 : 1.4,
                    s.method == Method::kAuto,
                    {}};
        for (const ChartRow& r : here) {
          if (r.method == s.method && has_all_samples(r))
            curve.points.push_back({r.yarns_per_pixel, std::max(r.*error, kMinError), s.marker, false, {}});
        }
        std::sort(curve.points.begin(), curve.points.end(),
                  [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
        if (!curve.points.empty()) panel.curves.push_back(std::move(curve));
      }
      figure.panels.push_back(std::move(panel));
    }
  }
  return figure;
}

Figure albedo_figure(const std::vector<Brightness>& values) {
  Figure figure;
  figure.title = "Albedo against angle";
  figure.subtitle =
      "Radiance towards the viewer divided by that of a white Lambertian; light 40° from the normal, 4 yarns per pixel";
  double most = 0;
  for (const Brightness& b : values) most = std::max(most, b.value);
  for (const ChartScene& scene : kChartScenes) {
    std::string title = scene_title(scene.name, 0);
    title.resize(title.rfind(','));
    PlotPanel panel{title,
                    {"view, degrees from the normal", 0, 90, false, {0, 30, 60, 80}, {}},
                    {"albedo", 0, most * 1.05, false, {}, {}},
                    {},
                    0,
                    {}};
    std::ostringstream unused;
    const double step = most > 2 ? 1 : most > 0.8 ? 0.2 : 0.1;
    for (int k = 0; k * step <= most * 1.05; ++k) panel.y.ticks.push_back(std::round(k * step * 100) / 100);
    const auto curve_of = [&](const std::string& method, Ink ink, Marker marker, double width) {
      Curve curve{method, ink, width, false, {}};
      for (const Brightness& b : values) {
        if (b.scene == scene.name && b.method == method)
          curve.points.push_back({b.view_deg, b.value, marker, false, {}});
      }
      if (!curve.points.empty()) panel.curves.push_back(std::move(curve));
    };
    curve_of("truth", {0.72, 0.74, 0.76}, Marker::kNone, 6);
    for (const ChartMethod& s : kChartMethods) curve_of(std::string(method_name(s.method)), s.ink, s.marker, 1.4);
    if (!panel.curves.empty()) figure.panels.push_back(std::move(panel));
  }
  figure.columns = static_cast<int>(figure.panels.size());
  return figure;
}

struct Memory {
  Method method;
  double yarns_per_pixel, bytes, error;
};

/// Geometric means over scenes and views.
std::vector<Memory> memory_points(const std::vector<ChartRow>& rows) {
  std::vector<Memory> points;
  for (const double footprint : kChartFootprints) {
    for (const ChartMethod& s : kChartMethods) {
      double count = 0, bytes = 0, error = 0;
      for (const ChartRow& r : rows) {
        if (r.method != s.method || r.yarns_per_pixel != footprint || !has_all_samples(r)) continue;
        count += 1, bytes += std::log(std::max(r.bytes, 1.0)), error += std::log(std::max(r.model_error, kMinError));
      }
      if (count > 0) points.push_back({s.method, footprint, std::exp(bytes / count), std::exp(error / count)});
    }
  }
  return points;
}

Figure memory_figure(const std::vector<Memory>& points, const std::vector<ChartRow>& rows) {
  Figure figure;
  figure.title = "Memory against error";
  figure.subtitle =
      "Texture bytes that a method reads, both faces, against its error; geometric means over scenes and views";
  figure.columns = 6, figure.panel_width = 230;
  figure.key = method_key(rows, true, false);
  std::vector<double> bytes, errors;
  for (const Memory& m : points) bytes.push_back(m.bytes), errors.push_back(m.error);
  for (size_t f = 0; f < kChartFootprints.size(); ++f) {
    PlotPanel panel{kFootprintNames[f] + (kChartFootprints[f] > 1 ? " yarns per pixel" : " yarn per pixel"),
                    log_axis("bytes", bytes),
                    log_axis("error", errors),
                    {},
                    kModelGoal,
                    "goal 0.15"};
    for (const Memory& m : points) {
      if (m.yarns_per_pixel != kChartFootprints[f]) continue;
      panel.curves.push_back(
          {{}, chart_method(m.method).ink, 0, false, {{m.bytes, m.error, chart_method(m.method).marker, false, {}}}});
    }
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

std::string albedo_csv(const std::vector<Brightness>& values) {
  std::ostringstream out;
  out << "scene,method,view_deg,albedo\n";
  for (const Brightness& b : values) out << b.scene << ',' << b.method << ',' << b.view_deg << ',' << b.value << '\n';
  return out.str();
}

std::string memory_csv(const std::vector<Memory>& points) {
  std::ostringstream out;
  out << "method,yarns_per_pixel,bytes,rel_rmse_model\n";
  for (const Memory& m : points)
    out << method_name(m.method) << ',' << m.yarns_per_pixel << ',' << m.bytes << ',' << m.error << '\n';
  return out.str();
}

std::string noise_csv(const std::vector<TruthNoise>& noise) {
  std::ostringstream out;
  out << "scene,view_deg,yarns_per_pixel,rel_rmse_noise\n";
  for (const TruthNoise& n : noise)
    out << n.scene << ',' << n.view_deg << ',' << n.yarns_per_pixel << ',' << n.noise << '\n';
  return out.str();
}

/// The columns that a figure shows.
std::string part_csv(const std::vector<ChartRow>& rows, const std::string& name, double ChartRow::*field, bool front) {
  std::ostringstream out;
  out << "scene,view_deg,yarns_per_pixel,method,samples," << name << (front ? ",rel_rmse_model,on_front\n" : "\n");
  for (const ChartRow& r : rows) {
    out << r.scene << ',' << r.view_deg << ',' << r.yarns_per_pixel << ',' << method_name(r.method) << ',' << r.samples
        << ',' << r.*field;
    if (front) out << ',' << r.model_error << ',' << (r.on_front ? 1 : 0);
    out << '\n';
  }
  return out.str();
}

}  // namespace

base::Result<void> write_chart_figures(const std::string& dir, const std::string& device,
                                       const std::vector<ChartRow>& rows, const std::vector<Brightness>& brightness,
                                       const std::vector<TruthNoise>& noise) {
  const std::vector<Memory> memory = memory_points(rows);
  const std::array<std::function<base::Result<void>()>, 11> steps{
      [&] { return write_figure(cost_figure(rows, device), dir + "/error_cost"); },
      [&] {
        return write_file_atomically(dir + "/error_cost.csv",
                                     part_csv(rows, "ns_per_pixel", &ChartRow::ns_per_pixel, true));
      },
      [&] {
        return write_figure(footprint_figure(rows, &ChartRow::model_error, "Error against footprint",
                                             "Relative RMSE against traced threads", kModelGoal),
                            dir + "/error_footprint");
      },
      [&] {
        return write_file_atomically(dir + "/error_footprint.csv",
                                     part_csv(rows, "rel_rmse_model", &ChartRow::model_error, false));
      },
      [&] {
        return write_figure(
            footprint_figure(rows, &ChartRow::filtering_error, "Filtering error against footprint",
                             "Relative RMSE against the method's own picture from at least 1,024 samples per pixel",
                             kFilteringGoal),
            dir + "/filtering_footprint");
      },
      [&] {
        return write_file_atomically(dir + "/filtering_footprint.csv",
                                     part_csv(rows, "rel_rmse_filtering", &ChartRow::filtering_error, false));
      },
      [&] { return write_figure(albedo_figure(brightness), dir + "/albedo"); },
      [&] { return write_file_atomically(dir + "/albedo.csv", albedo_csv(brightness)); },
      [&] { return write_figure(memory_figure(memory, rows), dir + "/memory"); },
      [&] { return write_file_atomically(dir + "/memory.csv", memory_csv(memory)); },
      [&] { return write_file_atomically(dir + "/truth_noise.csv", noise_csv(noise)); },
  };
  for (const auto& step : steps) {
    if (auto done = step(); !done) return done;
  }
  return {};
}

}  // namespace weftlight::chart
