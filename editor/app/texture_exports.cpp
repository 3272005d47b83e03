#include "app/texture_exports.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "app/window.h"
#include "base/text.h"
#include "base/version.h"
#include "platform/folders.h"

namespace weftlight::app {

using base::tr;
using session::Document, session::jobs_of;
using views::ExportPrompt, views::ExportStage;

TextureExports::TextureExports(Session& session, Dialogs& dialogs, Messages& messages)
    : session_(session), dialogs_(dialogs), messages_(messages), exporter_(Window::wake), places_(Window::wake) {}

void TextureExports::ask() {
  const Document& document = session_.active().document;
  if (plan_->folder.empty()) {
    const std::filesystem::path beside = std::filesystem::path(document.path()).parent_path();
    const std::string home = platform::home_folder(), from = beside.empty() ? home : beside.string();
    plan_->folder = (std::filesystem::path(from.empty() ? "." : from) / "textures").string();
  }
  ExportPrompt prompt;
  prompt.plan = plan_;
  prompt.design = document.snapshot();
  prompt.draft_path = document.path(), prompt.version = base::version();
  prompt.exporter = &exporter_;
  prompt.places = &places_;
  prompt.stage = std::make_shared<ExportStage>(prompt.design, Window::wake);
  exported_ = session_.active().id;
  dialogs_.ask(std::move(prompt), [this](int) {
    dialogs_.close();
    dialogs_.ask_path(FileAsk::kFolder, tr("Folder for the texture set"), plan_->folder,
                      [this](const std::string& folder) {
                        plan_->folder = folder;
                        ask();
                      });
  });
}

void TextureExports::follow() {
  if (!plan_->watch || session_.active().id != exported_ || !exporter_.began()) return;
  const Document& document = session_.active().document;
  exporter_.start(jobs_of(*plan_, document.now(), document.path(), base::version()), document.snapshot());
}

bool TextureExports::update() {
  const std::string message = exporter_.take_message();
  if (!message.empty()) messages_.say(message);
  return exporter_.take_change() || !message.empty();
}

}  // namespace weftlight::app
