#pragma once
// Other programs that run beside this one.

#include <cstdint>
#include <string>
#include <vector>

namespace weftlight::platform {

/// A started program and what it prints.
class Process {
 public:
  Process() = default;
  /// Starts the program `words[0]`, which is searched in the system's folders of programs, with the other words as its
  /// arguments. If that fails it is not running.
  explicit Process(const std::vector<std::string>& words);
  /// Ends a program that still runs: politely, and after 100 ms by force.
  ~Process();
  Process(Process&& other) noexcept;
  Process& operator=(Process&& other) noexcept;

  /// Reads what the program has printed, and sees whether it has ended. Never waits.
  void look();
  bool running() const { return id_ != 0; }
  /// After its end: whether it reported success.
  bool succeeded() const { return succeeded_; }
  /// Its standard output so far, at most a megabyte.
  const std::string& output() const { return output_; }

 private:
  std::int64_t id_ = 0;         // 0 if no program runs
  std::intptr_t reading_ = -1;  // from its output; -1 after its end
  std::string output_;
  bool succeeded_ = false;
};

/// Starts a program whose end nobody waits for. False if it cannot be started.
bool start_program(const std::vector<std::string>& words);
/// Whether one of `folders`, written as the variable PATH, holds a program of this name.
bool is_program(const std::string& name, const std::string& folders);

}  // namespace weftlight::platform
