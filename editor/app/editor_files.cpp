// The editor's care for files: unsaved work that is journalled and brought back, files that other programs change
// meanwhile, and what could not be written.

#include <chrono>
#include <filesystem>
#include <utility>

#include "app/editor.h"
#include "session/bring_back.h"

namespace weftlight::app {
namespace {

namespace fs = std::filesystem;

int64_t now_ns() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

/// "twill-2.wif" where nothing is yet.
std::string free_name_beside(const std::string& path) {
  const fs::path file(path);
  std::error_code ignored;
  for (int n = 2;; ++n) {
    const fs::path beside =
        file.parent_path() / (file.stem().string() + "-" + std::to_string(n) + file.extension().string());
    if (!fs::exists(beside, ignored)) return beside.string();
  }
}

}  // namespace

void Editor::keep_unsaved() {
  if (document_.is_saved()) journal_.forget(journalled_);
  else journal_.keep(journalled_, document_.note(), document_.writer());
}

void Editor::keep_live_export() {
  const std::string& path = options_.live_export;
  if (path.empty()) return;
  live_problem_.clear();
  if (same_file(path, document_.path())) {
    live_problem_ = "No live export: " + path + " is the open draft";
    return writer_.drop(path);
  }
  writer_.keep(path, [out = live_export_, make = document_.writer()] {
    const std::string problem = out->write(make());
    return problem.empty() ? problem : "No live export to " + out->path() + ": " + problem;
  });
}

std::string Editor::trouble() const {
  std::string problem = journal_.problem();
  if (problem.empty()) problem = live_problem_;
  return problem.empty() ? writer_.problem() : problem;
}

void Editor::save_own(std::function<void()> then) {
  if (document_.look_at_file() != FileChange::kContent) return save_to(document_.path(), std::move(then));
  ask_about_change(true, std::move(then));
}

void Editor::look_at_file() {
  if (!std::holds_alternative<std::monostate>(dialog_) || file_dialog_.waiting()) return;
  switch (document_.look_at_file()) {
    case FileChange::kNone:
      return;
    case FileChange::kContent:
      return ask_about_change(false, nullptr);
    case FileChange::kGone:
      document_.accept_file();
      document_.mark_unsaved();
      say(document_.name() + " is no longer where it was; saving puts it back");
      return edited();
  }
}

void Editor::ask_about_change(bool saving, std::function<void()> then) {
  const std::string lost = document_.is_saved() ? "" : "\n\nReloading it gives up what you did since the last save.";
  ask(Question{document_.name() + " was changed by another program",
               document_.path() + " is not what was opened or saved here." + lost,
               {"Save beside\xE2\x80\xA6", "Keep mine", "Reload", "Cancel"}},
      [this, saving, then = std::move(then)](int button) {
        const std::string path = document_.path();
        if (button == 0)
          ask_path(FileAsk::kSave, "Save your draft beside it", free_name_beside(path),
                   [this, then](const std::string& beside) { save_to(beside, then); });
        if (button == 1 && saving) save_to(path, then);
        if (button == 1 && !saving) {
          document_.accept_file();
          document_.mark_unsaved();
          edited();
        }
        if (button != 2) return;
        OpenResult result = open_document(path);
        if (!result.document) return report(std::move(result.remarks), path);
        replace(std::move(*result.document));
        say("Reloaded " + document_.name());
      });
}

void Editor::offer_recovery() {
  if (left_.empty()) return;
  RecoveryPrompt prompt;
  for (const LeftWork& left : left_)
    prompt.rows.push_back({left.note.name, time_in_words(left.written_ns, now_ns()),
                           left.note.path.empty() ? "never saved" : left.note.path});
  ask(std::move(prompt), [this](int button) {
    const auto chosen = static_cast<size_t>(std::get<RecoveryPrompt>(dialog_).chosen);
    if (button == 0) return unless_unsaved([this, chosen] { bring_back(chosen); });
    if (button != 2) return;
    journal_.discard(left_[chosen]);
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(chosen));
    offer_recovery();
  });
}

void Editor::bring_back(size_t chosen) {
  const LeftWork left = left_[chosen];
  OpenResult back = session::bring_back(left);
  if (!back.document) return report(std::move(back.remarks), left.note.name);
  left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(chosen));
  replace(std::move(*back.document));
  journal_.replace(left, journalled_);
  if (document_.path().empty() && !left.note.path.empty())
    say(left.note.path + " was changed or taken away since: saving asks where to");
  else if (!left_.empty()) say("There is more: File, Bring back unsaved work");
}

}  // namespace weftlight::app
