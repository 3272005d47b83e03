#include "app/file_dialog.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include "base/text.h"

extern char** environ;

namespace weftlight::app {

using base::tr;

namespace {

struct Asking {
  pid_t program = 0;  // 0 if it did not start
  int answer = -1;    // read end of its output
};

Asking start_asking(std::vector<std::string> words) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (started && fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0) return {child, ends[0]};
  close(ends[0]);
  return {};
}

/// Reads what is there; true at the end of the output.
bool read_all(int from, std::string& text) {
  char buffer[4096];
  ssize_t n = 0;
  while ((n = read(from, buffer, sizeof buffer)) > 0 || (n < 0 && errno == EINTR))
    if (n > 0) text.append(buffer, static_cast<size_t>(n));
  return n == 0 || errno != EAGAIN;
}

bool is_program(const std::string& path, const std::string& name) {
  std::istringstream folders(path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  return false;
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

struct Filter {
  std::string name, patterns;
};
std::vector<Filter> filters_of(FileAsk what, const std::string& ending) {
  std::vector<Filter> filters;
  if (ending == ".hdr") return {{tr("Environment pictures"), "*.hdr *.HDR *.exr *.EXR"}, {tr("All files"), "*"}};
  if (what == FileAsk::kOpen)
    filters.push_back({tr("Weaving drafts"), "*.wif *.WIF *.wifw *.WIFW *.dtx *.DTX *.wpo *.WPO"});
  filters.push_back(ending == ".wif" ? Filter{tr("WIF drafts"), "*.wif *.WIF *.wifw *.WIFW"}
                                     : Filter{"*" + ending, "*" + ending});
  if (what == FileAsk::kOpen)
    filters.push_back({tr("Pictures, one pixel for each crossing"), "*.png *.PNG *.tif *.tiff *.TIF *.bmp"});
  filters.push_back({tr("All files"), "*"});
  return filters;
}

std::vector<std::string> zenity_words(FileAsk what, const std::string& title, const std::string& start,
                                      const std::string& ending) {
  std::vector<std::string> words = {"zenity", "--file-selection", "--title=" + title};
  if (what == FileAsk::kFolder) words.push_back("--directory");
  else
    for (const Filter& f : filters_of(what, ending)) words.push_back("--file-filter=" + f.name + " | " + f.patterns);
  if (!start.empty()) words.push_back("--filename=" + start);
  if (what == FileAsk::kSave) words.insert(words.end(), {"--save", "--confirm-overwrite"});
  return words;
}

/// kdialog itself asks before it returns an existing file.
std::vector<std::string> kdialog_words(FileAsk what, const std::string& title, const std::string& start,
                                       const std::string& ending) {
  const char* verb = what == FileAsk::kFolder ? "--getexistingdirectory"
                     : what == FileAsk::kSave ? "--getsavefilename"
                                              : "--getopenfilename";
  std::vector<std::string> words = {"kdialog", "--title", title, verb, start.empty() ? "." : start};
  if (what == FileAsk::kFolder) return words;
  std::string all;
  for (const Filter& f : filters_of(what, ending)) {
    if (!all.empty()) all += "|";
    all.append(f.name).append(" (").append(f.patterns).append(")");
  }
  words.push_back(std::move(all));
  return words;
}

}  // namespace

Asker find_asker(const std::string& path, const std::string& desktop) {
  const bool zenity = is_program(path, "zenity"), kdialog = is_program(path, "kdialog");
  if (kdialog && (!zenity || desktop.find("KDE") != std::string::npos)) return Asker::kKdialog;
  return zenity ? Asker::kZenity : Asker::kNone;
}

std::vector<std::string> asker_words(Asker asker, FileAsk what, const std::string& title, const std::string& start,
                                     const std::string& ending) {
  return asker == Asker::kKdialog ? kdialog_words(what, title, start, ending)
                                  : zenity_words(what, title, start, ending);
}

bool FileDialog::is_there() { return find_asker(variable("PATH"), variable("XDG_CURRENT_DESKTOP")) != Asker::kNone; }

void FileDialog::ask(FileAsk what, const std::string& title, const std::string& start, const std::string& ending,
                     std::function<void(const std::string&)> chosen) {
  if (waiting()) return;
  const Asker asker = find_asker(variable("PATH"), variable("XDG_CURRENT_DESKTOP"));
  std::vector<std::string> words = asker_words(asker, what, title, start, ending);
  chosen_ = std::move(chosen);
  const Asking asking = start_asking(std::move(words));
  asking_ = asking.program, answer_ = asking.answer;
  answer_so_far_.clear();
}

void FileDialog::poll() {
  if (!waiting()) return;
  if (answer_ >= 0 && read_all(answer_, answer_so_far_)) close(std::exchange(answer_, -1));
  int status = 0;
  if (answer_ >= 0 || waitpid(asking_, &status, WNOHANG) == 0) return;
  asking_ = 0;
  const auto chosen = std::exchange(chosen_, nullptr);
  std::string path = std::exchange(answer_so_far_, {});
  while (!path.empty() && (path.back() == '\n' || path.back() == '\r')) path.pop_back();
  if (status == 0 && !path.empty()) chosen(path);
}

FileDialog::~FileDialog() {
  if (answer_ >= 0) close(answer_);
  if (!waiting()) return;
  kill(asking_, SIGTERM);
  // A dialog that does not end within 100 ms is killed.
  for (int i = 0; i < 20; ++i) {
    if (waitpid(asking_, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(asking_, SIGKILL);
  waitpid(asking_, nullptr, 0);
}

}  // namespace weftlight::app
