// The compositor goes away under a window: a socket stands for it, and this program for the window library that knows
// the connection. Each case in a process of its own, since a lost display ends it.

#include "platform/display.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace {

void* connection = nullptr;

}  // namespace

/// Found by its name, as that of the window library.
extern "C" __attribute__((visibility("default"))) void* glfwGetWaylandDisplay() { return connection; }

namespace weftlight::platform {
namespace {

constexpr int kSaved = 42;  // exit code of one who kept the work

template <class Function>
Function* of_wayland(const char* name) {
  static void* const library = dlopen("libwayland-client.so.0", RTLD_LAZY);
  return library != nullptr ? reinterpret_cast<Function*>(dlsym(library, name)) : nullptr;
}

class Compositor : public ::testing::Test {
 protected:
  void SetUp() override {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    if (of_wayland<void>("wl_display_connect_to_fd") == nullptr) GTEST_SKIP() << "libwayland-client is not installed";
  }
  /// Opens the window, so to speak.
  void connect() {
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data()), 0);
    connection = of_wayland<void*(int)>("wl_display_connect_to_fd")(ends_[0]);
    ASSERT_NE(connection, nullptr);
    when_display_lost([] { ::_exit(kSaved); });
  }
  void go_away() const { ::close(ends_[1]); }

  std::array<int, 2> ends_{};
};

TEST_F(Compositor, EndsAWindowThatHangs) {
  EXPECT_EXIT(
      {
        connect();
        EXPECT_FALSE(is_display_lost());
        go_away();
        for (;;) ::pause();
      },
      ::testing::ExitedWithCode(kSaved), "");
}

TEST_F(Compositor, IsMissedByAWindowThatAsksForIt) {
  EXPECT_EXIT(
      {
        connect();
        go_away();
        of_wayland<int(void*)>("wl_display_roundtrip")(connection);
        if (is_display_lost()) display_lost();
        ::_exit(1);
      },
      ::testing::ExitedWithCode(kSaved), "");
}

TEST_F(Compositor, WithoutOneNothingIsLost) {
  EXPECT_EXIT(
      {
        connection = nullptr;
        when_display_lost([] { ::_exit(kSaved); });
        ::_exit(is_display_lost() ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace weftlight::platform
