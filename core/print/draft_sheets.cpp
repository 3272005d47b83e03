// The grids of a draft, arranged as in the window: threading above or below with shaft 1 next to the drawdown, tie-up
// in the corner, treadling or liftplan on the right. A draft that is larger than a sheet continues on the next.

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "design/dye.h"
#include "print/sheets.h"

namespace weftlight::print {

using base::arg, base::fill, base::tr, base::tr_n;
using design::Design;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::System, draft::drawdown;

namespace {

constexpr double kTitleMm = 16;  // above the grids of every sheet
constexpr double kFootMm = 6;
constexpr int kGap = 1;  // cells between grids
constexpr int kBar = 1;  // width of a colour bar, cells
constexpr double kMaxCell_mm = 5;

/// Sizes in cells. Across: drawdown, gap, weft colours, gap, treadles. Down the same with shafts.
struct Layout {
  int ends, picks, shafts, sides;  // sides: treadles, or shafts of a liftplan
  double cell;
  int columns_per_sheet, rows_per_sheet;  // of drawdown
  int sheets_across, sheets_down;
  int head_rows() const { return shafts + kGap + kBar + kGap; }
  int side_columns() const { return sides + kGap + kBar + kGap; }
};

double width_mm_for_grids(const PrintOptions& o) { return o.paper.width_mm - 2 * kMargin - 8; }
double height_mm_for_grids(const PrintOptions& o) { return o.paper.height_mm - 2 * kMargin - kTitleMm - kFootMm - 4; }

Layout layout_of(const Draft& d, const PrintOptions& o) {
  Layout p{};
  p.ends = d.ends();
  p.picks = d.picks();
  p.shafts = d.shafts;
  p.sides = d.shed_control == ShedControl::kLiftplan ? d.shafts : d.treadles;
  const double fits =
      std::min(width_mm_for_grids(o) / (p.ends + p.side_columns()), height_mm_for_grids(o) / (p.picks + p.head_rows()));
  p.cell = o.cell_mm > 0 ? std::clamp(o.cell_mm, 0.5, 20.0) : std::clamp(fits, kMinCell_mm, kMaxCell_mm);
  const auto threads_per_sheet = [&](double room, int fixed, int threads) {
    const int all = static_cast<int>(room / p.cell + 1e-6) - fixed;
    const int most = std::max(all, 4);
    // On several sheets, whole groups of ten, so that each sheet starts with a round number.
    return threads <= most ? threads : most >= 20 ? most - most % 10 : most;
  };
  p.columns_per_sheet = std::max(threads_per_sheet(width_mm_for_grids(o), p.side_columns(), p.ends), 1);
  p.rows_per_sheet = std::max(threads_per_sheet(height_mm_for_grids(o), p.head_rows(), p.picks), 1);
  p.sheets_across = (p.ends + p.columns_per_sheet - 1) / p.columns_per_sheet;
  p.sheets_down = (p.picks + p.rows_per_sheet - 1) / p.rows_per_sheet;
  return p;
}

/// The part of the drawdown on one sheet, half-open.
struct SheetPart {
  int end0, end1, pick0, pick1;
};

/// The lines of a grid at (x, y): `columns` x `rows` cells, a heavier line every n cells, a frame.
struct GridLines {
  double x, y, cell;
  int columns, rows, first_column, first_row;
  bool from_right = false, from_below = false;  // position of column 0 and row 0
};

void draw_grid_lines(const Pen& pen, const GridLines& n, int heavy, bool over_colors = false) {
  const double width = n.columns * n.cell, height = n.rows * n.cell;
  const double thin = std::min(0.06, n.cell * 0.05);
  const auto rule = [&](double x0, double y0, double x1, double y1, int thread) {
    const bool strong = heavy > 0 && thread % heavy == 0;
    // Over colours a translucent dark line, invisible on dark threads.
    if (over_colors) pen.line(x0, y0, x1, y1, strong ? thin * 2.5 : thin, kInk, strong ? 0.45 : 0.25);
    else pen.line(x0, y0, x1, y1, strong ? thin * 2.5 : thin, strong ? kMuted : kFaint);
  };
  for (int c = 1; c < n.columns; ++c)
    rule(n.x + c * n.cell, n.y, n.x + c * n.cell, n.y + height, n.first_column + (n.from_right ? n.columns - c : c));
  for (int r = 1; r < n.rows; ++r)
    rule(n.x, n.y + r * n.cell, n.x + width, n.y + r * n.cell, n.first_row + (n.from_below ? n.rows - r : r));
  pen.frame(n.x, n.y, width, height, 0.18, kInk);
}

struct Drawing {
  const Design& design;
  const BitMatrix& cells;
  const PrintOptions& options;
  Layout layout;
  double x0 = kMargin, y0 = kMargin + kTitleMm;
  design::DyedThreads dyed{design};

