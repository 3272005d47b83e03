#include "chart/plot.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "base/text.h"
#include "base/whole_files.h"

namespace weftlight::chart::plot {

using base::write_through;

namespace {

constexpr double kLeft = 52, kRight = 56, kTop = 30, kBottom = 44;  // margins in a panel
constexpr double kMargin = 28, kHead = 66, kKeyHeight = 40;
constexpr double kPngScale = 1.6;
constexpr double kLabelStep = 11;  // minimum distance of two labels
constexpr Ink kText{0.13, 0.15, 0.18}, kQuiet{0.45, 0.48, 0.52}, kGrid{0.90, 0.91, 0.92}, kAxisInk{0.62, 0.64, 0.67};

using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Sheet = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void set_ink(cairo_t* c, Ink ink, double alpha = 1) { cairo_set_source_rgba(c, ink.r, ink.g, ink.b, alpha); }

enum class Align { kStart, kMiddle, kEnd };

void write(cairo_t* c, double x, double y, const std::string& text, double size, Ink ink, Align align = Align::kStart,
           bool bold = false) {
  cairo_select_font_face(c, "Inter", CAIRO_FONT_SLANT_NORMAL, bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, size);
  cairo_text_extents_t extents;
  cairo_text_extents(c, text.c_str(), &extents);
  const double back = align == Align::kStart ? 0 : align == Align::kMiddle ? extents.x_advance / 2 : extents.x_advance;
  cairo_move_to(c, x - back, y);
  set_ink(c, ink);
  cairo_show_text(c, text.c_str());
}

double text_width(cairo_t* c, const std::string& text, double size) {
  cairo_select_font_face(c, "Inter", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, size);
  cairo_text_extents_t extents;
  cairo_text_extents(c, text.c_str(), &extents);
  return extents.x_advance;
}

void polygon(cairo_t* c, double x, double y, std::initializer_list<std::pair<double, double>> corners) {
  cairo_new_path(c);
  for (const auto& [dx, dy] : corners) cairo_line_to(c, x + dx, y + dy);
  cairo_close_path(c);
}

void star(cairo_t* c, double x, double y, double r) {
  cairo_new_path(c);
  for (int i = 0; i < 10; ++i) {
    const double angle = i * 0.62831853, radius = i % 2 ? r * 0.45 : r;
    cairo_line_to(c, x + radius * std::sin(angle), y - radius * std::cos(angle));
  }
  cairo_close_path(c);
}

void shape(cairo_t* c, Marker marker, double x, double y, double r) {
  switch (marker) {
    case Marker::kSquare:
      return polygon(c, x, y, {{-r, -r}, {r, -r}, {r, r}, {-r, r}});
    case Marker::kDiamond:
      return polygon(c, x, y, {{0, -1.3 * r}, {1.3 * r, 0}, {0, 1.3 * r}, {-1.3 * r, 0}});
    case Marker::kUp:
      return polygon(c, x, y, {{0, -1.25 * r}, {1.2 * r, r}, {-1.2 * r, r}});
    case Marker::kDown:
      return polygon(c, x, y, {{0, 1.25 * r}, {1.2 * r, -r}, {-1.2 * r, -r}});
    case Marker::kStar:
      return star(c, x, y, 1.6 * r);
    default:
      cairo_new_path(c);
      cairo_arc(c, x, y, r, 0, 6.2831853);
  }
}

void draw_marker(cairo_t* c, const PlotPoint& p, Ink ink, double x, double y) {
  if (p.marker == Marker::kNone) return;
  constexpr double kSize = 3.1;
  if (p.marker == Marker::kCross || p.marker == Marker::kPlus) {
    set_ink(c, ink);
    cairo_set_line_width(c, 1.8);
    const double along = p.marker == Marker::kCross ? kSize : 1.3 * kSize,
                 aside = p.marker == Marker::kCross ? kSize : 0;
    cairo_move_to(c, x - along, y - aside), cairo_line_to(c, x + along, y + aside);
    cairo_move_to(c, x - aside, y + along), cairo_line_to(c, x + aside, y - along);
    cairo_stroke(c);
    return;
  }
  shape(c, p.marker, x, y, kSize);
  if (p.marker == Marker::kRing) cairo_set_source_rgb(c, 1, 1, 1);
  else set_ink(c, ink);
  cairo_fill_preserve(c);
  if (p.marker == Marker::kRing) set_ink(c, ink);
  else if (p.strong) set_ink(c, kText);
  else cairo_set_source_rgb(c, 1, 1, 1);
  cairo_set_line_width(c, p.marker == Marker::kRing ? 1.8 : p.strong ? 1.3 : 0.6);
  cairo_stroke(c);
}

/// Maps values to positions on the sheet.
struct Frame2D {
  const PlotPanel& panel;
  double x0, y0, width, height;  // y0: top

