// Lists for the loom: the planned cloth, threading, treadling; and a swatch at actual size.

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "analysis/warping.h"
#include "base/text.h"
#include "print/lines.h"
#include "print/sheets.h"

namespace weftlight::print {

using analysis::cloth_measures, analysis::period_of;
using base::tr;
using design::Design;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::Threads, draft::drawdown;

namespace {

constexpr double kLine = 4.4, kBetween = 8;         // line spacing, room between columns, mm
constexpr double kChip = 3.2, kChipText = 2.3;      // side of a chip, font size of its number, mm
constexpr double kAfterChip = 0.8, kAfterWord = 2;  // gaps, mm
constexpr size_t kMaxLines = 4000;                  // of one list; a longer one is cut, with a remark

std::string marks_of(const BitMatrix& m, int row) {
  std::string text;
  for (int c = 0; c < m.cols(); ++c)
    if (m.get(row, c)) text.append(text.empty() ? "" : "+").append(std::to_string(c + 1));
  return text.empty() ? "\xE2\x80\x93" : text;
}

using Lines = std::vector<ListLine>;

std::string span_text(int first, int last) { return std::to_string(first + 1) + "\xE2\x80\x93" + std::to_string(last); }

ListLine line_of_more() { return {"", {{tr("and so on"), -1}}}; }

/// The shafts or treadles of the threads first to last - 1, `group` threads per line.
Lines lines_of_rows(const BitMatrix& rows, int first, int last, int group) {
  Lines out;
  for (int from = first; from < last; from += group) {
    if (out.size() == kMaxLines) return out.push_back(line_of_more()), out;
    const int to = std::min(from + group, last);
    ListLine line{span_text(from, to), {}};
    for (int i = from; i < to; ++i) line.words.push_back({marks_of(rows, i), -1});
    out.push_back(std::move(line));
  }
  return out;
}

/// Runs of one colour of the threads first to last - 1, with their numbers of threads.
Lines lines_of_colors(const std::vector<int>& color, int first, int last, double room_mm) {
  constexpr size_t kRunsInLine = 8;
  Lines out;
  ListLine line;
  double taken = 0;
  int from = first;  // of the line
  const auto end_line = [&](int to) {
    line.head = span_text(from, to);
    out.push_back(std::exchange(line, {}));
    taken = 0, from = to;
  };
  for (int i = first; i < last;) {
    if (out.size() == kMaxLines) return out.push_back(line_of_more()), out;
    const int shown = color[static_cast<size_t>(i)];
    int to = i;
    while (to < last && color[static_cast<size_t>(to)] == shown) ++to;
    Word word{std::to_string(to - i), shown};
    const double room = room_for(word);
    if (line.words.size() == kRunsInLine || (taken > 0 && taken + room > room_mm)) end_line(i);
    line.words.push_back(std::move(word));
    taken += room;
    i = to;
  }
  if (!line.words.empty()) end_line(last);
  return out;
}

/// The lines of n threads that `lines_of(first, last)` makes; what repeats is listed once where that is shorter.
template <class LinesOf>
void add_folded(Lines& out, int n, int period, LinesOf lines_of) {
  Lines lines = lines_of(0, n);
  if (n >= 2 * period && period > 0) {
    const int times = n / period;
    Lines once = lines_of(0, period);
    once.push_back(line_of_times(times));
    if (n > times * period) {
      once.push_back({"", {{tr("then"), -1}}});
      std::ranges::move(lines_of(times * period, n), std::back_inserter(once));
    }
    if (once.size() < lines.size()) lines = std::move(once);
  }
  std::ranges::move(lines, std::back_inserter(out));
}

void list_rows(Lines& out, const char* title, const BitMatrix& rows, int group) {
  out.push_back({title, {}});
  const int period =
      period_of(rows.rows(), [&rows](int a, int b) { return std::ranges::equal(rows.row(a), rows.row(b)); });
  add_folded(out, rows.rows(), period, [&](int first, int last) { return lines_of_rows(rows, first, last, group); });
}

void list_colors(Lines& out, const char* title, const Threads& threads, double room_mm) {
  out.push_back({title, {}});
  const std::vector<int>& color = threads.color;
  const int period = period_of(threads.size(), [&color](int a, int b) {
    return color[static_cast<size_t>(a)] == color[static_cast<size_t>(b)];
  });
  add_folded(out, threads.size(), period,
             [&](int first, int last) { return lines_of_colors(color, first, last, room_mm); });
}

/// A treadle has its own number: tie-ups are not folded.
void list_tieup(Lines& out, const BitMatrix& tieup) {
  out.push_back({tr("Tie-up, shafts of each treadle"), {}});
  std::ranges::move(lines_of_rows(tieup, 0, tieup.rows(), 2), std::back_inserter(out));
}

/// The order of the warp in the plan has the very ends of the list.
bool order_is_of(const PlannedCloth& cloth, const Threads& listed) {
  const std::vector<int>& color = cloth.design.draft.warp.color;
  if (color.empty() || cloth.measures.ends != listed.size()) return false;
  for (size_t i = 0; i < listed.color.size(); ++i)
    if (listed.color[i] != color[i % color.size()]) return false;
  return true;
}

/// The cloth takes every thread of the draft, so that its yarns are of every colour.
bool is_whole_draft(const PlannedCloth& cloth) {
  const Draft& draft = cloth.design.draft;
  return cloth.measures.ends >= draft.ends() && cloth.measures.picks >= draft.picks();
}

/// Of the list that a heading begins, the lines that are kept together with it.
int kept_lines(const Lines& lines, size_t heading) {
  int count = 0;
  for (size_t i = heading + 1; count < 2 && i < lines.size() && !lines[i].heading(); ++i) ++count;
  return count;
}

double column_width(const Paper& paper) { return (paper.width_mm - 2 * kMargin - kBetween) / 2; }

double chip_width(double width_of_number) { return std::max(kChip, width_of_number + 1.2); }

/// Returns the width. The number is as dark or as light as the colour is not.
double draw_chip(const Pen& pen, double x, double y, int color, const Rgb& rgb) {
  const std::string number = number_of_color(color);
  const double wide = pen.width_of(kChipText, number), width = chip_width(wide), top = y - kChip * 0.85;
  const bool light = 0.299f * rgb.r + 0.587f * rgb.g + 0.114f * rgb.b > 0.5f;
  pen.fill(x, top, width, kChip, rgb);
  pen.frame(x, top, width, kChip, 0.08, kMuted);
  pen.text(x + (width - wide) / 2, top + kChip / 2 + kChipText * 0.36, kChipText, number, light ? kInk : Rgb{1, 1, 1});
  return width;
}

double least_width(const Word& word) { return word.color >= 0 ? 3.5 : 6.0; }

/// A line with a long name is smaller: nothing is written over the next column.
double size_of_words(const Pen& pen, const ListLine& line, double room_mm) {
  if (line.pitch_mm > 0) return kTableSize;
  double text = 0, gaps = -kAfterWord;  // of the last word there is none
  for (const Word& word : line.words) {
    text += std::max(pen.width_of(kTextSize, word.text), least_width(word) - kAfterWord);
    gaps += kAfterWord;
    if (word.color >= 0) gaps += chip_width(pen.width_of(kChipText, number_of_color(word.color))) + kAfterChip;
  }
  return kTextSize * std::clamp((room_mm - gaps) / text, 0.3, 1.0);
}

void draw_line(const Pen& pen, const Design& design, const ListLine& line, double x, double y, double width) {
  if (line.heading()) {
    pen.text(x, y - 1.3, kTextSize * 1.1, line.head, kInk, true);
    pen.line(x, y - 0.2, x + width, y - 0.2, 0.12, kMuted);
    return;
  }
  pen.text(x, y, kTextSize * 0.85, line.head, kMuted);
  const double size = size_of_words(pen, line, width - kHeadWidth);
  double at = x + kHeadWidth;
  for (const Word& word : line.words) {
    const double from = at;
    if (word.color >= 0)
      at += draw_chip(pen, at, y, word.color, design.draft.palette[static_cast<size_t>(word.color)]) + kAfterChip;
    at += std::max(pen.text(at, y, size, word.text) + kAfterWord, least_width(word));
    if (line.pitch_mm > 0) at = from + line.pitch_mm;
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

double room_for(const Word& word) {
  constexpr double kDigit = 0.64;  // width of a digit, of the font size
  const auto width = [](double size, const std::string& text) {
    return kDigit * size * static_cast<double>(text.size());
  };
  const double text = width(kTextSize, word.text) + kAfterWord;
  const double wide = std::max(text, least_width(word));
  if (word.color < 0) return wide;
  return chip_width(width(kChipText, number_of_color(word.color))) + kAfterChip + wide;
}

Lines list_lines(const Design& design, const Draft& d, const PrintOptions& options) {
  const PrintParts& parts = options.parts;
  Lines out;
  constexpr int kGroup = 10;
  const PlannedCloth cloth{design, cloth_measures(design), options.units, column_width(options.paper) - kHeadWidth};
  if (parts.plan) list_plan(out, cloth);
  if ((parts.plan || parts.yarn || parts.lists) && !(parts.yarn && is_whole_draft(cloth))) list_palette(out, cloth);
  if (parts.plan) list_warp_order(out, cloth);
  if (parts.heddles) list_heddles(out, cloth);
  if (parts.yarn) list_yarn(out, cloth);
  if (parts.plan) list_sleyings(out, cloth);
  if (!parts.lists) return out;
  list_rows(out, tr("Threading, shaft of each end"), d.threading, kGroup);
  if (!parts.plan || !order_is_of(cloth, d.warp)) list_colors(out, tr("Warp colours"), d.warp, cloth.room_mm);
  if (d.shed_control == ShedControl::kTreadling) {
    list_tieup(out, d.tieup);
    list_rows(out, tr("Treadling, treadle of each pick"), d.treadling, kGroup);
  } else {
    list_rows(out, tr("Liftplan, shafts of each pick"), d.liftplan, 2);
  }
  list_colors(out, tr("Weft colours"), d.weft, cloth.room_mm);
  return out;
}

Lines lines_of_column(const Lines& lines, size_t& next, double height_mm) {
  Lines column;
  double y = 0;
  // A table that goes on from the column before has its head again.
  if (next < lines.size() && lines[next].pitch_mm > 0 && !lines[next].table_head) {
    size_t head = next;
    while (head > 0 && !lines[head].table_head) --head;
    column.push_back(lines[head]);
    y += kLine;
  }
  while (next < lines.size()) {
    const bool heading = lines[next].heading();
    const double own = heading && !column.empty() ? 2 * kLine : kLine;
    if (y + own + (heading ? kept_lines(lines, next) * kLine : 0) > height_mm) break;
    y += own;
    column.push_back(lines[next++]);
  }
  return column;
}

std::vector<Sheet> list_sheets(const Design& design, const Design& listed, const PrintOptions& options) {
  const double width = column_width(options.paper);
  const double bottom = options.paper.height_mm - kMargin;
  const std::vector<ListLine> lines = list_lines(design, listed.draft, options);
  const bool swatch = options.parts.swatch;
  std::vector<std::vector<Column>> sheets;
  size_t next = 0;
  while (next < lines.size() || (swatch && sheets.empty())) {
    const double top = kMargin + (swatch && sheets.empty() ? kSwatchHeight + 16 : 4);
    std::vector<Column> columns;
    for (int i = 0; i < 2 && next < lines.size(); ++i)
      columns.push_back({kMargin + i * (width + kBetween), top, width, lines_of_column(lines, next, bottom - top)});
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
