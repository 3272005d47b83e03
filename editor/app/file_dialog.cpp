#include "app/file_dialog.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <utility>
#include <vector>

extern char** environ;

namespace weftlight::app {
namespace {

/// What the program prints, without the line end; empty when it fails.
std::string output_of(std::vector<std::string> words) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t n = 0; started && (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<size_t>(n));
  close(ends[0]);
  int status = 1;
  if (!started || waitpid(child, &status, 0) < 0 || status != 0) return {};
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text;
}

}  // namespace

bool FileDialog::is_there() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/zenity").c_str(), X_OK) == 0) return true;
  return false;
}

void FileDialog::ask(FileAsk what, const std::string& title, const std::string& start, const std::string& ending,
                     std::function<void(const std::string&)> chosen) {
  if (waiting()) return;
  std::vector<std::string> words = {"zenity", "--file-selection", "--title=" + title};
  if (what == FileAsk::kFolder) {
    words.push_back("--directory");
  } else {
    if (what != FileAsk::kSave)
      words.push_back("--file-filter=Weaving drafts | *.wif *.WIF *.wifw *.dtx *.DTX *.wpo *.WPO");
    if (ending == ".wif") words.push_back("--file-filter=WIF drafts (*.wif) | *.wif *.WIF");
    else words.push_back("--file-filter=*" + ending + " | *" + ending);
    words.push_back("--file-filter=All files | *");
  }
  if (!start.empty()) words.push_back("--filename=" + start);
  if (what == FileAsk::kSave) {
    words.push_back("--save");
    words.push_back("--confirm-overwrite");
  }
  chosen_ = std::move(chosen);
  answer_ = std::async(std::launch::async, [words = std::move(words)] { return output_of(words); });
}

void FileDialog::poll() {
  if (!waiting() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  const std::string path = answer_.get();
  const auto chosen = std::exchange(chosen_, nullptr);
  if (!path.empty()) chosen(path);
}

}  // namespace weftlight::app
