#pragma once
// What leaves the program besides the draft: texture sets and paper.

#include <functional>

namespace weftlight::actions {

struct ExportActions {
  std::function<void()> export_textures, print;
};

}  // namespace weftlight::actions
