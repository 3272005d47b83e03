#pragma once
// Printing: paper, scale and what is on it, beside the sheet as it will be.

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "base/worker.h"
#include "print/print.h"
#include "ui/pixel_texture.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// One sheet of a design as a picture, drawn on a thread of its own; the last one stands until the next is done.
class SheetPreview {
 public:
  /// `wake`: called from that thread when there is news.
  SheetPreview(std::shared_ptr<const Design> design, std::function<void()> wake);
  void ask(const print::PrintOptions& options, int sheet, double pixels_per_mm);
  /// True when another sheet is to be shown. In the window's thread.
  bool poll();
  bool busy() const { return worker_.busy(); }
  /// Of the last picture: its numbers and why there is none; its pixels are in texture().
  const print::SheetPicture& last() const { return last_; }
  const PixelTexture& texture() const { return texture_; }

 private:
  struct Asked {
    print::PrintOptions options;
    int sheet = -1;
    double pixels_per_mm = 0;
    bool operator==(const Asked&) const = default;
  };
  void fail(const std::string& why);

  std::shared_ptr<const Design> design_;
  std::function<void()> wake_;
  Asked asked_;
  print::SheetPicture last_;
  PixelTexture texture_;
  std::mutex mutex_;
  std::optional<print::SheetPicture> news_;                                          // guarded by the mutex
  base::Worker worker_{[this](const std::string& why, const auto&) { fail(why); }};  // gone before what it writes to
};

struct PrintPrompt {
  print::PrintOptions options;
  print::PrintFormat format = print::PrintFormat::kPdf;
  int paper = 0;  // of kPapers
  bool wide = false;
  bool own_scale = false;
  float cell_mm = 3;
  int sheet = 0;
  std::shared_ptr<SheetPreview> preview{};
};
/// Its options, from what was chosen.
print::PrintOptions chosen_options(const PrintPrompt& p);
/// ".pdf", ".svg" or ".png".
const char* ending_of(print::PrintFormat format);

}  // namespace weftlight::views
