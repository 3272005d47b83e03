#pragma once
// What a pixel that holds many texels needs to know of them: for each system of threads how much it
// covers, its mean colour, and mean and spread of its slopes; for each azimuth mean and spread of the horizon.
// A woven normal distribution has two peaks of two colours, so warp and weft are never averaged together.
//
// Based on: M. Olano, D. Baker, LEAN Mapping, 2010 (first and second moments of slopes filter linearly).
// Differs: one set a system, each multiplied by its coverage.

#include <array>
#include <vector>

#include "cloth/maps.h"
#include "cloth/names.h"

namespace weftlight::cloth {

/// Moments are stored multiplied by the share of the texel that the system covers (kWeight), so that any
/// linear filter (mips, a texture unit) keeps all means. Colour is linear and has the grooves in it.
enum MomentPlane { kWeight, kRed, kGreen, kBlue, kSlopeX, kSlopeY, kSlopeXX, kSlopeXY, kSlopeYY, kMomentPlanes };
using SystemMoments = std::array<Plane<float>, kMomentPlanes>;

struct MomentLevel {
  int width = 0, height = 0;
  SystemMoments warp, weft;
  // Horizon of azimuth k as in Maps: mean sine and its standard deviation over what is covered, unorm8.
  std::vector<Plane<uint8_t>> horizon, horizon_spread;
};

/// Levels from width x height (at most the maps' size) down to 1 x 1, each side halved and rounded down.
/// The surface is sampled from the cloth, the horizons come from the maps. The mean over a level is the
/// same on every level, and the levels wrap without a seam.
std::vector<MomentLevel> moments(const Cloth& cloth, const Maps& maps, int width, int height, int threads = 0);

/// One system in one texel, divided by its weight; all zero where it covers nothing.
struct Facet {
  float weight = 0;  // 0..1
  Linear colour;
  Slope slope;                   // mean
  float xx = 0, xy = 0, yy = 0;  // covariance of the slope, positive semi-definite
};
Facet facet_at(const SystemMoments& moments, int x, int y);

/// Area average of a periodic plane in fewer texels; sizes need not divide.
Plane<float> averaged(const Plane<float>& in, int width, int height);

}  // namespace weftlight::cloth
