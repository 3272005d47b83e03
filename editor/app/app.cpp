#include "app/app.h"

namespace weftlight {

int run_editor(const EditorOptions&) { return kNoGraphics; }

}  // namespace weftlight
