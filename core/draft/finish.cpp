// Mercerising: what parts the two ready yarns of cotton, as factors (yarn_presets.cpp has their sources). Raising: the
// same between a woollen yarn and flannel's. Calendering: W. D. Schindler, P. J. Hauser, Chemical Finishing of
// Textiles, 2004, and the trade's descriptions (threads flattened, gaps closed, surface smoothed and polished); its
// figures are by eye.

#include "draft/finish.h"

#include <algorithm>
#include <cmath>

namespace weftlight::draft {
namespace {

float towards(float from, float to, float share) { return from + (to - from) * share; }
float scaled(float value, float factor, float share) { return value * towards(1, factor, share); }

void raise(Yarn& y, float share) {
  Lobes& l = y.lobes;
  l.fuzz = 1 - scaled(1 - l.fuzz, 0.06f, share);
  l.fuzz_width = towards(l.fuzz_width, std::max(l.fuzz_width, 0.95f), share);
  l.along_width = scaled(l.along_width, 1.43f, share);
  l.across_width = scaled(l.across_width, 1.33f, share);
  // In the nap fibres of all threads and colours lie in a tangle: no streaks along a thread.
  y.hairiness = scaled(y.hairiness, 0.35f, share);
  y.melange = scaled(y.melange, 0.2f, share);
  y.groove_depth = scaled(y.groove_depth, 0.1f, share);
  y.fibre_um = scaled(y.fibre_um, 0.43f, share);
  y.flattening = scaled(y.flattening, 0.47f, share);
}

void mercerise(Yarn& y, float share) {
  Lobes& l = y.lobes;
  l.along_width = scaled(l.along_width, 0.53f, share);
  l.layers = scaled(l.layers, 1.33f, share);
  l.inner = scaled(l.inner, 1.2f, share);
  l.fuzz = scaled(l.fuzz, 0.5f, share);
  l.fuzz_width = scaled(l.fuzz_width, 0.82f, share);
  y.hairiness = scaled(y.hairiness, 0.29f, share);
  y.groove_depth = scaled(y.groove_depth, 0.78f, share);
  y.fibre_um = scaled(y.fibre_um, 0.67f, share);
  y.flattening = scaled(y.flattening, 1.07f, share);
}

void calender(Yarn& y, float share) {
  Lobes& l = y.lobes;
  l.along_width = scaled(l.along_width, 0.5f, share);
  l.across_width = scaled(l.across_width, 0.6f, share);
  l.layers = scaled(l.layers, 1.5f, share);
  l.fuzz = scaled(l.fuzz, 0.15f, share);
  y.hairiness = scaled(y.hairiness, 0.3f, share);
  y.groove_depth = scaled(y.groove_depth, 0.4f, share);
  y.flattening = scaled(y.flattening, 0.5f, share);
}

}  // namespace

Finish clamped(Finish finish) {
  for (const YarnField<Finish>& f : kFinishFields) {
    float& value = finish.*f.member;
    value = std::isnan(value) ? 0 : std::clamp(value, f.facts.low, f.facts.high);
  }
  return finish;
}

Yarn finished(Yarn yarn, const Finish& any) {
  const Finish finish = clamped(any);
  if (finish == Finish{}) return yarn;
  if (finish.mercerised > 0) mercerise(yarn, finish.mercerised);
  if (finish.raised > 0) raise(yarn, finish.raised);
  if (finish.calendered > 0) calender(yarn, finish.calendered);
  return clamped(yarn);
}

std::vector<Yarn> finished(std::vector<Yarn> yarns, const Finish& finish) {
  for (Yarn& yarn : yarns) yarn = finished(std::move(yarn), finish);
  return yarns;
}

}  // namespace weftlight::draft
