#pragma once
// Texture sets: their dialog, the export in progress, and the export again after an edit, if that is wanted.

#include <cstdint>
#include <memory>

#include "app/dialogs.h"
#include "app/messages.h"
#include "session/jobs/export_places.h"
#include "session/jobs/exporter.h"
#include "session/session.h"

namespace weftlight::app {

using session::ExportPlaces, session::ExportPlan, session::Exporter, session::Session;

class TextureExports {
 public:
  TextureExports(Session& session, Dialogs& dialogs, Messages& messages);
  void ask();
  /// Exports again after an edit of the exported draft, if that is wanted.
  void follow();
  /// Shows the message of an export that ended. True if there is something to show.
  bool update();
  bool busy() const { return exporter_.busy(); }

 private:
  Session& session_;
  Dialogs& dialogs_;
  Messages& messages_;
  Exporter exporter_;
  ExportPlaces places_;
  std::shared_ptr<ExportPlan> plan_ = std::make_shared<ExportPlan>();
  uint64_t exported_ = 0;  // id of the document that was exported
};

}  // namespace weftlight::app
