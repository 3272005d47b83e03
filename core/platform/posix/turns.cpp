#include "platform/turns.h"

namespace weftlight::platform {

void take_turns(std::function<bool()> turn) {
  while (turn()) {
  }
}

}  // namespace weftlight::platform
