#pragma once
// Printing: paper, scale and contents, beside a preview of the sheet.

#include <functional>
#include <memory>
#include <string>

#include "base/tasks.h"
#include "print/print.h"
#include "ui/pixel_texture.h"
#include "views/common/panel.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using design::Design;
using ui::PixelTexture;

/// Renders one sheet of a design on its own thread. The last picture is kept until the next is done.
class SheetPreview {
 public:
  /// `wake`: called on that thread when a picture is done.
  SheetPreview(std::shared_ptr<const Design> design, std::function<void()> wake);
  void ask(const print::PrintOptions& options, int sheet, double pixels_per_mm);
  /// True if there is a new picture to show. Call it on the window's thread.
  bool poll() { return runner_.take(); }
  bool busy() const { return busy_; }
  /// Facts about the last picture. Its pixels are in texture().
  const print::SheetPicture& last() const { return last_; }
  /// Why there is none; empty: there is one, or it is still drawn.
  const std::string& problem() const { return problem_; }
  const PixelTexture& texture() const { return texture_; }

 private:
  struct Request {
    print::PrintOptions options;
    int sheet = -1;
    double pixels_per_mm = 0;
    bool operator==(const Request&) const = default;
  };
  void show(base::Result<print::SheetPicture> made);

  std::shared_ptr<const Design> design_;
  Request request_;
  print::SheetPicture last_;
  std::string problem_;
  PixelTexture texture_;
  bool busy_ = false;
  base::TaskRunner runner_;
};

struct PrintPrompt {
  print::PrintOptions options;
  print::PrintFormat format = print::PrintFormat::kPdf;
  int paper = 0;  // of kPapers
  bool wide = false;
  bool own_scale = false;
  float cell_mm = 3;
  int sheet = 0;
  bool has_printer = false;  // the system takes print jobs
  std::shared_ptr<SheetPreview> preview{};
  enum class Button { kPrint, kSave, kCancel };
  /// Meaning of the pressed button; without a printer there is none for it.
  Button button(int pressed) const;
};
/// The options, from the choices of the dialog.
print::PrintOptions chosen_options(const PrintPrompt& p);
/// ".pdf", ".svg" or ".png".
const char* ending_of(print::PrintFormat format);

DialogResult draw_prompt(PanelContext& c, PrintPrompt& p);

}  // namespace weftlight::views
