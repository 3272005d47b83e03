#pragma once
// What is done to a cloth after the loom, and what that makes of its yarns.

#include <array>
#include <vector>

#include "draft/yarn.h"
#include "draft/yarn_fields.h"

namespace weftlight::draft {

/// How far each is taken, 0..1; all may be done to one cloth.
struct Finish {
  float raised = 0;      // wire teeth draw fibres out of the yarns to a nap
  float mercerised = 0;  // swollen in lye under tension: rounder, smoother, brighter
  float calendered = 0;  // pressed between heavy rollers: flat threads that shine
  bool operator==(const Finish&) const = default;
};

inline constexpr std::array<YarnField<Finish>, 3> kFinishFields{{
    {{"Raised", "raised", "Raised", "", 2, 0, 1, 0, 1, false,
      "Brushed to a nap that hides the weave: flannel, blankets",
      "1: the flannel of presets/cloths, by eye beside milled cloth"},
     &Finish::raised},
    {{"Mercerised", "mercerised", "Mercerised", "", 2, 0, 1, 0, 1, false,
      "Cotton swollen in lye under tension: round, smooth, brighter",
      "1: the step from the ready yarn Cotton to Mercerised cotton"},
     &Finish::mercerised},
    {{"Calendered", "calendered", "Calendered", "", 2, 0, 1, 0, 1, false,
      "Pressed by heavy rollers: threads lie flat and shine, as in chintz",
      "1: friction-calendered; threads to half their height, Peirce 1937's range of flattening and below; by eye"},
     &Finish::calendered},
}};

/// Every number inside its range; what is not a number is 0.
Finish clamped(Finish finish);

/// The yarn as it is in the finished cloth; the same, bit for bit, where nothing is done to it.
Yarn finished(Yarn yarn, const Finish& finish);
std::vector<Yarn> finished(std::vector<Yarn> yarns, const Finish& finish);

}  // namespace weftlight::draft
