#pragma once
// Drapes with few seams that are not flat sheets: a scarf around the neck, a cushion.

#include "drape/garments.h"

namespace weftlight::drape {

/// A strip around the neck of the dress form, its ends hanging in front.
Drape scarf();
/// Two squares, sewn together all round and filled, on a tilted board.
Drape cushion();

}  // namespace weftlight::drape
