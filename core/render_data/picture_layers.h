#pragma once
// A traced picture with what compositing needs: depth, normal, place on the cloth, thread, colour, and direct and
// indirect light, as channels of one .exr.

#include <string>
#include <vector>

#include "files/files.h"
#include "reference/picture.h"

namespace weftlight::render_data {

using files::Image;
using reference::TracedImage;

/// Names of the channels of with_layers(): R, G, B, A, then the layers by the names that compositing programs group by,
/// in the order in which they are read again.
const std::vector<std::string>& layer_channels();

/// `picture`: linear, with alpha, the cloth in it (lay_over()), of the size of `traced`, which has layers. Lengths are
/// in mm, numbers of ends (thread.X) and picks (thread.Y) begin with 1; layers are 0 where there is no cloth. Direct
/// and indirect light are as bright as the picture.
Image with_layers(const Image& picture, const TracedImage& traced, float exposure_ev);

}  // namespace weftlight::render_data
