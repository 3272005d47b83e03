#pragma once
// The tables that the formulas read: albedos of Gaussian facets and of the fuzz layer. They do not depend on the
// design; they are computed once, in milliseconds, and uploaded as float textures.

#include <cstddef>
#include <vector>

namespace weftlight::light {

/// A regular grid over 0..1 in each axis, entries at both ends; x runs fastest, channels inside.
struct Table {
  int nx = 1, ny = 1, nz = 1, channels = 1;
  std::vector<float> values;
  Table() = default;
  Table(int x, int y, int z, int channels_)
      : nx(x),
        ny(y),
        nz(z),
        channels(channels_),
        values(static_cast<size_t>(x) * static_cast<size_t>(y) * static_cast<size_t>(z) *
               static_cast<size_t>(channels_)) {}
  float* at(int x, int y, int z = 0) {
    return values.data() +
           ((static_cast<size_t>(z) * static_cast<size_t>(ny) + static_cast<size_t>(y)) * static_cast<size_t>(nx) +
            static_cast<size_t>(x)) *
               static_cast<size_t>(channels);
  }
  const float* at(int x, int y, int z = 0) const { return const_cast<Table*>(this)->at(x, y, z); }
};

/// The entry below a coordinate among n >= 2 entries, 0..n-2, and the weight t of the next one. Coordinates are
/// clamped to 0..1; NaN is 0.
struct TableCell {
  int i;
  float t;
};
inline TableCell cell_of(float coordinate, int n) {
  const float above = coordinate > 0 ? coordinate : 0;
  const float x = (above < 1 ? above : 1) * static_cast<float>(n - 1);
  const float last = static_cast<float>(n - 2);
  const int i = static_cast<int>(x < last ? x : last);
  return {i, x - static_cast<float>(i)};
}

/// Axes: along, across, major, minor, depth = x / (1 + x) of an RMS slope or an optical depth;
/// opening = sqrt(mu / rim), rim = mu + sine * along: even where the masking of a view changes.
struct LightTables {
  // RGBA over (opening, along, across): the loss of single scattering with F = 1, and the cosine c over rim for which
  // (1 - c)^5 is the mean of (1 - wi.h)^5; for slopes along and across that are independent (RG) and fully correlated
  // (BA).
  Table albedo;
  // RG over (major, minor): cosine-weighted means of the loss, over v / (1 + v) for the mean variance v, and of the
  // albedo times (1 - wi.h)^5.
  Table albedo_mean;
  // RGBA over (mu / (mu + depth), depth): single scattering; loss of single scattering over a white body;
  // transmittance of diffuse light; mean of the loss.
  Table fuzz;
};

/// Computes the tables on `threads` threads (0: one a core); the result does not depend on it.
LightTables make_light_tables(int threads = 0);

/// The tables, computed at the first call (thread-safe).
const LightTables& light_tables();

}  // namespace weftlight::light
