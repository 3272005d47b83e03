#pragma once
// Finishing of the cloth, and its effect on the yarns.

#include <array>
#include <vector>

#include "base/mark.h"
#include "design/yarn.h"
#include "design/yarn_fields.h"

namespace weftlight::design {

/// Degree of each finish, 0..1; they may be combined.
struct Finish {
  float raised = 0;      // raised to a nap by wire teeth
  float mercerised = 0;  // swollen in lye under tension: rounder, smoother, more lustrous
  float calendered = 0;  // pressed between heavy rollers: flat, shiny threads
  float washed = 1;      // 0: as it comes off the loom; 1: washed and dried, at the sett of the draft
  bool operator==(const Finish&) const = default;
};

inline constexpr std::array<YarnField<Finish>, 4> kFinishFields{{
    {{"Washed", "washed", base::mark("Washed"), "", 2, 0, 1, 0, 1, false,
      base::mark("From the loom, wider and thinner, to washed: it shrinks as planned, threads bloom, waffles form"),
      "1: the draft's sett is that of the finished cloth; shrinkage is that of the plan; bloom and relief by eye"},
     &Finish::washed},
    {{"Raised", "raised", base::mark("Raised"), "", 2, 0, 1, 0, 1, false,
      base::mark("Brushed to a nap that hides the weave: flannel, blankets"),
      "1: the flannel of presets/cloths, by eye beside milled cloth"},
     &Finish::raised},
    {{"Mercerised", "mercerised", base::mark("Mercerised"), "", 2, 0, 1, 0, 1, false,
      base::mark("Cotton swollen in lye under tension: rounder, smoother, more lustrous"),
      "1: the step from the yarn preset Cotton to Mercerised cotton"},
     &Finish::mercerised},
    {{"Calendered", "calendered", base::mark("Calendered"), "", 2, 0, 1, 0, 1, false,
      base::mark("Pressed between heavy rollers: threads lie flat and shine, as in chintz"),
      "1: friction-calendered; threads to half their height, Peirce 1937's range of flattening and below; by eye"},
     &Finish::calendered},
}};

/// Each value clamped to its range; NaN becomes the default.
Finish clamped(Finish finish);

/// The yarn as it is in the finished cloth; unchanged, bit for bit, without any finish. Its thickness is not changed
/// (bloom).
Yarn finished(Yarn yarn, const Finish& finish);
std::vector<Yarn> finished(std::vector<Yarn> yarns, const Finish& finish);

/// How much thicker a yarn of this fibre is in the washed cloth than on the loom: 1.04 is four percent.
float bloom(const Yarn& yarn);

}  // namespace weftlight::design
