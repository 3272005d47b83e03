#include "platform/desktop.h"

#include <utility>

#include "platform/environment_variables.h"
#include "platform/posix/dialog_program.h"
#include "platform/process.h"

namespace weftlight::platform {
namespace {

DialogProgram installed_program() { return find_dialog_program(variable("PATH"), variable("XDG_CURRENT_DESKTOP")); }

/// In the program that the user chose for such things.
tl::expected<void, MissingProgram> show(const std::string& path) {
#ifdef __APPLE__
  constexpr const char* kProgram = "open";
#else
  constexpr const char* kProgram = "xdg-open";
#endif
  if (start_program({kProgram, path})) return {};
  return tl::unexpected(MissingProgram{kProgram});
}

}  // namespace

tl::expected<void, MissingProgram> show_folder(const std::string& folder) { return show(folder); }

tl::expected<void, MissingProgram> show_page(const std::string& file) { return show(file); }

struct FileDialog::Asked {
  Process program;
};

FileDialog::FileDialog() = default;
FileDialog::~FileDialog() = default;

bool FileDialog::is_there() { return installed_program() != DialogProgram::kNone; }

void FileDialog::ask(const FileQuestion& question, std::function<void(const std::string&)> chosen) {
  if (waiting()) return;
  asked_.reset(new Asked{Process(dialog_words(installed_program(), question))});
  chosen_ = std::move(chosen);
}

void FileDialog::poll() {
  if (!waiting()) return;
  asked_->program.look();
  if (asked_->program.running()) return;
  const auto asked = std::exchange(asked_, nullptr);
  const auto chosen = std::exchange(chosen_, nullptr);
  std::string path = asked->program.output();
  while (!path.empty() && (path.back() == '\n' || path.back() == '\r')) path.pop_back();
  if (asked->program.succeeded() && !path.empty()) chosen(path);
}

}  // namespace weftlight::platform
