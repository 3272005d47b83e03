#include "print/pen.h"

namespace weftlight::print {
namespace {

void set_color(cairo_t* context, const Rgb& c, double opacity = 1) {
  cairo_set_source_rgba(context, static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b), opacity);
}

}  // namespace

void Pen::fill(double x, double y, double width, double height, const Rgb& color) const {
  set_color(context_, color);
  cairo_rectangle(context_, x, y, width, height);
  cairo_fill(context_);
}

void Pen::line(double x0, double y0, double x1, double y1, double width, const Rgb& color, double opacity) const {
  set_color(context_, color, opacity);
  cairo_set_line_width(context_, width);
  cairo_move_to(context_, x0, y0);
  cairo_line_to(context_, x1, y1);
  cairo_stroke(context_);
}

void Pen::frame(double x, double y, double width, double height, double line, const Rgb& color) const {
  set_color(context_, color);
  cairo_set_line_width(context_, line);
  cairo_rectangle(context_, x, y, width, height);
  cairo_stroke(context_);
}

void Pen::font(double size, bool bold) const {
  cairo_select_font_face(context_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_, size);
}

double Pen::width_of(double size, const std::string& text, bool bold) const {
  font(size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context_, text.c_str(), &extents);
  return extents.x_advance;
}

double Pen::text(double x, double y, double size, const std::string& text, const Rgb& color, bool bold) const {
  font(size, bold);
  set_color(context_, color);
  cairo_move_to(context_, x, y);
  cairo_show_text(context_, text.c_str());
  return width_of(size, text, bold);
}

void Pen::text_right(double x, double y, double size, const std::string& text, const Rgb& color) const {
  this->text(x - width_of(size, text), y, size, text, color);
}

}  // namespace weftlight::print
