#pragma once
// Keeps the file of --live-export as the shown draft is, after every edit.

#include <memory>
#include <string>

#include "session/document/document.h"
#include "session/files/own_output.h"
#include "session/jobs/background_writer.h"

namespace weftlight::app {

using session::BackgroundWriter, session::Document, session::LiveExport;

class LiveExportWriter {
 public:
  /// Without a path it writes nothing.
  explicit LiveExportWriter(const std::string& path);
  void keep(const Document& document);
  /// The present write error; empty if there is none.
  std::string problem() const { return refused_.empty() ? writer_.problem() : refused_; }
  bool busy() const { return writer_.busy(); }

 private:
  std::shared_ptr<LiveExport> out_;
  BackgroundWriter writer_;
  std::string refused_;  // why the file is not written
};

}  // namespace weftlight::app
