#include "files/environment.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <new>
#include <numbers>

#include "base/caught.h"
#include "base/text.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::failed, base::failure, base::fill, base::tr, base::tr_n;

namespace {

constexpr int kMaxWidth = 32768;
constexpr int kBandRows = 32;
constexpr float kMaxRadiance = 1e7f;  // the disc of the sun is about 1e5 times as bright as the sky

/// The channels with the radiance: R, G, B by name, otherwise the first three, otherwise a single one for all.
struct Channels {
  int first = 0, count = 3;
  std::array<int, 3> rgb{0, 1, 2};  // relative to `first`
};

Channels channels_of(const OIIO::ImageSpec& spec) {
  if (spec.nchannels < 3) return {0, 1, {0, 0, 0}};
  std::array<int, 3> at{0, 1, 2};
  constexpr std::array<const char*, 3> kNames{"R", "G", "B"};
  for (size_t k = 0; k < 3; ++k) {
    const int named = spec.channelindex(kNames[k]);
    if (named < 0) return {};
    at[k] = named;
  }
  const auto [low, high] = std::minmax_element(at.begin(), at.end());
  return {*low, *high - *low + 1, {at[0] - *low, at[1] - *low, at[2] - *low}};
}

/// Whether a picture with this header can be light.
Result<void> check_header(const std::string& path, const std::string& format, const OIIO::ImageSpec& spec) {
  const auto rejected = [&path](std::string text) { return failure(ErrorKind::kInput, std::move(text), path); };
  const auto with_size = [&](const char* text) {
    return rejected(fill(text, arg("width", spec.width), arg("height", spec.height)));
  };
  if (format != "hdr" && format != "openexr")
    return rejected(tr("holds no light brighter than white; give an .hdr or an .exr"));
  if (spec.deep) return rejected(tr("is a deep picture; save it as a flat one"));
  if (spec.width < 4 || spec.height < 2 || spec.depth > 1 || spec.nchannels < 1)
    return with_size(tr("is {width} x {height}; give a picture of at least 4 x 2"));
  if (spec.width > kMaxWidth) return with_size(tr("is {width} x {height}; scale it down to at most 32768 x 16384"));
  if (spec.width != 2 * spec.height)
    return with_size(tr("is {width} x {height}; give an equirectangular picture, twice as wide as high"));
  if (spec.nchannels > 64)
    return rejected(fill(tr("has {count} channels; save it with R, G and B only"), arg("count", spec.nchannels)));
  return {};
}

/// Averages the texels of the source into those of the result.
class TexelAverager {
 public:
  TexelAverager(int width, int height)
      : width_(width),
        height_(height),
        image_{std::min(width, kEnvironmentWidth), std::min(height, kEnvironmentWidth / 2), 3, {}} {
    const size_t texels = static_cast<size_t>(image_.width) * static_cast<size_t>(image_.height);
    image_.texels.resize(3 * texels);
    sums_.resize(4 * texels);
  }

  void add_row(int y, const float* texels, const Channels& channels) {
    const double step = std::numbers::pi / height_;
    const double solid_angle = std::cos(y * step) - std::cos((y + 1) * step);
    const size_t row = static_cast<size_t>(int64_t{y} * image_.height / height_) * static_cast<size_t>(image_.width);
    for (int x = 0; x < width_; ++x, texels += channels.count) {
      double* to = &sums_[4 * (row + static_cast<size_t>(int64_t{x} * image_.width / width_))];
      for (size_t k = 0; k < 3; ++k)
        to[k] += solid_angle * static_cast<double>(valid_radiance(texels[channels.rgb[k]]));
      to[3] += solid_angle;
    }
  }
  Image picture() {
    for (size_t i = 0; i < sums_.size() / 4; ++i)
      for (size_t k = 0; k < 3; ++k) {
        image_.texels[3 * i + k] = static_cast<float>(sums_[4 * i + k] / std::max(sums_[4 * i + 3], 1e-30));
        lit_ = lit_ || image_.texels[3 * i + k] > 0;
      }
    return std::move(image_);
  }
  int64_t invalid() const { return invalid_; }  // below 0 or not a number
  int64_t too_bright() const { return too_bright_; }
  bool lit() const { return lit_; }

 private:
  float valid_radiance(float value) {
    if (!(value >= 0)) return ++invalid_, 0.0f;
    if (value > kMaxRadiance) return ++too_bright_, kMaxRadiance;
    return value;
  }

