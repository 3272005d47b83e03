#include "draft/block_text.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/text.h"

namespace weftlight::draft {

using base::tr;

namespace {

constexpr std::string_view kHead = "weftlight cells: ";
constexpr std::string_view kMarks = "#Xx*1", kEmpty = ".0-_ \t";
constexpr BitGrid kGrids[] = {BitGrid::kThreading, BitGrid::kTieup, BitGrid::kTreadling, BitGrid::kLiftplan,
                              BitGrid::kDrawdown};

/// Tabs stay: a spreadsheet ends a row of empty cells with them.
std::string_view without_trailing_space(std::string_view line) {
  const size_t last = line.find_last_not_of(" \r");
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

constexpr size_t kMaxLines = static_cast<size_t>(kMaxThreads) + 2;  // head line, rows, and one more to detect excess

/// Lines ended by \n, \r\n or \r, up to kMaxLines, without empty lines at the end.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < kMaxLines) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back(without_trailing_space(text.substr(0, end)));
    const bool pair = text.substr(end, 2) == "\r\n";
    text.remove_prefix(std::min(text.size(), end + (pair ? 2 : 1)));
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

/// Whether the cells of a row are separated by blanks or tabs ("1 0 0 1", as from a spreadsheet).
bool is_separated(std::string_view line) {
  if (line.size() < 3 || line.size() % 2 == 0) return false;
  for (size_t i = 1; i < line.size(); i += 2)
    if (line[i] != ' ' && line[i] != '\t') return false;
  return line.find_first_not_of(" \t") == 0;
}

/// One character for each cell between tabs, as a spreadsheet copies them; its empty cells have none. Nothing if a cell
/// has several.
std::optional<std::string> without_tabs(std::string_view line) {
  std::string cells;
  for (size_t at = 0; at <= line.size();) {
    const size_t end = std::min(line.find('\t', at), line.size());
    if (end - at > 1) return {};
    cells += end > at && line[at] != ' ' ? line[at] : '.';
    at = end + 1;
  }
  return cells;
}

bool is_row(std::string_view line) {
  return std::ranges::all_of(line,
                             [](char c) { return kMarks.find(c) != kMarks.npos || kEmpty.find(c) != kEmpty.npos; });
}

std::optional<BitGrid> grid_named(std::string_view head) {
  for (BitGrid grid : kGrids)
    if (const std::string_view name = bit_grid_name(grid); head.substr(0, name.size()) == name) return grid;
  return {};
}

base::Failure refused(const char* problem) { return base::failure(base::ErrorKind::kInput, problem); }

base::Result<CellBlock> read_rows(BitGrid from, const std::vector<std::string_view>& lines) {
  if (lines.empty()) return refused(tr("The clipboard holds no cells."));
  if (!std::ranges::all_of(lines, is_row)) return refused(tr("The clipboard holds text that is not cells."));
  const size_t stride = std::ranges::all_of(lines, is_separated) ? 2 : 1;
  size_t columns = 0;
  for (std::string_view line : lines) columns = std::max(columns, (line.size() + stride - 1) / stride);
  if (columns == 0) return refused(tr("The clipboard holds no cells."));
  const auto most = static_cast<size_t>(kMaxThreads);
  if (columns > most || lines.size() > most || columns * lines.size() > static_cast<size_t>(kMaxBlockCells))
    return refused(tr("The clipboard holds more cells than can be pasted."));
  CellBlock block{from, BitMatrix(static_cast<int>(lines.size()), static_cast<int>(columns))};
  for (size_t r = 0; r < lines.size(); ++r)
    for (size_t i = 0; i < lines[r].size(); i += stride)
      if (kMarks.find(lines[r][i]) != kMarks.npos)
        block.cells.set(static_cast<int>(r), static_cast<int>(i / stride), true);
  return block;
}

/// The same with cells between tabs.
base::Result<CellBlock> read_tabbed_rows(BitGrid from, const std::vector<std::string_view>& lines) {
  std::vector<std::string> rows;
  for (const std::string_view line : lines) {
    std::optional<std::string> row = without_tabs(line);
    if (!row) return refused(tr("The clipboard holds text that is not cells."));
    rows.push_back(std::move(*row));
  }
  return read_rows(from, {rows.begin(), rows.end()});
}

bool has_tabs(std::string_view line) { return line.find('\t') != line.npos; }

}  // namespace

const char* bit_grid_name(BitGrid grid) {
  constexpr const char* kNames[] = {"threading", "tieup", "treadling", "liftplan", "drawdown"};
  return kNames[static_cast<int>(grid)];
}

std::string block_text(const CellBlock& block) {
  const BitMatrix& m = block.cells;
  const int64_t cells = int64_t{m.rows()} * m.cols();
  if (cells == 0 || cells > kMaxBlockCells) return {};
  std::string text = std::string(kHead) + bit_grid_name(block.from) + ", " + std::to_string(m.cols()) + " x " +
                     std::to_string(m.rows()) + "\n";
  text.reserve(text.size() + static_cast<size_t>(cells + m.rows()));
  for (int r = 0; r < m.rows(); ++r) {
    for (int c = 0; c < m.cols(); ++c) text += m.get(r, c) ? '#' : '.';
    text += '\n';
  }
  return text;
}

base::Result<CellBlock> read_block_text(std::string_view text) {
  // Twice the cells leave room for separators and line ends.
  if (text.size() > static_cast<size_t>(2 * kMaxBlockCells + kMaxThreads))
    return refused(tr("The clipboard holds more cells than can be pasted."));
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  std::vector<std::string_view> lines = lines_of(text);
  if (lines.empty() || lines[0].substr(0, kHead.size()) != kHead) {
    const bool tabbed = std::ranges::any_of(lines, has_tabs);
    return tabbed ? read_tabbed_rows(BitGrid::kDrawdown, lines) : read_rows(BitGrid::kDrawdown, lines);
  }
  const std::optional<BitGrid> from = grid_named(lines[0].substr(kHead.size()));
  if (!from) return refused(tr("The clipboard holds cells of an unknown grid."));
  lines.erase(lines.begin());
  return read_rows(*from, lines);
}

}  // namespace weftlight::draft
