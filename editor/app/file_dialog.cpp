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
  if (ending == ".hdr") return {{"Pictures from all around", "*.hdr *.HDR *.exr *.EXR"}, {"All files", "*"}};
  if (what == FileAsk::kOpen)
    filters.push_back({"Weaving drafts", "*.wif *.WIF *.wifw *.WIFW *.dtx *.DTX *.wpo *.WPO"});
  filters.push_back(ending == ".wif" ? Filter{"WIF drafts", "*.wif *.WIF *.wifw *.WIFW"}
                                     : Filter{"*" + ending, "*" + ending});
  if (what == FileAsk::kOpen)
    filters.push_back({"Pictures, a pixel a crossing", "*.png *.PNG *.tif *.tiff *.TIF *.bmp"});
  filters.push_back({"All files", "*"});
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

/// kdialog asks by itself before it gives a file that is there.
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
  answer_ = std::async(std::launch::async, [words = std::move(words)] { return output_of(words); });
}

void FileDialog::poll() {
  if (!waiting() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  const std::string path = answer_.get();
  const auto chosen = std::exchange(chosen_, nullptr);
  if (!path.empty()) chosen(path);
}

}  // namespace weftlight::app
