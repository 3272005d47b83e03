// Mercerising: the ratios between the two cotton presets (sources in yarn_presets.cpp). Raising: the ratios between a
// woollen yarn and that of flannel. Calendering: W. D. Schindler, P. J. Hauser, Chemical Finishing of
// Textiles, 2004, and descriptions of the trade (threads flattened, gaps closed, surface smoothed and polished); its
// factors are estimates. Bloom: by eye; no published figures by fibre were found.

#include "design/finish.h"

#include <algorithm>
#include <cmath>

#include "design/fibre.h"

namespace weftlight::design {
namespace {

float towards(float from, float to, float degree) { return from + (to - from) * degree; }
float scaled(float value, float factor, float degree) { return value * towards(1, factor, degree); }

void raise(Yarn& y, float degree) {
  Lobes& l = y.lobes;
  l.fuzz = 1 - scaled(1 - l.fuzz, 0.06f, degree);
  l.fuzz_width = towards(l.fuzz_width, std::max(l.fuzz_width, 0.95f), degree);
  l.along_width = scaled(l.along_width, 1.43f, degree);
  l.across_width = scaled(l.across_width, 1.33f, degree);
  // In the nap, fibres of all threads and colours are entangled: no streaks along a thread.
  y.hairiness = scaled(y.hairiness, 0.35f, degree);
  y.melange = scaled(y.melange, 0.2f, degree);
  y.groove_depth = scaled(y.groove_depth, 0.1f, degree);
  y.fibre_um = scaled(y.fibre_um, 0.43f, degree);
  y.flattening = scaled(y.flattening, 0.47f, degree);
}

void mercerise(Yarn& y, float degree) {
  Lobes& l = y.lobes;
  l.along_width = scaled(l.along_width, 0.53f, degree);
  l.layers = scaled(l.layers, 1.33f, degree);
  l.inner = scaled(l.inner, 1.2f, degree);
  l.fuzz = scaled(l.fuzz, 0.5f, degree);
  l.fuzz_width = scaled(l.fuzz_width, 0.82f, degree);
  y.hairiness = scaled(y.hairiness, 0.29f, degree);
  y.groove_depth = scaled(y.groove_depth, 0.78f, degree);
  y.fibre_um = scaled(y.fibre_um, 0.67f, degree);
  y.flattening = scaled(y.flattening, 1.07f, degree);
}

void calender(Yarn& y, float degree) {
  Lobes& l = y.lobes;
  l.along_width = scaled(l.along_width, 0.5f, degree);
  l.across_width = scaled(l.across_width, 0.6f, degree);
  l.layers = scaled(l.layers, 1.5f, degree);
  l.fuzz = scaled(l.fuzz, 0.15f, degree);
  y.hairiness = scaled(y.hairiness, 0.3f, degree);
  y.groove_depth = scaled(y.groove_depth, 0.4f, degree);
  y.flattening = scaled(y.flattening, 0.5f, degree);
}

}  // namespace

Finish clamped(Finish finish) {
  for (const YarnField<Finish>& f : kFinishFields) {
    float& value = finish.*f.member;
    value = std::isnan(value) ? Finish{}.*f.member : std::clamp(value, f.facts.low, f.facts.high);
  }
  return finish;
}

float bloom(const Yarn& yarn) {
  const float loose = static_cast<float>(1 - packing_fraction(yarn));
  // A yarn opens by its loft and by its hair: a woollen by a seventh, filament hardly.
  return 1 + std::clamp(0.25f * loose * yarn.hairiness, 0.0f, 0.3f);
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

}  // namespace weftlight::design
