#include "platform/posix/dialog_program.h"

#include <utility>

#include "platform/process.h"

namespace weftlight::platform {
namespace {

std::vector<std::string> zenity_words(const FileQuestion& asked) {
  std::vector<std::string> words = {"zenity", "--file-selection", "--title=" + asked.title};
  if (asked.what == FileAsk::kFolder) words.push_back("--directory");
  for (const FileFilter& f : asked.filters) words.push_back("--file-filter=" + f.name + " | " + f.patterns);
  if (!asked.start.empty()) words.push_back("--filename=" + asked.start);
  if (asked.what == FileAsk::kSave) words.insert(words.end(), {"--save", "--confirm-overwrite"});
  return words;
}

/// kdialog itself asks before it returns an existing file.
std::vector<std::string> kdialog_words(const FileQuestion& asked) {
  const char* verb = asked.what == FileAsk::kFolder ? "--getexistingdirectory"
                     : asked.what == FileAsk::kSave ? "--getsavefilename"
                                                    : "--getopenfilename";
  std::vector<std::string> words = {"kdialog", "--title", asked.title, verb, asked.start.empty() ? "." : asked.start};
  std::string all;
  for (const FileFilter& f : asked.filters) {
    if (!all.empty()) all += "|";
    all.append(f.name).append(" (").append(f.patterns).append(")");
  }
  if (!all.empty()) words.push_back(std::move(all));
  return words;
}

}  // namespace

DialogProgram find_dialog_program(const std::string& path, const std::string& desktop) {
  const bool zenity = is_program("zenity", path), kdialog = is_program("kdialog", path);
  if (kdialog && (!zenity || desktop.find("KDE") != std::string::npos)) return DialogProgram::kKdialog;
  return zenity ? DialogProgram::kZenity : DialogProgram::kNone;
}

std::vector<std::string> dialog_words(DialogProgram program, const FileQuestion& question) {
  return program == DialogProgram::kKdialog ? kdialog_words(question) : zenity_words(question);
}

}  // namespace weftlight::platform
