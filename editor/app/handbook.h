#pragma once
// The handbook, opened from the Help menu.

#include "app/messages.h"

namespace weftlight::app {

/// Opens its first page in the browser; says so where there is no handbook or no browser.
void show_handbook(Messages& messages);

}  // namespace weftlight::app
