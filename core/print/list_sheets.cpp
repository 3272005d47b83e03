// Lists for the loom: what to thread, what to tread, how many heddles, how much yarn; and a swatch true to size.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "analysis/threads.h"
#include "print/page.h"

namespace weftlight::print {
namespace {

constexpr double kLine = 4.4, kSize = 3;  // mm
constexpr int kMaxLines = 4000;           // of one list; a longer one is cut, and says so

/// One line of a list: where it stands, then words, each with a chip of colour or none.
struct Word {
  std::string text;
  int color = -1;  // of the palette
};
struct Line {
  std::string head;  // bold at the left; alone: a heading
  std::vector<Word> words;
  bool heading() const { return words.empty() && !head.empty(); }
};

std::string marks_of(const BitMatrix& m, int row) {
  std::string text;
  for (int c = 0; c < m.cols(); ++c)
    if (m.get(row, c)) text.append(text.empty() ? "" : "+").append(std::to_string(c + 1));
  return text.empty() ? "\xE2\x80\x93" : text;
}

/// Threads in rows of `group`, each the shafts (treadles, lifts) of a thread.
void list_rows(std::vector<Line>& out, const char* title, const BitMatrix& rows, int group) {
  out.push_back({title, {}});
  for (int first = 0; first < rows.rows(); first += group) {
    if (out.size() > static_cast<size_t>(kMaxLines)) return out.push_back({"", {{"and so on", -1}}});
    const int last = std::min(first + group, rows.rows());
    Line line{std::to_string(first + 1) + "\xE2\x80\x93" + std::to_string(last), {}};
    for (int i = first; i < last; ++i) line.words.push_back({marks_of(rows, i), -1});
    out.push_back(std::move(line));
  }
}

/// Runs of one colour: how many threads of it.
void list_colors(std::vector<Line>& out, const char* title, const Threads& threads) {
  out.push_back({title, {}});
  Line line;
  int first = 0;
  for (int i = 0; i < threads.size();) {
    int last = i;
    while (last + 1 < threads.size() &&
           threads.color[static_cast<size_t>(last) + 1] == threads.color[static_cast<size_t>(i)])
      ++last;
    if (line.words.empty()) first = i;
    line.words.push_back({std::to_string(last - i + 1), threads.color[static_cast<size_t>(i)]});
    i = last + 1;
    if (line.words.size() < 8 && i < threads.size()) continue;
    line.head = std::to_string(first + 1) + "\xE2\x80\x93" + std::to_string(i);
    out.push_back(std::exchange(line, {}));
    if (out.size() > static_cast<size_t>(kMaxLines)) return out.push_back({"", {{"and so on", -1}}});
  }
}

std::string number(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

void list_heddles(std::vector<Line>& out, const LoomUse& use) {
  out.push_back({"Heddles", {}});
  for (size_t s = 0; s < use.heddles.size(); ++s)
    out.push_back({"Shaft " + std::to_string(s + 1), {{std::to_string(use.heddles[s]), -1}}});
  int sum = 0;
  for (const int heddles : use.heddles) sum += heddles;
  out.push_back({"Together", {{std::to_string(sum), -1}}});
  if (use.unthreaded_ends > 0) out.push_back({"On no shaft", {{std::to_string(use.unthreaded_ends), -1}}});
}

void list_yarn(std::vector<Line>& out, const Design& design, const ClothPlan& plan) {
  const YarnReport r = yarn_report(design, plan);
  out.push_back({"Yarn", {}});
  for (const YarnNeed& need : r.needs)
    out.push_back({need.system == System::kWarp ? "Warp" : "Weft",
                   {{number("%.1f m", need.length_m), need.color},
                    {number("%.1f g", need.weight_g), -1},
                    {design.yarns[static_cast<size_t>(need.yarn)].name, -1}}});
  if (r.cost >= 0) out.push_back({"Cost", {{number("%.2f", r.cost), -1}}});
  out.push_back({"On the loom",
                 {{std::to_string(r.ends) + " ends", -1},
                  {number("%.1f cm wide", r.loom_width_mm / 10), -1},
                  {number("warp %.2f m long", r.warp_length_mm / 1000), -1}}});
  out.push_back({"Sett", {{number("%.1f ends/cm", r.ends_per_cm), -1}, {number("%.1f picks/cm", r.picks_per_cm), -1}}});
}

std::vector<Line> lines_of(const Design& design, const PrintOptions& options) {
  const PrintParts& parts = options.parts;
  const Draft& d = design.draft;
  std::vector<Line> out;
  constexpr int kGroup = 10;
  if (parts.heddles) list_heddles(out, loom_use(d));
  if (parts.yarn) list_yarn(out, design, options.plan);
  if (!parts.lists) return out;
  list_rows(out, "Threading, shaft of each end", d.threading, kGroup);
  list_colors(out, "Warp colours", d.warp);
  if (d.drive == ShedControl::kTreadling) {
    list_rows(out, "Tie-up, shafts of each treadle", d.tieup, 2);
    list_rows(out, "Treadling, treadle of each pick", d.treadling, kGroup);
  } else {
    list_rows(out, "Liftplan, shafts of each pick", d.liftplan, 2);
  }
  list_colors(out, "Weft colours", d.weft);
  return out;
}

void draw_line(const Pen& pen, const Design& design, const Line& line, double x, double y, double width) {
  if (line.heading()) {
    pen.text(x, y - 1.3, kSize * 1.1, line.head, kInk, true);
    pen.line(x, y - 0.2, x + width, y - 0.2, 0.12, kMuted);
    return;
  }
  pen.text(x, y, kSize * 0.85, line.head, kMuted);
  double at = x + 20;
  for (const Word& word : line.words) {
    if (word.color >= 0) {
      pen.fill(at, y - kSize * 0.75, kSize * 0.8, kSize * 0.8, design.draft.palette[static_cast<size_t>(word.color)]);
      pen.frame(at, y - kSize * 0.75, kSize * 0.8, kSize * 0.8, 0.08, kMuted);
      at += kSize * 0.8 + 0.8;
    }
    at += std::max(pen.text(at, y, kSize, word.text) + 2, word.color >= 0 ? 3.5 : 6.0);
  }
}

/// In two columns; the swatch above them on the first sheet.
struct Column {
  double x, y, width;
  std::vector<Line> lines;
};

constexpr double kSwatchHeight = 60;

void draw_swatch(const Pen& pen, const Design& design, const BitMatrix& cells, const PrintOptions& o) {
  constexpr double kPixelsPerMm = 11.8;  // 300 dots an inch
  const double width = o.paper.width_mm - 2 * kMargin;
  const int w = static_cast<int>(width * kPixelsPerMm), h = static_cast<int>(kSwatchHeight * kPixelsPerMm);
  std::vector<uint32_t> pixels = swatch_pixels(design, cells, w, h, kPixelsPerMm);
  cairo_surface_t* image = cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                               CAIRO_FORMAT_RGB24, w, h, w * 4);
  cairo_t* c = pen.context();
  cairo_save(c);
  cairo_translate(c, kMargin, kMargin + 6);
  cairo_scale(c, 1 / kPixelsPerMm, 1 / kPixelsPerMm);
  cairo_set_source_surface(c, image, 0, 0);
  cairo_paint(c);
  cairo_restore(c);
  // The pixels leave with this function; a PDF or SVG keeps what it needs of them now.
  cairo_surface_flush(cairo_get_target(c));
  cairo_surface_finish(image);
  cairo_surface_destroy(image);
  pen.text(kMargin, kMargin + 4, 3.4, "Swatch, true to size", kInk, true);
}

}  // namespace

std::vector<Sheet> list_sheets(const Design& design, const PrintOptions& options) {
  const double width = (options.paper.width_mm - 2 * kMargin - 8) / 2;
  const double bottom = options.paper.height_mm - kMargin;
  const std::vector<Line> lines = lines_of(design, options);
  const bool swatch = options.parts.swatch;
  std::vector<std::vector<Column>> sheets;
  size_t next = 0;
  while (next < lines.size() || (swatch && sheets.empty())) {
    const double top = kMargin + (swatch && sheets.empty() ? kSwatchHeight + 16 : 4);
    std::vector<Column> columns;
    for (int i = 0; i < 2 && next < lines.size(); ++i) {
      Column column{kMargin + i * (width + 8), top, width, {}};
      double y = top;
      while (next < lines.size()) {
        // A heading stands with at least two of its lines.
        const double takes = lines[next].heading() ? (column.lines.empty() ? kLine : 2 * kLine) + 2 * kLine : kLine;
        if (y + takes > bottom) break;
        y += lines[next].heading() && !column.lines.empty() ? 2 * kLine : kLine;
        column.lines.push_back(lines[next++]);
      }
      columns.push_back(std::move(column));
    }
    sheets.push_back(std::move(columns));
  }
  std::vector<Sheet> out;
  const auto cells = std::make_shared<const BitMatrix>(drawdown(design.draft));
  for (size_t i = 0; i < sheets.size(); ++i)
    out.push_back([&design, cells, options, columns = sheets[i], first = swatch && i == 0](const Pen& pen) {
      if (first) draw_swatch(pen, design, *cells, options);
      for (const Column& column : columns) {
        double y = column.y;
        bool begun = false;
        for (const Line& line : column.lines) {
          y += line.heading() && begun ? 2 * kLine : kLine;
          begun = true;
          draw_line(pen, design, line, column.x, y, column.width);
        }
      }
    });
  return out;
}

}  // namespace weftlight::print
