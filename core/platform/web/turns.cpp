#include "platform/turns.h"

#include <emscripten.h>

#include <utility>

namespace weftlight::platform {

void take_turns(std::function<bool()> turn) {
  static std::function<bool()>& kept = *new std::function<bool()>;
  kept = std::move(turn);
  // With each picture of the browser's.
  constexpr int kEachPicture = 0, kReturn = 0;
  emscripten_set_main_loop(
      [] {
        if (!kept()) emscripten_cancel_main_loop();
      },
      kEachPicture, kReturn);
}

}  // namespace weftlight::platform
