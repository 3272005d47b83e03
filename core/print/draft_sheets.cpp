// The grids of a draft where the window has them: threading above or below with shaft 1 next to the cloth, tie-up in
// the corner, treadling (or liftplan) at the right, drawdown between them. What does not fit on a sheet goes on on the
// next.

#include <algorithm>
#include <cmath>

#include "print/page.h"

namespace weftlight::print {
namespace {

constexpr double kTitleMm = 16;  // above the grids of every sheet
constexpr double kFootMm = 6;
constexpr int kGap = 1;  // cells between grids
constexpr int kBar = 1;  // cells of a colour bar
constexpr double kLargestCell = 5;

/// Sizes in cells. Across: drawdown, gap, weft colours, gap, treadles. Down the same with shafts.
struct Plan {
  int ends, picks, shafts, sides;  // sides: treadles, or shafts of a liftplan
  double cell;
  int columns_a_sheet, rows_a_sheet;  // of drawdown
  int sheets_across, sheets_down;
  int head_rows() const { return shafts + kGap + kBar + kGap; }
  int side_columns() const { return sides + kGap + kBar + kGap; }
};

double room_across(const PrintOptions& o) { return o.paper.width_mm - 2 * kMargin - 8; }
double room_down(const PrintOptions& o) { return o.paper.height_mm - 2 * kMargin - kTitleMm - kFootMm - 4; }

Plan plan_of(const Draft& d, const PrintOptions& o) {
  Plan p{};
  p.ends = d.ends();
  p.picks = d.picks();
  p.shafts = d.shafts;
  p.sides = d.drive == ShedControl::kLiftplan ? d.shafts : d.treadles;
  const double fits = std::min(room_across(o) / (p.ends + p.side_columns()), room_down(o) / (p.picks + p.head_rows()));
  p.cell = o.cell_mm > 0 ? std::clamp(o.cell_mm, 0.5, 20.0) : std::clamp(fits, kSmallestCell, kLargestCell);
  const auto share = [&](double room, int fixed, int threads) {
    const int all = static_cast<int>(room / p.cell + 1e-6) - fixed;
    const int most = std::max(all, 4);
    // Whole groups of ten, where there are several sheets, so that the numbers begin evenly.
    return threads <= most ? threads : most >= 20 ? most - most % 10 : most;
  };
  p.columns_a_sheet = std::max(share(room_across(o), p.side_columns(), p.ends), 1);
  p.rows_a_sheet = std::max(share(room_down(o), p.head_rows(), p.picks), 1);
  p.sheets_across = (p.ends + p.columns_a_sheet - 1) / p.columns_a_sheet;
  p.sheets_down = (p.picks + p.rows_a_sheet - 1) / p.rows_a_sheet;
  return p;
}

struct Part {
  int end0, end1, pick0, pick1;
};

/// A grid at (x, y): `columns` x `rows` cells with a light net, a heavier line every n and a frame.
struct Net {
  double x, y, cell;
  int columns, rows, first_column, first_row;
  bool from_right = false, from_below = false;  // where the first ones are
};

void draw_net(const Pen& pen, const Net& n, int heavy, bool over_colors = false) {
  const double width = n.columns * n.cell, height = n.rows * n.cell;
  const double thin = std::min(0.06, n.cell * 0.05);
  const auto rule = [&](double x0, double y0, double x1, double y1, int thread) {
    const bool strong = heavy > 0 && thread % heavy == 0;
    // Over colours a dark veil, which dark threads swallow.
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
  Plan plan;
  double x0 = kMargin, y0 = kMargin + kTitleMm;

  const Draft& draft() const { return design.draft; }
  double cell() const { return plan.cell; }
  /// Left of the column of an end within the sheet's part.
  double end_x(const Part& part, int end) const {
    const int column = options.end1_right ? part.end1 - 1 - end : end - part.end0;
    return x0 + column * cell();
  }
  double side_x(const Part& part) const { return x0 + (part.end1 - part.end0 + kGap + kBar + kGap) * cell(); }
  double bar_x(const Part& part) const { return x0 + (part.end1 - part.end0 + kGap) * cell(); }
  /// Treadle 1 stands next to the drawdown.
  double treadle_x(const Part& part, int treadle) const { return side_x(part) + treadle * cell(); }
  /// Shaft 1 and the bar stand next to the drawdown.
  double shafts_y(const Part& part) const {
    const int below = part.pick1 - part.pick0 + kGap + kBar + kGap;
    return y0 + (options.threading_below ? below : 0) * cell();
  }
  double shaft_y(const Part& part, int shaft) const {
    return shafts_y(part) + (options.threading_below ? shaft : plan.shafts - 1 - shaft) * cell();
  }
  double warp_bar_y(const Part& part) const {
    const int row = options.threading_below ? part.pick1 - part.pick0 + kGap : plan.shafts + kGap;
    return y0 + row * cell();
  }
  double picks_y() const { return y0 + (options.threading_below ? 0 : plan.head_rows()) * cell(); }
  double pick_y(const Part& part, int pick) const {
    return picks_y() + (options.pick1_bottom ? part.pick1 - 1 - pick : pick - part.pick0) * cell();
  }
  const Rgb& color_of(System system, int thread) const {
    return draft().palette[static_cast<size_t>(draft().threads(system).color[static_cast<size_t>(thread)])];
  }
};

void mark(const Pen& pen, const Drawing& g, double x, double y) { pen.fill(x, y, g.cell(), g.cell(), kInk); }

void draw_threading(const Pen& pen, const Drawing& g, const Part& part) {
  for (int e = part.end0; e < part.end1; ++e)
    for (int s = 0; s < g.plan.shafts; ++s)
      if (g.draft().threading.get(e, s)) mark(pen, g, g.end_x(part, e), g.shaft_y(part, s));
  const double left = g.end_x(part, g.options.end1_right ? part.end1 - 1 : part.end0);
  draw_net(pen,
           {left, g.shafts_y(part), g.cell(), part.end1 - part.end0, g.plan.shafts, part.end0, 0, g.options.end1_right,
            !g.options.threading_below},
           g.options.heavy_lines);
  for (int e = part.end0; e < part.end1; ++e)
    pen.fill(g.end_x(part, e), g.warp_bar_y(part), g.cell(), g.cell(), g.color_of(System::kWarp, e));
  pen.frame(left, g.warp_bar_y(part), (part.end1 - part.end0) * g.cell(), g.cell(), 0.12, kMuted);
}

void draw_sides(const Pen& pen, const Drawing& g, const Part& part) {
  const Draft& d = g.draft();
  const bool plan = d.drive == ShedControl::kLiftplan;
  const BitMatrix& rows = plan ? d.liftplan : d.treadling;
  for (int p = part.pick0; p < part.pick1; ++p) {
    for (int t = 0; t < g.plan.sides; ++t)
      if (rows.get(p, t)) mark(pen, g, g.treadle_x(part, t), g.pick_y(part, p));
    pen.fill(g.bar_x(part), g.pick_y(part, p), g.cell(), g.cell(), g.color_of(System::kWeft, p));
  }
  const int picks = part.pick1 - part.pick0;
  draw_net(pen,
           {g.side_x(part), g.picks_y(), g.cell(), g.plan.sides, picks, 0, part.pick0, false, g.options.pick1_bottom},
           g.options.heavy_lines);
  pen.frame(g.bar_x(part), g.picks_y(), g.cell(), picks * g.cell(), 0.12, kMuted);
  if (plan) return;
  for (int t = 0; t < d.treadles; ++t)
    for (int s = 0; s < d.shafts; ++s)
      if (d.tieup.get(t, s)) mark(pen, g, g.treadle_x(part, t), g.shaft_y(part, s));
  draw_net(pen,
           {g.side_x(part), g.shafts_y(part), g.cell(), d.treadles, d.shafts, 0, 0, false, !g.options.threading_below},
           g.options.heavy_lines);
}

/// In the threads' colours, runs of one colour at a time.
void draw_drawdown(const Pen& pen, const Drawing& g, const Part& part) {
  const auto color = [&](int pick, int end) -> const Rgb& {
    return g.cells.get(pick, end) ? g.color_of(System::kWarp, end) : g.color_of(System::kWeft, pick);
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
  draw_net(pen,
           {left, g.picks_y(), g.cell(), part.end1 - part.end0, part.pick1 - part.pick0, part.end0, part.pick0,
            g.options.end1_right, g.options.pick1_bottom},
           g.options.heavy_lines, true);
}

void draw_numbers(const Pen& pen, const Drawing& g, const Part& part) {
  const double size = std::clamp(g.cell() * 0.9, 1.5, 2.4);
  const int step = g.cell() * 5 >= pen.width_of(size, "8888") + 1 ? 5 : 10;
  for (int e = part.end0; e < part.end1; ++e)
    if ((e + 1) % step == 0 || e == 0) {
      const std::string n = std::to_string(e + 1);
      pen.text(g.end_x(part, e) + (g.cell() - pen.width_of(size, n)) / 2, g.y0 - 0.8, size, n, kMuted);
    }
  const double side = g.side_x(part) + g.plan.sides * g.cell() + 1;
  for (int p = part.pick0; p < part.pick1; ++p)
    if ((p + 1) % 5 == 0 || p == 0) {
      const double y = g.pick_y(part, p) + (g.cell() + size * 0.7) / 2;
      pen.text(side, y, size, std::to_string(p + 1), kMuted);
    }
}

void draw_title(const Pen& pen, const Drawing& g, const Part& part, int sheet) {
  const Draft& d = g.draft();
  const std::string title = !g.design.title.empty()   ? g.design.title
                            : !g.options.name.empty() ? g.options.name
                                                      : "Draft";
  pen.text(kMargin, kMargin + 4.5, 5, title, kInk, true);
  std::string facts = std::to_string(d.ends()) + " ends, " + std::to_string(d.picks()) + " picks, " +
                      std::to_string(d.shafts) + " shafts";
  if (d.drive == ShedControl::kTreadling) facts += ", " + std::to_string(d.treadles) + " treadles";
  facts += d.rising ? ", rising shed" : ", sinking shed";
  if (!g.design.author.empty()) facts = g.design.author + "    " + facts;
  pen.text(kMargin, kMargin + 9.5, 2.8, facts, kMuted);
  if (g.plan.sheets_across * g.plan.sheets_down == 1) return;
  const double right = g.options.paper.width_mm - kMargin;
  pen.text_right(right, kMargin + 4.5, 2.8,
                 "ends " + std::to_string(part.end0 + 1) + " to " + std::to_string(part.end1) + ", picks " +
                     std::to_string(part.pick0 + 1) + " to " + std::to_string(part.pick1),
                 kInk);
  pen.text_right(
      right, kMargin + 9.5, 2.8,
      "sheet " + std::to_string(sheet + 1) + " of " + std::to_string(g.plan.sheets_across * g.plan.sheets_down),
      kMuted);
}

}  // namespace

std::vector<Sheet> draft_sheets(const Design& design, const PrintOptions& options, std::string& why) {
  const Plan plan = plan_of(design.draft, options);
  const int64_t sheets = int64_t{plan.sheets_across} * plan.sheets_down;
  if (sheets > kMaxSheets) {
    why = "this takes " + std::to_string(sheets) + " sheets; give a smaller scale";
    return {};
  }
  std::vector<Sheet> out;
  const auto cells = std::make_shared<const BitMatrix>(drawdown(design.draft));
  for (int down = 0; down < plan.sheets_down; ++down)
    for (int across = 0; across < plan.sheets_across; ++across) {
      const Part part{across * plan.columns_a_sheet, std::min((across + 1) * plan.columns_a_sheet, plan.ends),
                      down * plan.rows_a_sheet, std::min((down + 1) * plan.rows_a_sheet, plan.picks)};
      const int number = static_cast<int>(out.size());
      out.push_back([&design, cells, options, plan, part, number](const Pen& pen) {
        const Drawing g{design, *cells, options, plan};
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
