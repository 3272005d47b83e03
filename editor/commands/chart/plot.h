#pragma once
// Figures of small panels with axes, curves and labels beside them, as .svg and .png.

#include <string>
#include <vector>

#include "commands/chart/names.h"

namespace weftlight::chart::plot {

struct Ink {
  double r = 0, g = 0, b = 0;
};

enum class Marker { kNone, kCircle, kSquare, kDiamond, kUp, kDown, kCross, kRing, kStar };

struct PlotPoint {
  double x = 0, y = 0;
  Marker marker = Marker::kCircle;
  bool strong = false;  // outlined: on the front
  std::string label;    // beside the point
};

struct Curve {
  std::string label;  // beside the last point
  Ink ink;
  double width = 1.6;  // of the line; 0: points alone
  bool dashed = false;
  std::vector<PlotPoint> points;
};

struct Axis {
  std::string title;
  double from = 0, to = 1;
  bool log = false;
  std::vector<double> ticks;             // empty: chosen
  std::vector<std::string> tick_labels;  // as ticks, or empty
};

struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Curve> curves;
  double goal = 0;         // > 0: a dotted line at this y ...
  std::string goal_label;  // ... and its name
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
  std::vector<Panel> panels;  // row by row
  std::vector<KeyEntry> key;
};

/// Writes BASE.svg and BASE.png. Empty: done; else what went wrong.
std::string write_figure(const Figure& figure, const std::string& base);

/// The least and greatest power-of-ten bounds with some room around the values.
void fit_log(Axis& axis, const std::vector<double>& values);

}  // namespace weftlight::chart::plot
