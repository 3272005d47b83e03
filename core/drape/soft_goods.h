#pragma once
// Drapes that are sewn little or not at all, but are no plain sheets: a scarf about the neck, a cushion.

#include "drape/garments.h"
#include "drape/names.h"

namespace weftlight::drape {

/// A strip about the dress form's neck, its ends hanging in front.
Drape scarf();
/// Two squares sewn together all round and filled, lying on a board that leans.
Drape cushion();

}  // namespace weftlight::drape