  static double fraction(const PlotAxis& a, double v) {
    if (!a.log) return (v - a.from) / (a.to - a.from);
    return std::log(std::max(v, 1e-30) / a.from) / std::log(a.to / a.from);
  }
  double x(double v) const { return x0 + width * std::clamp(fraction(panel.x, v), 0.0, 1.0); }
  double y(double v) const { return y0 + height * (1 - std::clamp(fraction(panel.y, v), 0.0, 1.0)); }
};

std::string short_number(double v) {
  char text[32];
  if (v >= 1e6) std::snprintf(text, sizeof text, "%gM", v / 1e6);
  else if (v >= 1e3) std::snprintf(text, sizeof text, "%gk", v / 1e3);
  else std::snprintf(text, sizeof text, "%g", v);
  return text;
}

std::vector<double> ticks_of(const PlotAxis& a) {
  if (!a.ticks.empty()) return a.ticks;
  std::vector<double> ticks;
  if (a.log) {
    const double range = a.to / a.from;
    const std::vector<double> steps = range > 1000 ? std::vector<double>{1}
                                      : range > 60 ? std::vector<double>{1, 3}
                                      : range > 12 ? std::vector<double>{1, 2, 5}
                                                   : std::vector<double>{1, 2, 3, 5, 7};
    const auto last = static_cast<int>(std::floor(std::log10(a.to)));
    for (auto power = static_cast<int>(std::floor(std::log10(a.from))); power <= last; ++power) {
      for (const double k : steps) {
        const double v = k * std::pow(10, power);
        if (v >= a.from * 0.999 && v <= a.to * 1.001) ticks.push_back(v);
      }
    }
    return ticks;
  }
  for (int i = 0; i <= 5; ++i) ticks.push_back(a.from + (a.to - a.from) * i / 5);
  return ticks;
}

std::string tick_label(const PlotAxis& a, size_t i, double v) {
  return i < a.tick_labels.size() ? a.tick_labels[i] : short_number(v);
}

void draw_axes(cairo_t* c, const Frame2D& f) {
  const PlotPanel& p = f.panel;
  cairo_set_line_width(c, 0.8);
  const std::vector<double> xs = ticks_of(p.x), ys = ticks_of(p.y);
  for (size_t i = 0; i < xs.size(); ++i) {
    const double x = f.x(xs[i]);
    set_ink(c, kGrid);
    cairo_move_to(c, x, f.y0), cairo_line_to(c, x, f.y0 + f.height), cairo_stroke(c);
    write(c, x, f.y0 + f.height + 14, tick_label(p.x, i, xs[i]), 9.5, kQuiet, Align::kMiddle);
  }
  for (size_t i = 0; i < ys.size(); ++i) {
    const double y = f.y(ys[i]);
    set_ink(c, kGrid);
    cairo_move_to(c, f.x0, y), cairo_line_to(c, f.x0 + f.width, y), cairo_stroke(c);
    write(c, f.x0 - 6, y + 3.4, tick_label(p.y, i, ys[i]), 9.5, kQuiet, Align::kEnd);
  }
  set_ink(c, kAxisInk);
  cairo_move_to(c, f.x0, f.y0 + f.height), cairo_line_to(c, f.x0 + f.width, f.y0 + f.height), cairo_stroke(c);
  write(c, f.x0, f.y0 - 10, p.title, 12, kText, Align::kStart, true);
  write(c, f.x0 + f.width / 2, f.y0 + f.height + 31, p.x.title, 10, kQuiet, Align::kMiddle);
  cairo_save(c);
  cairo_translate(c, f.x0 - 38, f.y0 + f.height / 2);
  cairo_rotate(c, -1.57079633);
  write(c, 0, 0, p.y.title, 10, kQuiet, Align::kMiddle);
  cairo_restore(c);
  if (p.goal > 0 && p.goal > p.y.from && p.goal < p.y.to) {
    const double y = f.y(p.goal), dots[] = {1.5, 3};
    set_ink(c, kQuiet);
    cairo_set_dash(c, dots, 2, 0);
    cairo_move_to(c, f.x0, y), cairo_line_to(c, f.x0 + f.width, y), cairo_stroke(c);
    cairo_set_dash(c, nullptr, 0, 0);
    write(c, f.x0 + f.width - 3, y - 3, p.goal_label, 8.5, kQuiet, Align::kEnd);
  }
}

void draw_line(cairo_t* c, const Frame2D& f, const Curve& curve) {
  if (curve.width <= 0) return;
  set_ink(c, curve.ink);
  cairo_set_line_width(c, curve.width);
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  const double dashes[] = {4, 3};
  cairo_set_dash(c, dashes, curve.dashed ? 2 : 0, 0);
  cairo_new_path(c);
  for (const PlotPoint& p : curve.points) cairo_line_to(c, f.x(p.x), f.y(p.y));
  cairo_stroke(c);
  cairo_set_dash(c, nullptr, 0, 0);
}

struct Tag {
  double y = 0;
  std::string text;
  Ink ink;
};

/// Labels at the right ends of the curves, moved apart so that they do not overlap.
void draw_tags(cairo_t* c, const Frame2D& f) {
  std::vector<Tag> tags;
  for (const Curve& curve : f.panel.curves) {
    if (!curve.label.empty() && !curve.points.empty())
      tags.push_back({f.y(curve.points.back().y), curve.label, curve.ink});
  }
  std::stable_sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.y < b.y; });
  for (size_t i = 1; i < tags.size(); ++i) tags[i].y = std::max(tags[i].y, tags[i - 1].y + kLabelStep);
  const double over = tags.empty() ? 0 : std::max(0.0, tags.back().y - (f.y0 + f.height));
  for (size_t i = tags.size(); i-- > 0;) {
    const double limit = i + 1 < tags.size() ? tags[i + 1].y - kLabelStep : tags[i].y - over;
    tags[i].y = std::min(tags[i].y, limit);
  }
  for (const Tag& tag : tags) write(c, f.x0 + f.width + 6, tag.y + 3.4, tag.text, 9.5, tag.ink);
}

