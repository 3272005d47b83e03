#pragma once
// Progress of a command that makes one or several things: how many of them are done, and how long the rest takes. It is
// shown on the status line of a terminal, or written to stderr as lines of JSON for a program that waits.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commands/status_line.h"

namespace weftlight::commands {

enum class ProgressForm { kTerminal, kJson, kNone };

struct ProgressState {
  int done = 0, count = 1;
  double fraction = 0;  // of all the work, 0..1
  std::optional<double> seconds_left;
  std::string item;  // that is being made
};
/// "2 of 9 done, 31 %, 4 min left: denim/gltf", in the user's language.
std::string progress_text(const ProgressState& state);
/// {"progress":{"done":2,"count":9,...}} on one line.
std::string progress_json(const ProgressState& state);
/// "40 s", "4 min" or "2 h 10 min".
std::string time_text(double seconds);

/// Not for several threads at once: the caller locks.
class ProgressMeter {
 public:
  /// seconds: a clock that never goes back; empty: that of the system.
  ProgressMeter(ProgressForm form, int count, std::function<double()> seconds = {});
  /// The time that is left is told from that which passes from here: what went before comes only once.
  void begin() { started_ = seconds_(); }
  /// The item is done up to the fraction, 0..1; 1: it is finished.
  void set(int index, double fraction, const std::string& item);
  /// The item needed no work: it says nothing about the time that the others take.
  void skip(int index, const std::string& item);
  /// Clears the status line, before another line is printed.
  void clear() { line_.clear(); }
  ProgressState state() const;

 private:
  void show(const std::string& item);

  ProgressForm form_;
  std::function<double()> seconds_;
  double started_ = 0, shown_ = -1;
  std::vector<double> fractions_;
  std::vector<bool> skipped_;
  std::string item_;
  int last_done_ = -1;
  StatusLine line_;
};

}  // namespace weftlight::commands
