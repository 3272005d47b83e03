// A handler of signals may call only what is safe in the middle of anything else: no memory is taken, no lock, no
// stream. What it needs is prepared by report_crashes(). dladdr() alone may take a lock; it comes last in the report,
// and an alarm ends the program if it waits.
#include "platform/crash_report.h"

#include <cxxabi.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>
#include <unwind.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <typeinfo>
#include <utility>

namespace weftlight::platform {
namespace {

constexpr unsigned kActions = 10;
constexpr size_t kMaxId = 48;        // with its end
constexpr size_t kMaxPath = 4096;    // with its end
constexpr int kMaxFrames = 64;       // of a stack
constexpr unsigned kPatienceS = 10;  // of a disk
constexpr size_t kAlternateStack = size_t{1} << 16;

struct Fault {
  int signal;
  const char* words;
};
constexpr std::array kFaults = {
    Fault{SIGSEGV, "SIGSEGV (memory that is not there)"}, Fault{SIGABRT, "SIGABRT (the program gave up)"},
    Fault{SIGBUS, "SIGBUS (memory that cannot be reached)"}, Fault{SIGFPE, "SIGFPE (an impossible calculation)"},
    Fault{SIGILL, "SIGILL (an unknown instruction)"}};

struct Prepared {
  std::array<char, kMaxPath> folder{};
  std::array<char, 128> program{};
  pthread_t main_thread{};
  std::array<struct sigaction, kFaults.size()> before{};
  std::terminate_handler terminate = nullptr;
  bool installed = false;
};
Prepared prepared;
alignas(16) std::array<char, kAlternateStack> alternate_stack;

// A crash may come while another thread notes an action, so every character is written by itself.
std::array<std::array<std::atomic<char>, kMaxId>, kActions> actions;
std::atomic<unsigned> noted = 0;

std::atomic<const char*> exception_type = nullptr;
std::atomic<pthread_t> reporting{};  // the thread that writes the report

/// Copies what fits; false if not all of it does.
template <size_t kSize>
bool copy_text(const std::string& from, std::array<char, kSize>& to) {
  const size_t n = std::min(from.size(), kSize - 1);
  std::copy_n(from.data(), n, to.data());
  to[n] = 0;
  return n == from.size();
}

/// Writes to an open file.
class Lines {
 public:
  explicit Lines(int file) : file_(file) {}
  Lines& text(const char* words) {
    size_t left = std::strlen(words);
    while (left > 0) {
      const ssize_t n = ::write(file_, words, left);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return *this;
      words += n;
      left -= static_cast<size_t>(n);
    }
    return *this;
  }
  /// At least so many digits.
  Lines& number(uint64_t value, int digits = 1, unsigned base = 10) {
    std::array<char, 24> written{};
    size_t at = written.size() - 1;
    while (value > 0 || digits > 0) {
      written[--at] = "0123456789abcdef"[value % base];
      value /= base;
      --digits;
    }
    return text(&written[at]);
  }
  Lines& address(uintptr_t value) { return text("0x").number(value, 1, 16); }

