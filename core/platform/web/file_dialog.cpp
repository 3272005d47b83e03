// The browser's own dialogs for files, through the page (editor/web/files.js). What is chosen is a path in the page's
// file system; the page reads the picked file into it, and delivers what is written there.

#include <emscripten.h>

#include <cstdlib>
#include <utility>

#include "platform/desktop.h"

EM_JS(void, page_ask, (const char* what, const char* title, const char* start, const char* patterns),
      { Files.ask(UTF8ToString(what), UTF8ToString(title), UTF8ToString(start), UTF8ToString(patterns)); });
/// The path that was chosen, empty after a cancel; null while there is no answer. To be freed.
EM_JS(char*, page_answer, (), {
  const answer = Files.take();
  return answer == null ? 0 : allocateUTF8(answer);
});

namespace weftlight::platform {

struct FileDialog::Asked {};
FileDialog::FileDialog() = default;
FileDialog::~FileDialog() = default;
bool FileDialog::is_there() { return true; }

void FileDialog::ask(const FileQuestion& question, std::function<void(const std::string&)> chosen) {
  if (asked_) return;
  asked_ = std::make_unique<Asked>();
  chosen_ = std::move(chosen);
  const char* what = question.what == FileAsk::kOpen ? "open" : question.what == FileAsk::kSave ? "save" : "folder";
  std::string patterns;
  for (const FileFilter& filter : question.filters) patterns += filter.patterns + " ";
  page_ask(what, question.title.c_str(), question.start.c_str(), patterns.c_str());
}

void FileDialog::poll() {
  if (!asked_) return;
  char* const answer = page_answer();
  if (answer == nullptr) return;
  const std::string path = answer;
  std::free(answer);
  asked_.reset();
  const auto chosen = std::exchange(chosen_, nullptr);
  if (!path.empty()) chosen(path);
}

}  // namespace weftlight::platform
