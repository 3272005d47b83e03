#pragma once
// Export of texture sets: targets, resolution and folder, beside a preview of the images; progress, and whether the
// export follows the draft.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "session/jobs/export_places.h"
#include "session/jobs/export_plan.h"
#include "session/jobs/export_preview.h"
#include "session/jobs/exporter.h"
#include "ui/pixel_texture.h"
#include "views/common/panel.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using design::Design;
using draft::Face;
using session::ExportFigures, session::ExportJob, session::ExportPlaces, session::ExportPlan, session::ExportPreview,
    session::ExportPreviewer, session::Exporter;
using ui::PixelTexture;

/// The preview images: their texture, and the thread that renders them.
struct ExportStage {
  ExportStage(std::shared_ptr<const Design> design, std::function<void()> wake)
      : preview(std::move(design), std::move(wake)) {}
  ExportPreview shown;  // the last one rendered; its pixels are in `texture`
  std::string problem;  // why the last one could not be rendered, for the user
  PixelTexture texture;
  ExportPreviewer preview;
  /// True if there is a new picture. Call it on the window's thread.
  bool poll();
};

struct ExportPrompt {
  std::shared_ptr<ExportPlan> plan;  // the choices outlive the dialog
  std::shared_ptr<const Design> design;
  std::string draft_path, version;
  Exporter* exporter = nullptr;
  ExportPlaces* places = nullptr;
  std::shared_ptr<ExportStage> stage;
  size_t target = 0;  // index in plan->targets of the previewed one
  Face face = Face::kFront;
  std::vector<std::string> conflicts{};  // files in the way; if not empty, the dialog asks for confirmation
  // Computed when the choices change.
  std::string key{};
  std::vector<ExportJob> jobs{};
  ExportFigures figures{};
  bool wants_export = false;  // as soon as it is known what is in the folders

  enum Button { kExport = 0, kClose = 1, kFolder = 2 };
};

DialogResult draw_prompt(PanelContext& c, ExportPrompt& p);

}  // namespace weftlight::views
