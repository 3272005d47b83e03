// `drawdown`: text with one line per pick (pick 1 first) and one character per end (end 1 first), 1 where the warp is
// on top; or the coloured drawdown as a picture, by default as in the editor: end 1 at the right, pick 1 at the top.

#include <cstdio>

#include "base/file_names.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "commands/commands.h"
#include "commands/drawdown_picture.h"
#include "commands/open_design.h"

namespace weftlight::commands {

using base::arg, base::fill, base::tr, base::write_file_atomically;
using draft::BitMatrix, draft::Face, draft::complement, draft::drawdown;

namespace {

std::string as_text(const BitMatrix& cells) {
  std::string text;
  text.reserve(static_cast<size_t>(cells.rows()) * static_cast<size_t>(cells.cols() + 1));
  for (int pick = 0; pick < cells.rows(); ++pick) {
    for (int end = 0; end < cells.cols(); ++end) text += cells.get(pick, end) ? '1' : '0';
    text += '\n';
  }
  return text;
}

/// The form of the output, by its extension; text if there is none.
enum class Form { kText, kImage, kDrawing, kNone };
Form form_of(const std::string& out) {
  const std::string extension = base::extension_of(out);
  const auto is = [&extension](auto... names) { return ((extension == names) || ...); };
  if (is("", ".txt", ".text", ".asc", ".dat", ".out", ".log")) return Form::kText;
  if (is(".png", ".jpg", ".jpeg", ".tif", ".tiff")) return Form::kImage;
  return is(".svg", ".pdf") ? Form::kDrawing : Form::kNone;
}

}  // namespace

int drawdown_command(const DrawdownOptions& options) {
  const Form form = form_of(options.out);
  if (options.points && form != Form::kImage) {
    return refuse(tr("--points: write a picture, -o OUT.png or .tif"));
  }
  if (form == Form::kNone) {
    return refuse(
        fill(tr("{file}: a drawdown is written as .txt, .png, .jpg, .tif, .svg or .pdf"), arg("file", options.out)));
  }
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  BitMatrix cells = drawdown(opened.design.draft);
  if (options.face == Face::kBack) cells = complement(cells);
  if (options.out.empty()) {
    const std::string text = as_text(cells);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return kDone;  // the caller flushes the stream and reports a full device
  }
  const ColoredCells colors(cells, opened.design, options.origin);
  const std::string& out = options.out;
  return finish(form == Form::kText    ? write_file_atomically(out, as_text(cells))
                : options.points       ? write_drawdown_points(out, cells)
                : form == Form::kImage ? write_drawdown_image(out, colors)
                                       : write_drawdown_drawing(out, colors));
}

}  // namespace weftlight::commands