 private:
  int file_;
};

void write_time(Lines& out) {
  using std::chrono::days, std::chrono::floor, std::chrono::seconds, std::chrono::sys_seconds,
      std::chrono::year_month_day;
  const auto now = static_cast<int64_t>(std::time(nullptr));
  const sys_seconds at{seconds(now)};
  const year_month_day date(floor<days>(at));
  const auto second = static_cast<uint64_t>((at - floor<days>(at)).count());
  out.text("time: ").number(static_cast<uint64_t>(static_cast<int>(date.year())), 4).text("-");
  out.number(static_cast<unsigned>(date.month()), 2).text("-").number(static_cast<unsigned>(date.day()), 2).text(" ");
  out.number(second / 3600, 2).text(":").number(second / 60 % 60, 2).text(":").number(second % 60, 2).text(" UTC\n");
}

void write_actions(Lines& out) {
  out.text("last actions, newest first:\n");
  const unsigned all = noted.load();
  std::array<char, kMaxId> id{};
  for (unsigned back = 1; back <= std::min(all, kActions); ++back) {
    const auto& kept = actions[(all - back) % kActions];
    std::transform(kept.begin(), kept.end(), id.begin(), [](const std::atomic<char>& c) { return c.load(); });
    id.back() = 0;
    out.text("  ").text(id.data()).text("\n");
  }
}

/// The last part of a path.
const char* name_of(const char* path) {
  const char* slash = std::strrchr(path, '/');
  return slash != nullptr ? slash + 1 : path;
}

struct Walk {
  Lines* out;
  int frames;
};

_Unwind_Reason_Code write_frame(_Unwind_Context* context, void* state) {
  auto& walk = *static_cast<Walk*>(state);
  int exact = 0;  // else it is where a call returns to, which may be in the next line or function
  uintptr_t at = _Unwind_GetIPInfo(context, &exact);
  if (at == 0 || walk.frames == kMaxFrames) return _URC_END_OF_STACK;
  ++walk.frames;
  if (exact == 0) --at;
  Dl_info module{};
  if (::dladdr(std::bit_cast<void*>(at), &module) == 0 || module.dli_fname == nullptr) {
    walk.out->text("  ? ").address(at).text("\n");
    return _URC_NO_REASON;
  }
  walk.out->text("  ").text(name_of(module.dli_fname)).text(" ");
  walk.out->address(at - reinterpret_cast<uintptr_t>(module.dli_fbase));
  if (module.dli_sname != nullptr) walk.out->text(" ").text(module.dli_sname);
  walk.out->text("\n");
  return _URC_NO_REASON;
}

/// Of the thread that calls it, through the frame of the signal.
void write_stack(Lines& out) {
  out.text("stack (modules and offsets in them):\n");
  Walk walk{&out, 0};
  _Unwind_Backtrace(write_frame, &walk);
}

/// Those above it, too. What cannot be made is found out when the report is opened.
void make_folder() {
  std::array<char, kMaxPath>& path = prepared.folder;
  for (size_t i = 1; i < path.size() && path[i - 1] != 0; ++i) {
    if (path[i] != '/' && path[i] != 0) continue;
    const char kept = path[i];
    path[i] = 0;
    ::mkdir(path.data(), S_IRWXU);
    path[i] = kept;
  }
  ::chmod(path.data(), S_IRWXU);
}

/// The folder's path with the name of a report.
void path_of(int number, std::array<char, kMaxPath + 16>& path) {
  const size_t n = std::strlen(prepared.folder.data());
  std::copy_n(prepared.folder.data(), n, path.data());
  constexpr char kName[] = "/crash-?.txt";
  std::copy(std::begin(kName), std::end(kName), path.data() + n);
  path[n + 7] = static_cast<char>('0' + number);
}

timespec written_at(const struct stat& file) {
#ifdef __APPLE__
  return file.st_mtimespec;
#else
  return file.st_mtim;
#endif
}

int open_new(const char* path) {
  return ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR);
}

/// A new file under the first name that is free, or in the place of the oldest report; negative if there is none.
int open_report() {
  make_folder();
  std::array<char, kMaxPath + 16> path{};
  int oldest = 0;
  timespec oldest_time{};
  for (int number = 1; number <= kMaxCrashReports; ++number) {
    path_of(number, path);
    const int file = open_new(path.data());
    if (file >= 0 || errno != EEXIST) return file;
    struct stat there {};
    if (::lstat(path.data(), &there) != 0) continue;
    const timespec time = written_at(there);
    const bool older =
        time.tv_sec != oldest_time.tv_sec ? time.tv_sec < oldest_time.tv_sec : time.tv_nsec < oldest_time.tv_nsec;
    if (oldest != 0 && !older) continue;
    oldest = number;
    oldest_time = time;
  }
  if (oldest == 0) return -1;
  path_of(oldest, path);
  ::unlink(path.data());
  return open_new(path.data());
}

void write_report(const char* what, const void* fault_at) {
  const int file = open_report();
  if (file < 0) return;
  Lines out(file);
  out.text(prepared.program.data()).text("\n");
  write_time(out);
  out.text("ended by: ").text(what);
  if (fault_at != nullptr) out.text(" at ").address(reinterpret_cast<uintptr_t>(fault_at));
  out.text("\n");
  if (const char* type = exception_type.load(); type != nullptr) out.text("exception: ").text(type).text("\n");
  const bool main = ::pthread_equal(::pthread_self(), prepared.main_thread) != 0;
  out.text(main ? "thread: the window's\n" : "thread: another\n");
  write_actions(out);
  write_stack(out);
  ::fsync(file);
  ::close(file);
}

/// Ends the program if the report takes too long.
void set_alarm() {
  struct sigaction end {};
  end.sa_handler = SIG_DFL;
  ::sigaction(SIGALRM, &end, nullptr);
  sigset_t alarms;
  ::sigemptyset(&alarms);
  ::sigaddset(&alarms, SIGALRM);
  ::pthread_sigmask(SIG_UNBLOCK, &alarms, nullptr);
  ::alarm(kPatienceS);
}

/// Whether the processor raised it; then it comes again when the handler returns.
bool comes_again(const siginfo_t& info) {
  return info.si_code > 0 && info.si_code != SI_USER && info.si_code != SI_QUEUE;
}

void on_crash(int signal, siginfo_t* info, void*) {
  const int error = errno;
  pthread_t first{};
  const pthread_t self = ::pthread_self();
  const auto fault = std::find_if(kFaults.begin(), kFaults.end(), [=](const Fault& f) { return f.signal == signal; });
  if (reporting.compare_exchange_strong(first, self)) {
    set_alarm();
    write_report(fault->words, comes_again(*info) ? info->si_addr : nullptr);
    ::alarm(0);
  } else if (::pthread_equal(first, self) == 0) {
    for (;;) ::pause();  // the first one ends the program
  }
  ::sigaction(signal, &prepared.before[static_cast<size_t>(fault - kFaults.begin())], nullptr);
  if (!comes_again(*info)) ::raise(signal);
  errno = error;
}

void keep_exception_type() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  exception_type = type != nullptr ? type->name() : nullptr;
}

