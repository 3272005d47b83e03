#pragma once
// This folder uses the names of base only: it knows ImGui and nothing of drafts.

#include "base/names.h"

namespace weftlight {
namespace ui {
using namespace base;
}  // namespace ui
}  // namespace weftlight
