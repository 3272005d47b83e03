// Lists for the loom: the planned cloth, threading, treadling; and a swatch at actual size.

#include <algorithm>
#include <memory>
#include <utility>

#include "base/text.h"
#include "print/lines.h"
#include "print/sheets.h"

namespace weftlight::print {

using analysis::cloth_measures;
using base::tr;
using design::Design;
using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::Threads, draft::drawdown;

namespace {

constexpr double kLine = 4.4, kSize = 3;  // line spacing and font size, mm
constexpr int kMaxLines = 4000;           // of one list; a longer one is cut, with a remark

std::string marks_of(const BitMatrix& m, int row) {
  std::string text;
  for (int c = 0; c < m.cols(); ++c)
    if (m.get(row, c)) text.append(text.empty() ? "" : "+").append(std::to_string(c + 1));
  return text.empty() ? "\xE2\x80\x93" : text;
}

/// The shafts or treadles of each thread, `group` threads per line.
void list_rows(std::vector<ListLine>& out, const char* title, const BitMatrix& rows, int group) {
  out.push_back({title, {}});
  for (int first = 0; first < rows.rows(); first += group) {
    if (out.size() > static_cast<size_t>(kMaxLines)) return out.push_back({"", {{tr("and so on"), -1}}});
    const int last = std::min(first + group, rows.rows());
    ListLine line{std::to_string(first + 1) + "\xE2\x80\x93" + std::to_string(last), {}};
    for (int i = first; i < last; ++i) line.words.push_back({marks_of(rows, i), -1});
    out.push_back(std::move(line));
  }
}

/// Runs of one colour, with their numbers of threads.
void list_colors(std::vector<ListLine>& out, const char* title, const Threads& threads) {
  out.push_back({title, {}});
  ListLine line;
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
    if (out.size() > static_cast<size_t>(kMaxLines)) return out.push_back({"", {{tr("and so on"), -1}}});
  }
}

std::vector<ListLine> lines_of(const Design& design, const Draft& d, const PrintOptions& options) {
  const PrintParts& parts = options.parts;
  std::vector<ListLine> out;
  constexpr int kGroup = 10;
  const PlannedCloth cloth{design, cloth_measures(design), options.units};
  if (parts.plan) list_plan(out, cloth);
  if (parts.plan) list_warp_order(out, cloth);
  if (parts.heddles) list_heddles(out, cloth);
  if (parts.yarn) list_yarn(out, cloth);
  if (parts.plan) list_sleyings(out, cloth);
  if (!parts.lists) return out;
  list_rows(out, tr("Threading, shaft of each end"), d.threading, kGroup);
  list_colors(out, tr("Warp colours"), d.warp);
  if (d.shed_control == ShedControl::kTreadling) {
    list_rows(out, tr("Tie-up, shafts of each treadle"), d.tieup, 2);
    list_rows(out, tr("Treadling, treadle of each pick"), d.treadling, kGroup);
  } else {
    list_rows(out, tr("Liftplan, shafts of each pick"), d.liftplan, 2);
  }
  list_colors(out, tr("Weft colours"), d.weft);
  return out;
}

void draw_line(const Pen& pen, const Design& design, const ListLine& line, double x, double y, double width) {
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
    const double wide = std::max(pen.text(at, y, kSize, word.text) + 2, word.color >= 0 ? 3.5 : 6.0);
    at += line.pitch_mm > 0 ? line.pitch_mm : wide;
  }
}

/// One of the two columns of a sheet; on the first sheet the swatch is above them.
struct Column {
  double x, y, width;
  std::vector<ListLine> lines;
};

constexpr double kSwatchHeight = 60;

void draw_swatch(const Pen& pen, const Design& design, const BitMatrix& cells, const PrintOptions& o) {
  constexpr double kPixelsPerMm = 11.8;  // 300 dpi
  const double width = o.paper.width_mm - 2 * kMargin;
  const int w = static_cast<int>(width * kPixelsPerMm), h = static_cast<int>(kSwatchHeight * kPixelsPerMm);
  std::vector<uint32_t> pixels = swatch_pixels(design, cells, o, w, h, kPixelsPerMm);
  cairo_surface_t* image = cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                               CAIRO_FORMAT_RGB24, w, h, w * 4);
  cairo_t* c = pen.context();
  cairo_save(c);
  cairo_translate(c, kMargin, kMargin + 6);
  cairo_scale(c, 1 / kPixelsPerMm, 1 / kPixelsPerMm);
  cairo_set_source_surface(c, image, 0, 0);
  cairo_paint(c);
  cairo_restore(c);
  // The pixels are freed at the end of this function: flush, so that a PDF or SVG copies them now.
  cairo_surface_flush(cairo_get_target(c));
  cairo_surface_finish(image);
  cairo_surface_destroy(image);
  pen.text(kMargin, kMargin + 4, 3.4, tr("Swatch, actual size"), kInk, true);
}

}  // namespace

std::vector<Sheet> list_sheets(const Design& design, const Design& listed, const PrintOptions& options) {
  const double width = (options.paper.width_mm - 2 * kMargin - 8) / 2;
  const double bottom = options.paper.height_mm - kMargin;
  const std::vector<ListLine> lines = lines_of(design, listed.draft, options);
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
        // A heading is kept together with at least two of its lines.
        const double height = lines[next].heading() ? (column.lines.empty() ? kLine : 2 * kLine) + 2 * kLine : kLine;
        if (y + height > bottom) break;
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
        bool started = false;
        for (const ListLine& line : column.lines) {
          y += line.heading() && started ? 2 * kLine : kLine;
          started = true;
          draw_line(pen, design, line, column.x, y, column.width);
        }
      }
    });
  return out;
}

}  // namespace weftlight::print