void draw_panel(cairo_t* c, const PlotPanel& panel, double x, double y, const Figure& figure) {
  const Frame2D f{panel, x + kLeft, y + kTop, figure.panel_width - kLeft - kRight,
                  figure.panel_height - kTop - kBottom};
  draw_axes(c, f);
  for (const Curve& curve : panel.curves) draw_line(c, f, curve);
  for (const Curve& curve : panel.curves) {
    for (const PlotPoint& p : curve.points) {
      draw_marker(c, p, curve.ink, f.x(p.x), f.y(p.y));
      if (!p.label.empty()) write(c, f.x(p.x) + 6, f.y(p.y) - 4, p.label, 9, curve.ink);
    }
  }
  draw_tags(c, f);
}

struct Size {
  double width, height;
};

Size size_of(const Figure& figure) {
  const int columns = std::max(1, figure.columns);
  const int rows = (static_cast<int>(figure.panels.size()) + columns - 1) / columns;
  return {2 * kMargin + columns * figure.panel_width,
          kHead + rows * figure.panel_height + (figure.key.empty() ? 0 : kKeyHeight) + kMargin / 2};
}

void draw_key(cairo_t* c, const Figure& figure, double y) {
  double x = kMargin + kLeft;
  for (const KeyEntry& entry : figure.key) {
    if (entry.line) {
      set_ink(c, entry.ink);
      cairo_set_line_width(c, 2);
      cairo_move_to(c, x - 6, y), cairo_line_to(c, x + 6, y), cairo_stroke(c);
    }
    draw_marker(c, {0, 0, entry.marker, false, {}}, entry.ink, x, y);
    write(c, x + 11, y + 3.6, entry.label, 10.5, kText);
    x += 34 + text_width(c, entry.label, 10.5);
  }
}

