#include "platform/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

extern char** environ;

namespace weftlight::platform {
namespace {

/// 0 if it cannot be started.
pid_t spawn(std::vector<std::string> words, const posix_spawn_file_actions_t* actions) {
  if (words.empty()) return 0;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  // Broken pipes (display.cpp) and files past their limit (file.cpp) may be ignored, which programs would inherit.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t usual;
  sigemptyset(&usual);
  for (const int ignored : {SIGPIPE, SIGXFSZ}) sigaddset(&usual, ignored);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, argv[0], actions, &attributes, argv.data(), environ) == 0;
  posix_spawnattr_destroy(&attributes);
  return started ? child : 0;
}

constexpr size_t kMaxOutput = size_t{1} << 20;  // what is printed beyond it is dropped

/// Reads what is there, but not for ever; true at the end of the output.
bool read_all(int from, std::string& text) {
  char buffer[4096];
  ssize_t n = 0;
  size_t all = 0;
  while (all < kMaxOutput && ((n = ::read(from, buffer, sizeof buffer)) > 0 || (n < 0 && errno == EINTR))) {
    if (n <= 0) continue;
    all += static_cast<size_t>(n);
    text.append(buffer, std::min(static_cast<size_t>(n), kMaxOutput - std::min(text.size(), kMaxOutput)));
  }
  return n == 0 || (n < 0 && errno != EAGAIN);
}

}  // namespace

Process::Process(const std::vector<std::string>& words) {
  int ends[2];
  // Not pipe2, which macOS lacks.
  if (::pipe(ends) != 0) return;
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  if (::fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0) id_ = spawn(words, &actions);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (running()) reading_ = ends[0];
  else ::close(ends[0]);
}

Process::~Process() {
  if (reading_ >= 0) ::close(static_cast<int>(reading_));
  if (!running()) return;
  const auto program = static_cast<pid_t>(id_);
  ::kill(program, SIGTERM);
  for (int i = 0; i < 20; ++i) {
    if (::waitpid(program, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ::kill(program, SIGKILL);
  ::waitpid(program, nullptr, 0);
}

void Process::look() {
  if (!running()) return;
  if (reading_ >= 0 && read_all(static_cast<int>(reading_), output_))
    ::close(static_cast<int>(std::exchange(reading_, -1)));
  int status = 0;
  if (::waitpid(static_cast<pid_t>(id_), &status, WNOHANG) == 0) return;
  // What it printed itself is there by now. A program that it started may hold the output open for as long as it likes.
  if (reading_ >= 0) {
    read_all(static_cast<int>(reading_), output_);
    ::close(static_cast<int>(std::exchange(reading_, -1)));
  }
  id_ = 0;
  succeeded_ = status == 0;
}

bool start_program(const std::vector<std::string>& words) {
  const pid_t child = spawn(words, nullptr);
  if (child == 0) return false;
  // A thread of its own waits for the process, so that none is left defunct.
  try {
    std::thread([child] { ::waitpid(child, nullptr, 0); }).detach();
  } catch (const std::system_error&) {  // without a thread it stays defunct until this program ends
  }
  return true;
}

bool is_program(const std::string& name, const std::string& folders) {
  std::istringstream each(folders);
  for (std::string folder; std::getline(each, folder, ':');)
    if (::access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace weftlight::platform
