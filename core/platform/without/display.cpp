// A window system that stays as long as the program.

#include "platform/display.h"

namespace weftlight::platform {

void when_display_lost(std::function<void()> /*lost*/) {}
bool is_display_lost() { return false; }
void display_lost() {}

}  // namespace weftlight::platform