  int width_, height_;
  Image image_;
  std::vector<double> sums_;  // r, g, b, weight
  int64_t invalid_ = 0, too_bright_ = 0;
  bool lit_ = false;
};

/// Reads the rows from y to end, only these channels.
bool read_rows(OIIO::ImageInput& in, int y, int end, const Channels& c, std::vector<float>& rows) {
  const OIIO::ImageSpec& s = in.spec();
  const int last = c.first + c.count;
  if (s.tile_width == 0)
    return in.read_scanlines(0, 0, s.y + y, s.y + end, 0, c.first, last, OIIO::TypeDesc::FLOAT, rows.data());
  return in.read_tiles(0, 0, s.x, s.x + s.width, s.y + y, s.y + end, 0, 1, c.first, last, OIIO::TypeDesc::FLOAT,
                       rows.data());
}

/// The file, with a header that can be used.
Result<std::unique_ptr<OIIO::ImageInput>> open(const std::string& path) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(path, ec))
    return failure(ErrorKind::kInput, tr("no such file; choose another picture"), path);
  std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path);
  if (!in)
    return failure(ErrorKind::kInput,
                   fill(tr("{problem}; give an undamaged .hdr or .exr"), arg("problem", OIIO::geterror())), path);
  if (const Result<void> header = check_header(path, in->format_name(), in->spec()); !header) return failed(header);
  return in;
}

/// What OpenImageIO threw.
base::Failure broken_file(const std::string& path, const std::string& problem) {
  return failure(ErrorKind::kInput, fill(tr("{problem}; the file is damaged"), arg("problem", problem)), path);
}

Result<EnvironmentPicture> read_from(const std::string& path) {
  Result<std::unique_ptr<OIIO::ImageInput>> opened = open(path);
  if (!opened) return failed(opened);
  const std::unique_ptr<OIIO::ImageInput> in = std::move(*opened);
  const OIIO::ImageSpec& spec = in->spec();
  const Channels channels = channels_of(spec);
  // Tiles are read in whole rows of tiles.
  constexpr int64_t kMaxValues = int64_t{1} << 26;  // 256 MB
  const int band = std::min(spec.tile_height > 0 ? spec.tile_height : kBandRows, spec.height);
  const int64_t values = int64_t{spec.width} * band * channels.count;
  if (values > kMaxValues)
    return failure(ErrorKind::kInput, tr("its tiles are too large; save it with scan lines"), path);
  std::vector<float> rows(static_cast<size_t>(values));
  TexelAverager averager(spec.width, spec.height);
  for (int y = 0; y < spec.height; y += band) {
    const int end = std::min(y + band, spec.height);
    if (!read_rows(*in, y, end, channels, rows))
      return failure(ErrorKind::kInput,
                     fill(tr("unreadable from row {row}: {problem}; the file is damaged"), arg("row", y + 1),
                          arg("problem", in->geterror())),
                     path);
    const size_t row = static_cast<size_t>(spec.width) * static_cast<size_t>(channels.count);
    for (int k = y; k < end; ++k) averager.add_row(k, &rows[static_cast<size_t>(k - y) * row], channels);
  }
  EnvironmentPicture read{averager.picture(), {}};
  if (!averager.lit()) return failure(ErrorKind::kInput, tr("is black everywhere; there is no light in it"), path);
  if (averager.invalid() > 0)
    read.remarks.push_back(
        fill(tr_n("{file}: {count} value is below 0 or not a number; taken as 0",
                  "{file}: {count} values are below 0 or not numbers; taken as 0", averager.invalid()),
             arg("file", path), arg("count", averager.invalid())));
  if (averager.too_bright() > 0)
    read.remarks.push_back(fill(tr_n("{file}: {count} value is above 1e7; taken as 1e7",
                                     "{file}: {count} values are above 1e7; taken as 1e7", averager.too_bright()),
                                arg("file", path), arg("count", averager.too_bright())));
  return read;
}

}  // namespace

Result<EnvironmentPicture> read_environment(const std::string& path) {
  try {
    return read_from(path);
  } catch (const std::bad_alloc&) {
    return failure(ErrorKind::kMemory, tr(base::kNoMemory), path);
  } catch (const std::exception& e) {
    return broken_file(path, e.what());
  }
}

Result<void> check_environment(const std::string& path) {
  try {
    const Result<std::unique_ptr<OIIO::ImageInput>> opened = open(path);
    if (!opened) return failed(opened);
    return {};
  } catch (const std::exception& e) {
    return broken_file(path, e.what());
  }
}

}  // namespace weftlight::files