  const Draft& draft() const { return design.draft; }
  double cell() const { return layout.cell; }
  /// Left edge of an end's column.
  double end_x(const SheetPart& part, int end) const {
    const int column = options.end1_right ? part.end1 - 1 - end : end - part.end0;
    return x0 + column * cell();
  }
  double side_x(const SheetPart& part) const { return x0 + (part.end1 - part.end0 + kGap + kBar + kGap) * cell(); }
  double bar_x(const SheetPart& part) const { return x0 + (part.end1 - part.end0 + kGap) * cell(); }
  /// Treadle 1 stands next to the drawdown.
  double treadle_x(const SheetPart& part, int treadle) const { return side_x(part) + treadle * cell(); }
  /// Shaft 1 and the bar stand next to the drawdown.
  double shafts_y(const SheetPart& part) const {
    const int below = part.pick1 - part.pick0 + kGap + kBar + kGap;
    return y0 + (options.threading_below ? below : 0) * cell();
  }
  double shaft_y(const SheetPart& part, int shaft) const {
    return shafts_y(part) + (options.threading_below ? shaft : layout.shafts - 1 - shaft) * cell();
  }
  double warp_bar_y(const SheetPart& part) const {
    const int row = options.threading_below ? part.pick1 - part.pick0 + kGap : layout.shafts + kGap;
    return y0 + row * cell();
  }
  double picks_y() const { return y0 + (options.threading_below ? 0 : layout.head_rows()) * cell(); }
  double pick_y(const SheetPart& part, int pick) const {
    return picks_y() + (options.pick1_bottom ? part.pick1 - 1 - pick : pick - part.pick0) * cell();
  }
  const Rgb& color_of(System system, int thread) const {
    return draft().palette[static_cast<size_t>(draft().threads(system).color[static_cast<size_t>(thread)])];
  }
};

void draw_mark(const Pen& pen, const Drawing& g, double x, double y) { pen.fill(x, y, g.cell(), g.cell(), kInk); }

void draw_threading(const Pen& pen, const Drawing& g, const SheetPart& part) {
  for (int e = part.end0; e < part.end1; ++e)
    for (int s = 0; s < g.layout.shafts; ++s)
      if (g.draft().threading.get(e, s)) draw_mark(pen, g, g.end_x(part, e), g.shaft_y(part, s));
  const double left = g.end_x(part, g.options.end1_right ? part.end1 - 1 : part.end0);
  draw_grid_lines(pen,
                  {left, g.shafts_y(part), g.cell(), part.end1 - part.end0, g.layout.shafts, part.end0, 0,
                   g.options.end1_right, !g.options.threading_below},
                  g.options.heavy_lines);
  for (int e = part.end0; e < part.end1; ++e)
    pen.fill(g.end_x(part, e), g.warp_bar_y(part), g.cell(), g.cell(), g.color_of(System::kWarp, e));
  pen.frame(left, g.warp_bar_y(part), (part.end1 - part.end0) * g.cell(), g.cell(), 0.12, kMuted);
}

void draw_sides(const Pen& pen, const Drawing& g, const SheetPart& part) {
  const Draft& d = g.draft();
  const bool plan = d.shed_control == ShedControl::kLiftplan;
  const BitMatrix& rows = plan ? d.liftplan : d.treadling;
  for (int p = part.pick0; p < part.pick1; ++p) {
    for (int t = 0; t < g.layout.sides; ++t)
      if (rows.get(p, t)) draw_mark(pen, g, g.treadle_x(part, t), g.pick_y(part, p));
    pen.fill(g.bar_x(part), g.pick_y(part, p), g.cell(), g.cell(), g.color_of(System::kWeft, p));
  }
  const int picks = part.pick1 - part.pick0;
  draw_grid_lines(
      pen, {g.side_x(part), g.picks_y(), g.cell(), g.layout.sides, picks, 0, part.pick0, false, g.options.pick1_bottom},
      g.options.heavy_lines);
  pen.frame(g.bar_x(part), g.picks_y(), g.cell(), picks * g.cell(), 0.12, kMuted);
  if (plan) return;
  for (int t = 0; t < d.treadles; ++t)
    for (int s = 0; s < d.shafts; ++s)
      if (d.tieup.get(t, s)) draw_mark(pen, g, g.treadle_x(part, t), g.shaft_y(part, s));
  draw_grid_lines(
      pen, {g.side_x(part), g.shafts_y(part), g.cell(), d.treadles, d.shafts, 0, 0, false, !g.options.threading_below},
      g.options.heavy_lines);
}

/// In the colours of the threads, one rectangle per run of one colour.
void draw_drawdown(const Pen& pen, const Drawing& g, const SheetPart& part) {
  const auto color = [&](int pick, int end) -> const Rgb& {
    return color_on_top(g.draft(), g.dyed, g.cells.get(pick, end), end, pick);
  };
  for (int p = part.pick0; p < part.pick1; ++p)
    for (int e = part.end0; e < part.end1;) {
      int last = e;
      while (last + 1 < part.end1 && color(p, last + 1) == color(p, e)) ++last;
      const double left = std::min(g.end_x(part, e), g.end_x(part, last));
      pen.fill(left, g.pick_y(part, p), (last - e + 1) * g.cell(), g.cell(), color(p, e));
      e = last + 1;
    }
  const double left = g.end_x(part, g.options.end1_right ? part.end1 - 1 : part.end0);
  draw_grid_lines(pen,
                  {left, g.picks_y(), g.cell(), part.end1 - part.end0, part.pick1 - part.pick0, part.end0, part.pick0,
                   g.options.end1_right, g.options.pick1_bottom},
                  g.options.heavy_lines, true);
}

void draw_numbers(const Pen& pen, const Drawing& g, const SheetPart& part) {
  const double size = std::clamp(g.cell() * 0.9, 1.5, 2.4);
  const int step = g.cell() * 5 >= pen.width_of(size, "8888") + 1 ? 5 : 10;
  for (int e = part.end0; e < part.end1; ++e)
    if ((e + 1) % step == 0 || e == 0) {
      const std::string n = std::to_string(e + 1);
      pen.text(g.end_x(part, e) + (g.cell() - pen.width_of(size, n)) / 2, g.y0 - 0.8, size, n, kMuted);
    }
  const double side = g.side_x(part) + g.layout.sides * g.cell() + 1;
  for (int p = part.pick0; p < part.pick1; ++p)
    if ((p + 1) % 5 == 0 || p == 0) {
      const double y = g.pick_y(part, p) + (g.cell() + size * 0.7) / 2;
      pen.text(side, y, size, std::to_string(p + 1), kMuted);
    }
}

void draw_title(const Pen& pen, const Drawing& g, const SheetPart& part, int sheet) {
  const Draft& d = g.draft();
  const std::string title = !g.design.title.empty()   ? g.design.title
                            : !g.options.name.empty() ? g.options.name
                                                      : tr("Draft");
  pen.text(kMargin, kMargin + 4.5, 5, title, kInk, true);
  std::string facts = fill(tr_n("{count} end", "{count} ends", d.ends()), arg("count", d.ends()));
  const auto add = [&facts](const std::string& fact) { facts.append(", ").append(fact); };
  add(fill(tr_n("{count} pick", "{count} picks", d.picks()), arg("count", d.picks())));
  add(fill(tr_n("{count} shaft", "{count} shafts", d.shafts), arg("count", d.shafts)));
  if (d.shed_control == ShedControl::kTreadling)
    add(fill(tr_n("{count} treadle", "{count} treadles", d.treadles), arg("count", d.treadles)));
  add(d.rising ? tr("rising shed") : tr("sinking shed"));
  if (!g.design.author.empty()) facts = g.design.author + "    " + facts;
  pen.text(kMargin, kMargin + 9.5, 2.8, facts, kMuted);
  if (g.layout.sheets_across * g.layout.sheets_down == 1) return;
  const double right = g.options.paper.width_mm - kMargin;
  pen.text_right(right, kMargin + 4.5, 2.8,
                 fill(tr("ends {end0} to {end1}, picks {pick0} to {pick1}"), arg("end0", part.end0 + 1),
                      arg("end1", part.end1), arg("pick0", part.pick0 + 1), arg("pick1", part.pick1)),
                 kInk);
  pen.text_right(right, kMargin + 9.5, 2.8,
                 fill(tr("sheet {sheet} of {count}"), arg("sheet", sheet + 1),
                      arg("count", g.layout.sheets_across * g.layout.sheets_down)),
                 kMuted);
}

}  // namespace

base::Result<std::vector<Sheet>> draft_sheets(const Design& design, const PrintOptions& options) {
  const Layout layout = layout_of(design.draft, options);
  const int64_t sheets = int64_t{layout.sheets_across} * layout.sheets_down;
  if (sheets > kMaxSheets)
    return base::failure(base::ErrorKind::kInput,
                         fill(tr_n("this needs {count} sheet; choose a smaller scale",
                                   "this needs {count} sheets; choose a smaller scale", sheets),
                              arg("count", sheets)));
  std::vector<Sheet> out;
  const auto cells = std::make_shared<const BitMatrix>(drawdown(design.draft));
  for (int down = 0; down < layout.sheets_down; ++down)
    for (int across = 0; across < layout.sheets_across; ++across) {
      const SheetPart part{across * layout.columns_per_sheet,
                           std::min((across + 1) * layout.columns_per_sheet, layout.ends), down * layout.rows_per_sheet,
                           std::min((down + 1) * layout.rows_per_sheet, layout.picks)};
      const int number = static_cast<int>(out.size());
      out.push_back([&design, cells, options, layout, part, number](const Pen& pen) {
        const Drawing g{design, *cells, options, layout};
        draw_title(pen, g, part, number);
        draw_drawdown(pen, g, part);
        draw_threading(pen, g, part);
        draw_sides(pen, g, part);
        draw_numbers(pen, g, part);
      });
    }
  return out;
}

}  // namespace weftlight::print
