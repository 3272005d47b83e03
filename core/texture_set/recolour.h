#pragma once
// What a set adds for an artist who recolours the cloth in another program: the base colour of white yarn, which system
// of threads and which colour of the draft each texel shows, and the list of these colours. In linear light,
//   base colour = white_scale x white x sum over the colours of share x colour.

#include <string>
#include <vector>

#include "base/json.h"
#include "design/design.h"
#include "files/files.h"
#include "texture_set/set_images.h"

namespace weftlight::texture_set {

using design::Design;
using draft::Rgb;
using files::Image;

inline constexpr size_t kMaxIndexedColors = 256;  // an index is a byte
inline constexpr size_t kMaxSharedColors = 12;    // more have an index, but no images of shares

/// A colour of the threads in the tile. Its place in the list is its index.
struct ClothColor {
  Linear linear;
  Rgb color;
  int palette = 0;                 // first entry of the draft's palette with this colour
  std::vector<std::string> yarns;  // names of the yarns that have it
  int ends = 0, picks = 0;         // in the tile
};
/// In the order of the palette.
std::vector<ClothColor> colors_of(const Design& design, const Cloth& cloth);

/// An 8-bit PNG for recolouring.
struct RecolourImage {
  std::string suffix;
  bool srgb = false;
  std::vector<std::string> channels;  // descriptions
  bool exact = false;                 // numbers that mean nothing between two texels
};
/// white, threads, index, and of few enough colours their shares, three to an image.
std::vector<RecolourImage> recolour_images(size_t colors);
std::string recolour_file(const ExportTarget& target, const RecolourImage& image, const std::string& name, Face face);

/// Makes these images of a face, band by band and at any size. The bits do not depend on the bands.
class RecolourSource {
 public:
  /// `source` outlives it.
  RecolourSource(const FaceSource& source, const std::vector<ClothColor>& colors);
  /// Rows [y0, y1) of all images at this size, as in the files; computed on the caller's thread only.
  std::vector<Image> rows(TextureSize size, int y0, int y1) const;
  /// By which the stored white is to be multiplied, at least 1: threads of dark cloth, of which the fit wants more
  /// light than they scatter, would be beyond 1 in white.
  float white_scale() const { return white_scale_; }

 private:
  /// What one texel shows, from a block of the maps.
  struct Texel {
    glm::vec3 white{0};
    float warp = 0, coverage = 0;
    std::vector<float> shares;  // by colour, sum 1
  };
  template <class Use>
  void for_each_texel(TextureSize size, int y0, int y1, const Use& use) const;
  void sum_up(Texel& texel, const Maps& maps, int x, int y, int block) const;
  glm::vec3 scattered(const cloth::ThreadBody& body) const;
  float most_white() const;
  float measured_white() const;
  void put(std::vector<Image>& images, size_t at, const Texel& texel) const;

  const FaceSource& source_;
  Cloth grey_;                             // the same cloth in one colour
  std::array<std::vector<int>, 2> color_;  // by system, then by thread
  size_t colors_ = 0;
  float white_scale_ = 1;
};

/// Writes the images of a face and records them.
base::Result<void> write_recolour_images(SetImages& set, const FaceSource& source,
                                         const std::vector<ClothColor>& colors, Face face);
/// For texture_set.json.
nlohmann::json recolour_json(const std::vector<ClothColor>& colors, const SetImages& set);

}  // namespace weftlight::texture_set
