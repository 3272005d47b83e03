// The window is killed at random moments during painting: nothing older than half a second is lost, nothing is
// half-written, and everything is offered and recovered at the next start. WEFTLIGHT_KILLS=100 kills a hundred times; a
// few in the ordinary run.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

#include "on_display.h"

namespace weftlight::gui {

using design::Design, design::with_threading;
using draft::Draft;
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int kEnds = 24, kShafts = 8;
constexpr auto kMaxLost = 500ms;
constexpr unsigned kSeed = 1;

/// An xdotool process that is fed command by command, so that the time of each event is known.
class Hand {
 public:
  explicit Hand(const Display& display)
      : corner_(display.on_screen({})),
        pipe_(popen(("DISPLAY=" + display.name() + " xdotool - >/dev/null 2>&1").c_str(), "w")) {}
  ~Hand() {
    release();
    pclose(pipe_);
  }
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;
  void move(Point to) {
    say("mousemove " + std::to_string(std::lround(to.x + corner_.x)) + " " +
        std::to_string(std::lround(to.y + corner_.y)));
  }
  void press() { say("mousedown 1"); }
  void release() { say("mouseup 1"); }

 private:
  void say(const std::string& words) {
    std::fputs((words + "\n").c_str(), pipe_);
    std::fflush(pipe_);
  }
  Point corner_;  // of the window
  FILE* pipe_;
};

/// What was painted: the design after each cell, and the time.
struct Painted {
  std::vector<Design> states;  // the first is the design before painting
  std::vector<Clock::time_point> when;
};

class KillTest : public OnDisplay {
 protected:
  int roll(int from, int to) { return std::uniform_int_distribution<int>(from, to)(dice_); }

  void paint(const Window& w, Painted& painted, Clock::time_point until);
  void take_up(const Window& w, const Painted& before, Clock::time_point killed, Painted& painted);

  std::mt19937 dice_{kSeed};
  double most_lost_s_ = 0;
  int offers_ = 0;
};

/// Clicks and drags in the threading, slow or fast, until it is time.
void KillTest::paint(const Window& w, Painted& painted, Clock::time_point until) {
  Hand hand(display_);
  const bool fast = roll(0, 1) == 1;
  const auto rest = [&] { std::this_thread::sleep_for(fast ? 25ms : 150ms); };
  const Point origin = w.cell("threading", 1, 1), far = w.cell("threading", 2, 2);
  const auto cell = [&](int end, int shaft) {
    return Point{origin.x + end * (far.x - origin.x), origin.y + shaft * (far.y - origin.y)};
  };
  const auto paint_cell = [&](int end, int shaft) {
    painted.states.push_back(with_threading(painted.states.back(), end, shaft, true));
    painted.when.push_back(Clock::now());
  };
  while (Clock::now() < until) {
    const Draft& now = painted.states.back().draft;
    const int first = roll(0, kEnds - 7), last = roll(0, 2) == 0 ? first + roll(1, 6) : first;
    const int shaft = (now.threading.first(first) + roll(1, kShafts - 1)) % kShafts;
    hand.move(cell(first, shaft));
    rest();
    hand.press();
    paint_cell(first, shaft);
    for (int end = first + 1; end <= last; ++end) {
      rest();
      hand.move(cell(end, shaft));
      paint_cell(end, shaft);
    }
    rest();
    hand.release();
    rest();
  }
}

/// Recovers the work of the killed window; `painted` then starts with it.
void KillTest::take_up(const Window& w, const Painted& before, Clock::time_point killed, Painted& painted) {
  // Nothing that was painted half a second before the end may be missing.
  size_t least = 0;
  while (least + 1 < before.states.size() && before.when[least] + kMaxLost < killed) ++least;
  if (least == 0 && before.states.front() == design_of(bytes_of(draft_))) {
    // Too little time for a guaranteed recovery.
    std::this_thread::sleep_for(1s);
    if (!w.has("dialog:Recover")) {
      painted.states = {before.states.front()};
      return;
    }
  }
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Recover"); })) << "nothing was offered";
  display_.click(w.middle_of("dialog:Recover"));
  const std::string original = bytes_of(draft_);
  ASSERT_TRUE(comes_true([&] { return w.live() != original && !w.has("dialog:Recover"); }));
  ++offers_;
  const Design back = design_of(w.live());
  const auto state = std::find(before.states.rbegin(), before.states.rend(), back);
  ASSERT_NE(state, before.states.rend()) << "the recovered draft was never painted";
  const auto kept = static_cast<size_t>(before.states.rend() - state) - 1;
  if (kept + 1 < before.states.size())
    most_lost_s_ = std::max(most_lost_s_, std::chrono::duration<double>(killed - before.when[kept]).count());
  EXPECT_GE(kept, least) << "lost " << before.states.size() - 1 - kept << " cells, the first painted "
                         << std::chrono::duration<double>(killed - before.when[kept]).count() << " s before the end";
  painted.states = {back};
}

TEST_F(KillTest, NothingOlderThanHalfASecondIsLost) {
  show_cloth();
  const char* wanted = std::getenv("WEFTLIGHT_KILLS");
  const int kills = wanted != nullptr ? std::atoi(wanted) : 3;
  const std::string original = bytes_of(draft_);
  Painted before{{design_of(original)}, {}};
  Clock::time_point killed = Clock::now();
  for (int kill = 0; kill <= kills; ++kill) {
    Window w(display_, folder_, draft_);
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    Painted painted;
    ASSERT_NO_FATAL_FAILURE(take_up(w, before, killed, painted)) << "after kill " << kill;
    if (kill == kills) break;
    if (roll(0, 1) == 1) comes_true([&] { return w.has("view.picture") && !w.has("view.busy"); });
    const auto end = Clock::now() + std::chrono::milliseconds(roll(300, 4000));
    std::thread killer([&] {
      std::this_thread::sleep_until(end);
      killed = Clock::now();
      w.process().kill_now();
    });
    paint(w, painted, end);
    killer.join();
    before = std::move(painted);
    // The draft is unchanged, and there are no files but those of flags and settings.
    ASSERT_EQ(bytes_of(draft_), original);
  }
  EXPECT_GE(2 * offers_, kills) << "unsaved work was offered after fewer than half of the kills";
  RecordProperty("most_lost_ms", static_cast<int>(1000 * most_lost_s_));
  std::printf("%d kills; the oldest cell that was lost was painted %.2f s before\n", kills, most_lost_s_);
}

}  // namespace
}  // namespace weftlight::gui
