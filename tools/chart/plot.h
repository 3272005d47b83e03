#pragma once
// Figures of small panels with axes, curves and labels, as .svg and .png.

#include <string>
#include <vector>

#include "base/result.h"

namespace weftlight::chart::plot {

struct Ink {
  double r = 0, g = 0, b = 0;
};

enum class Marker { kNone, kCircle, kSquare, kDiamond, kUp, kDown, kCross, kPlus, kRing, kStar };

struct PlotPoint {
  double x = 0, y = 0;
  Marker marker = Marker::kCircle;
  bool strong = false;  // outlined: on the Pareto front
  std::string label;    // beside the point
};

struct Curve {
  std::string label;  // beside the last point
  Ink ink;
  double width = 1.6;  // of the line; 0: points only
  bool dashed = false;
  std::vector<PlotPoint> points;
};

struct PlotAxis {
  std::string title;
  double from = 0, to = 1;
  bool log = false;
  std::vector<double> ticks;             // empty: chosen
  std::vector<std::string> tick_labels;  // one for each tick, or empty
};

struct PlotPanel {
  std::string title;
  PlotAxis x, y;
  std::vector<Curve> curves;
  double goal = 0;         // > 0: a dotted line at this y
  std::string goal_label;  // label of that line
};

struct KeyEntry {
  std::string label;
  Ink ink;
  Marker marker = Marker::kCircle;
  bool line = false;
};

struct Figure {
  std::string title, subtitle;
  int columns = 4;
  double panel_width = 270, panel_height = 220;
  std::vector<PlotPanel> panels;  // row by row
  std::vector<KeyEntry> key;
};

/// Writes BASE.svg and BASE.png.
base::Result<void> write_figure(const Figure& figure, const std::string& base);

/// Sets a logarithmic axis with some room around the values.
void fit_log(PlotAxis& axis, const std::vector<double>& values);

}  // namespace weftlight::chart::plot