void draw_figure(cairo_t* c, const Figure& figure) {
  const Size size = size_of(figure);
  cairo_set_source_rgb(c, 1, 1, 1);
  cairo_paint(c);
  write(c, kMargin, 32, figure.title, 17, kText, Align::kStart, true);
  write(c, kMargin, 51, figure.subtitle, 11, kQuiet);
  for (size_t i = 0; i < figure.panels.size(); ++i) {
    const int column = static_cast<int>(i) % figure.columns, row = static_cast<int>(i) / figure.columns;
    draw_panel(c, figure.panels[i], kMargin + column * figure.panel_width, kHead + row * figure.panel_height, figure);
  }
  if (!figure.key.empty()) draw_key(c, figure, size.height - kKeyHeight / 2 - kMargin / 4);
}

base::Result<void> finish(cairo_t* c, cairo_surface_t* sheet) {
  cairo_surface_finish(sheet);
  const bool whole = cairo_status(c) == CAIRO_STATUS_SUCCESS && cairo_surface_status(sheet) == CAIRO_STATUS_SUCCESS;
  if (whole) return {};
  return base::failure(base::ErrorKind::kOutput, base::tr("the drawing failed, or the disk is full"));
}

base::Result<void> write_svg(const Figure& figure, const std::string& path) {
  return write_through(path, [&figure](const std::string& beside) {
    const Size size = size_of(figure);
    const Sheet sheet(cairo_svg_surface_create(beside.c_str(), size.width, size.height), cairo_surface_destroy);
    const Pen pen(cairo_create(sheet.get()), cairo_destroy);
    draw_figure(pen.get(), figure);
    return finish(pen.get(), sheet.get());
  });
}

base::Result<void> write_png(const Figure& figure, const std::string& path) {
  return write_through(path, [&figure](const std::string& beside) {
    const Size size = size_of(figure);
    const Sheet sheet(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width * kPngScale),
                                                 static_cast<int>(size.height * kPngScale)),
                      cairo_surface_destroy);
    const Pen pen(cairo_create(sheet.get()), cairo_destroy);
    cairo_scale(pen.get(), kPngScale, kPngScale);
    draw_figure(pen.get(), figure);
    cairo_surface_flush(sheet.get());
    const cairo_status_t status = cairo_surface_write_to_png(sheet.get(), beside.c_str());
    if (status != CAIRO_STATUS_SUCCESS) return base::written_unless(cairo_status_to_string(status));
    return finish(pen.get(), sheet.get());
  });
}

}  // namespace

base::Result<void> write_figure(const Figure& figure, const std::string& base) {
  if (auto svg = write_svg(figure, base + ".svg"); !svg) return svg;
  return write_png(figure, base + ".png");
}

void fit_log(PlotAxis& axis, const std::vector<double>& values) {
  double least = 1e300, most = 0;
  for (const double v : values) {
    if (v > 0) least = std::min(least, v), most = std::max(most, v);
  }
  axis.log = true;
  if (most <= 0) least = 0.1, most = 1;
  axis.from = least / 1.25, axis.to = most * 1.25;
}

}  // namespace weftlight::chart::plot
