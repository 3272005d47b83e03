#pragma once
// A living owner that no process number leads to, as seen from another container or machine: a child takes something,
// forks, and is gone; what it forked has it still, under another number.

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <string>

namespace weftlight {

class Heir {
 public:
  /// `own` runs in the child and calls what it is given with the name of what it has; from there on it is the heir, who
  /// goes on when told to.
  using Own = std::function<void(const std::function<void(const std::string& name)>& inherit)>;
  explicit Heir(const Own& own) {
    if (pipe(to_) != 0 || pipe(from_) != 0) ADD_FAILURE() << "no pipes";
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that the heir's end can be waited for
    child_ = fork();
    if (child_ == 0) {
      close(to_[1]), close(from_[0]);
      own([this](const std::string& name) { inherit(name); });
      _exit(0);
    }
    close(to_[0]), close(from_[1]);
    std::string line;
    for (char c = 0; read(from_[0], &c, 1) == 1 && c != '\n';) line += c;
    heir_ = std::atoi(line.c_str());
    name_ = line.substr(line.find(' ') + 1);
    EXPECT_EQ(waitpid(child_, nullptr, 0), child_);
  }
  ~Heir() { tell('k'); }
  Heir(const Heir&) = delete;
  Heir& operator=(const Heir&) = delete;

  const std::string& name() const { return name_; }
  /// Until it ended, as a killed process does.
  void kill() { tell('k'); }
  /// Until it finished what it was at.
  void finish() { tell('f'); }

 private:
  void inherit(const std::string& name) const {
    if (fork() != 0) _exit(0);
    const std::string line = std::to_string(getpid()) + " " + name + "\n";
    char told = 'k';
    if (write(from_[1], line.data(), line.size()) < 0 || read(to_[0], &told, 1) != 1 || told == 'k') _exit(1);
  }
  void tell(char what) {
    if (to_[1] < 0) return;
    EXPECT_EQ(write(to_[1], &what, 1), 1);
    close(to_[1]), close(from_[0]);
    EXPECT_EQ(waitpid(heir_, nullptr, 0), heir_);
    to_[1] = -1;
  }

  int to_[2] = {-1, -1}, from_[2] = {-1, -1};
  pid_t child_ = 0, heir_ = 0;
  std::string name_;
};

}  // namespace weftlight
