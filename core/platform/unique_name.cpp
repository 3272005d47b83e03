#include "platform/unique_name.h"

#include <random>

namespace weftlight::platform {

std::string unique_name() {
  std::random_device random;
  std::string name;
  for (int digit = 0; digit < 16; ++digit) name += "0123456789abcdef"[random() % 16];
  return name;
}

bool is_unique_name(std::string_view name) {
  return name.size() == 16 && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace weftlight::platform
