#pragma once
// This folder uses the names of base alone: it knows ImGui and nothing of drafts.

namespace weftlight {
namespace base {}
namespace ui {
using namespace base;
}  // namespace ui
}  // namespace weftlight
