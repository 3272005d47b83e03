// Input that is faster than the frames is neither lost nor reordered.

#include "session/jobs/input_queue.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace weftlight::session {
namespace {

using Kind = InputEvent::Kind;

InputEvent move(double x) { return {Kind::kMove, x, 0}; }
InputEvent button(bool down) { return {Kind::kButton, 0, 0, 0, down}; }
InputEvent key(char name, bool down, Modifiers held = {}) {
  return {Kind::kKey, 0, 0, static_cast<unsigned>(name), down, held};
}
InputEvent control(bool down) { return {Kind::kModifier, 0, 0, 341, down}; }
InputEvent character(char c) { return {Kind::kCharacter, 0, 0, static_cast<unsigned char>(c)}; }

void add(InputQueue& q, std::initializer_list<InputEvent> events) {
  for (const InputEvent& e : events) q.add(e);
}

void type(InputQueue& q, const char* text) {
  for (; *text != 0; ++text) add(q, {key(*text, true), character(*text), key(*text, false)});
}

void click(InputQueue& q) { add(q, {move(1), button(true), button(false)}); }

/// "m" a move, "b" and "B" a button up and down, "s" a scroll, "k" and "K" a key, "c" and "C" a modifier, the
/// characters themselves in quotes; a bar after each frame.
std::string frames_of(InputQueue& q) {
  std::string text;
  for (int frame = 0; frame < 100 && !q.empty(); ++frame) {
    for (const InputEvent& e : q.next_frame()) {
      if (e.kind == Kind::kMove) text += 'm';
      if (e.kind == Kind::kButton) text += e.down ? 'B' : 'b';
      if (e.kind == Kind::kScroll) text += 's';
      if (e.kind == Kind::kKey) text += e.down ? 'K' : 'k';
      if (e.kind == Kind::kModifier) text += e.down ? 'C' : 'c';
      if (e.kind == Kind::kCharacter) text.append({'\'', static_cast<char>(e.code), '\''});
    }
    text += '|';
  }
  return text;
}

TEST(InputQueue, PressAndReleaseComeInTwoFrames) {
  InputQueue q;
  click(q);
  click(q);
  EXPECT_EQ(frames_of(q), "mB|b|mB|b|");
}

TEST(InputQueue, ADragReachesItsEndBeforeTheRelease) {
  InputQueue q;
  add(q, {move(1), button(true), move(2), move(3), button(false)});
  EXPECT_EQ(frames_of(q), "mB|mm|b|");
}

TEST(InputQueue, TypedTextGoesToTheFieldThatTheClickOpened) {
  InputQueue q;
  click(q);
  type(q, "10");
  EXPECT_EQ(frames_of(q), "mB|b|||K'1'kK'0'k|");
}

TEST(InputQueue, AShortcutAfterTypedTextComesAfterIt) {
  InputQueue q;
  type(q, "10");
  add(q, {key('\r', true), key('\r', false)});
  type(q, "a");
  EXPECT_EQ(frames_of(q), "K'1'kK'0'kK|k||K'a'k|");
}

TEST(InputQueue, AShortcutKeepsItsModifiers) {
  InputQueue q;
  add(q, {control(true), key('A', true, {true, false, false}), key('A', false), control(false)});
  type(q, "5");
  EXPECT_EQ(frames_of(q), "CK|kc||K'5'k|");
}

TEST(InputQueue, APressedKeyIsReleasedBeforeItsNextPress) {
  InputQueue q;
  for (int i = 0; i < 3; ++i) add(q, {key('Z', true, {true, false, false}), key('Z', false)});
  EXPECT_EQ(frames_of(q), "K|k|K|k|K|k|");
}

TEST(InputQueue, AShortcutAfterReturnDoesNotGoToTheField) {
  InputQueue q;
  type(q, "7");
  add(q, {key('\r', true), key('\r', false), control(true), key('S', true, {true, false, false}), key('S', false)});
  EXPECT_EQ(frames_of(q), "K'7'kK|kC|K|k|");
}

TEST(InputQueue, ScrollsAddUpUntilTheModifiersChange) {
  InputQueue q;
  const auto scroll = [](bool ctrl) { return InputEvent{Kind::kScroll, 0, 1, 0, false, {ctrl, false, false}}; };
  add(q, {move(1), scroll(false), scroll(false), control(true), scroll(true), move(2)});
  EXPECT_EQ(frames_of(q), "mssC|s|m|");
}

}  // namespace
}  // namespace weftlight::session
