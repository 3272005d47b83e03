#pragma once
// The lobes of a yarn from its fibres. What a yarn sends where follows from fibre, count, twist and hair, which traced
// fibres know; the lobes say the same in a few numbers that are quick to evaluate. They are fitted here, so that the
// threads of a yarn are the far field of its fibres.

#include "base/progress.h"
#include "base/result.h"
#include "design/yarn.h"

namespace weftlight::render_data {

struct FibreLobes {
  design::Lobes lobes;
  /// Root mean square of log2(threads / fibres) over directions and depths of dye, of the given lobes and of the
  /// fitted.
  float octaves_before = 0, octaves = 0;
};

struct FibreFit {
  bool fit_lustre = false;  // the roughness along the fibres, too
  int spp = 8;              // paths in each of 1,024 samples of a swatch, for each direction
  int max_tries = 150;      // lobes that are tried; 0: the difference of the given ones is measured, and they stay
};

/// Fits roughness across, fibre layers, internal scattering and the diffuse part to traced swatches of this yarn alone:
/// plain weave and satin, in three depths of dye each. The mean brightness of threads and fibres is the same by then
/// (reference/fibre_dye.h). The roughness along the fibres stays, since it is the lustre that a weaver sets and that
/// the fibres are traced with (design/fibre_facts.h); so do fuzz, transmission and index. Takes about a minute on two
/// cores; repeatable. An error for metallic yarn, which has no dye, without ray tracing, and of kCancelled.
base::Result<FibreLobes> lobes_of_fibres(const design::Yarn& yarn, const FibreFit& fit = {},
                                         const base::TaskProgress& progress = {});

}  // namespace weftlight::render_data
