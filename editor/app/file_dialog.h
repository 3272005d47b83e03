#pragma once
// The system's file dialog, through zenity, which runs beside the window.

#include <functional>
#include <future>
#include <optional>
#include <string>

#include "app/names.h"

namespace weftlight::app {

enum class FileAsk { kOpen, kSave, kFolder };

class FileDialog {
 public:
  /// False without zenity: ask inside the window instead.
  static bool is_there();
  /// `ending`: of what is saved, ".wif".
  void ask(FileAsk what, const std::string& title, const std::string& start, const std::string& ending,
           std::function<void(const std::string&)> chosen);
  bool waiting() const { return answer_.valid(); }
  /// Calls `chosen` once an answer has come.
  void poll();

 private:
  std::future<std::string> answer_;  // empty: left without a choice
  std::function<void(const std::string&)> chosen_;
};

}  // namespace weftlight::app