[[noreturn]] void on_terminate() {
  keep_exception_type();
  prepared.terminate();
  std::abort();
}

/// A stack that ran over has no room for a handler.
void use_alternate_stack() {
  stack_t stack{};
  stack.ss_sp = alternate_stack.data();
  stack.ss_size = alternate_stack.size();
  ::sigaltstack(&stack, nullptr);
}

bool is_of_identifier(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
}

}  // namespace

std::string crash_report_name(int number) { return "crash-" + std::to_string(number) + ".txt"; }

void report_crashes(const std::string& folder, const std::string& program) {
  copy_text(program, prepared.program);
  if (!copy_text(folder, prepared.folder) || std::exchange(prepared.installed, true)) return;
  prepared.main_thread = ::pthread_self();
  use_alternate_stack();
  prepared.terminate = std::set_terminate(on_terminate);
  struct sigaction crash {};
  crash.sa_sigaction = on_crash;
  crash.sa_flags = SA_SIGINFO | SA_ONSTACK;
  ::sigemptyset(&crash.sa_mask);
  for (const Fault& fault : kFaults) ::sigaddset(&crash.sa_mask, fault.signal);
  for (size_t i = 0; i < kFaults.size(); ++i) ::sigaction(kFaults[i].signal, &crash, &prepared.before[i]);
}

void note_action(std::string_view action) {
  const unsigned all = noted.load();
  auto& kept = actions[all % kActions];
  size_t n = 0;
  for (; n < action.size() && n + 1 < kMaxId && is_of_identifier(action[n]); ++n) kept[n] = action[n];
  kept[n] = 0;
  noted = all + 1;
}

void report_exception() {
  if (!prepared.installed) return;
  keep_exception_type();
  write_report("an exception that went through the whole program", nullptr);
  exception_type = nullptr;
}

}  // namespace weftlight::platform
