#pragma once
// This folder uses no other's names: it knows ImGui and nothing of drafts.

namespace weftlight {
namespace ui {}
}  // namespace weftlight
