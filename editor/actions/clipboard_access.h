#pragma once
// The clipboard of the system.

#include <functional>
#include <string>

namespace weftlight::actions {

struct Clipboard {
  std::function<std::string()> text;
  std::function<void(const std::string&)> set_text;
};

}  // namespace weftlight::actions
