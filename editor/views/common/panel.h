#pragma once
// What every panel gets and gives: it draws one view of the design and returns the edit that the weaver
// asked for, if any. Panels never touch files, nor change the design themselves.

#include <cstdint>

#include "draft/design.h"
#include "draft/drawdown.h"
#include "session/edit.h"
#include "session/report.h"
#include "session/workspace.h"
#include "ui/context.h"
#include "views/common/names.h"

namespace weftlight::views {

struct PanelContext : Context {
  const Design& design;
  const BitMatrix& cells;  // drawdown of the design, front face
  uint64_t revision;       // grows whenever the design changes
  Workspace& work;
  const Report* report = nullptr;  // the last one made, of this design or one before; null: none
};

/// A colour of the design as ImGui packs it.
ImU32 to_u32(Rgb c, float alpha = 1.0f);

}  // namespace weftlight::views
