#pragma once
// The export of texture sets: for which programs, how fine and where to, beside what the sets will hold; how far the
// export is, and whether it follows the draft.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "session/export_plan.h"
#include "session/export_preview.h"
#include "session/exporter.h"
#include "ui/pixel_texture.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// What the dialog has on the graphics card, and the thread that makes it.
struct ExportStage {
  ExportStage(std::shared_ptr<const Design> design, std::function<void()> wake)
      : preview(std::move(design), std::move(wake)) {}
  ExportPreview shown;  // the last that was made; its pixels are in `texture`
  PixelTexture texture;
  ExportPreviewer preview;
  /// True when there is another picture. In the window's thread.
  bool poll();
};

struct ExportPrompt {
  std::shared_ptr<ExportPlan> plan;  // what is chosen outlives the dialog
  std::shared_ptr<const Design> design;
  std::string draft_path, version;
  Exporter* exporter = nullptr;
  std::shared_ptr<ExportStage> stage;
  size_t target = 0;  // whose images are shown, of the plan's
  Face face = Face::kFront;
  std::vector<std::string> asked{};  // what is in the way; while it stands, the question is open
  // Worked out when the choices change.
  std::string key{};
  std::vector<ExportJob> jobs{};
  ExportFigures figures{};
  int replaced = 0;  // files of the same sets

  enum Button { kExport = 0, kClose = 1, kFolder = 2 };
};

}  // namespace weftlight::views
