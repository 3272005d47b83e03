#include "files/environment.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace weftlight::files {
namespace {

constexpr int kWidest = 32768;
constexpr int kBandRows = 32;
constexpr float kBrightest = 1e7f;  // the sun's disc is some 1e5 times as bright as the sky around

/// Which channels hold the light: R, G, B by name, else the first three, else one for all.
struct Channels {
  int first = 0, count = 3;
  std::array<int, 3> of{0, 1, 2};  // from `first`
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

std::string refused(const std::string& format, const OIIO::ImageSpec& spec) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
  if (format != "hdr" && format != "openexr") return "holds no light beyond white; give an .hdr or an .exr";
  if (spec.deep) return "is a deep picture; save it as a flat one";
  if (spec.width < 4 || spec.height < 2 || spec.depth > 1 || spec.nchannels < 1)
    return "is " + size + "; give a picture of at least 4 x 2";
  if (spec.width > kWidest) return "is " + size + "; scale it down to at most 32768 x 16384";
  if (spec.width != 2 * spec.height) return "is " + size + "; give an equirectangular picture, twice as wide as high";
  if (spec.nchannels > 64) return "has " + std::to_string(spec.nchannels) + " channels; save it with R, G, B alone";
  return {};
}

/// Sums of the source's texels in those that are kept.
class Gather {
 public:
  Gather(int width, int height)
      : width_(width),
        height_(height),
        image_{std::min(width, kEnvironmentWidth), std::min(height, kEnvironmentWidth / 2), 3, {}} {
    const size_t texels = static_cast<size_t>(image_.width) * static_cast<size_t>(image_.height);
    image_.texels.resize(3 * texels);
    sums_.resize(4 * texels);
  }

  void add_row(int y, const float* texels, const Channels& channels) {
    const double step = std::numbers::pi / height_;
    const double covers = std::cos(y * step) - std::cos((y + 1) * step);
    const size_t row = static_cast<size_t>(int64_t{y} * image_.height / height_) * static_cast<size_t>(image_.width);
    for (int x = 0; x < width_; ++x, texels += channels.count) {
      double* to = &sums_[4 * (row + static_cast<size_t>(int64_t{x} * image_.width / width_))];
      for (size_t k = 0; k < 3; ++k) to[k] += covers * static_cast<double>(light_of(texels[channels.of[k]]));
      to[3] += covers;
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
  int64_t dark() const { return dark_; }
  int64_t dazzling() const { return dazzling_; }
  bool lit() const { return lit_; }

 private:
  float light_of(float value) {
    if (!(value >= 0)) return ++dark_, 0.0f;
    if (value > kBrightest) return ++dazzling_, kBrightest;
    return value;
  }

  int width_, height_;
  Image image_;
  std::vector<double> sums_;  // r, g, b, weight
  int64_t dark_ = 0, dazzling_ = 0;
  bool lit_ = false;
};

/// Rows y to end, of the channels alone.
bool read_rows(OIIO::ImageInput& in, int y, int end, const Channels& c, std::vector<float>& rows) {
  const OIIO::ImageSpec& s = in.spec();
  const int last = c.first + c.count;
  if (s.tile_width == 0)
    return in.read_scanlines(0, 0, s.y + y, s.y + end, 0, c.first, last, OIIO::TypeDesc::FLOAT, rows.data());
  return in.read_tiles(0, 0, s.x, s.x + s.width, s.y + y, s.y + end, 0, 1, c.first, last, OIIO::TypeDesc::FLOAT,
                       rows.data());
}

/// Null with `error` set when the head refuses it.
std::unique_ptr<OIIO::ImageInput> open(const std::string& path, std::string& error) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(path, ec)) {
    error = path + ": no such file; choose another picture";
    return nullptr;
  }
  std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path);
  if (!in) error = path + ": " + OIIO::geterror() + "; give an .hdr or an .exr that is whole";
  else if (const std::string why = refused(in->format_name(), in->spec()); !why.empty()) error = path + ": " + why;
  return error.empty() ? std::move(in) : nullptr;
}

ReadEnvironment read_from(const std::string& path) {
  std::string error;
  const std::unique_ptr<OIIO::ImageInput> in = open(path, error);
  if (!in) return {{}, error, {}};
  const OIIO::ImageSpec& spec = in->spec();
  const Channels channels = channels_of(spec);
  // Tiles are read in whole rows of them.
  constexpr int64_t kMaxValues = int64_t{1} << 26;  // 256 MB
  const int band = std::min(spec.tile_height > 0 ? spec.tile_height : kBandRows, spec.height);
  const int64_t values = int64_t{spec.width} * band * channels.count;
  if (values > kMaxValues) return {{}, path + ": its tiles are too large; save it in scan lines", {}};
  std::vector<float> rows(static_cast<size_t>(values));
  Gather gather(spec.width, spec.height);
  for (int y = 0; y < spec.height; y += band) {
    const int end = std::min(y + band, spec.height);
    if (!read_rows(*in, y, end, channels, rows))
      return {{}, path + ": row " + std::to_string(y + 1) + " and on: " + in->geterror() + "; the file is broken", {}};
    const size_t row = static_cast<size_t>(spec.width) * static_cast<size_t>(channels.count);
    for (int k = y; k < end; ++k) gather.add_row(k, &rows[static_cast<size_t>(k - y) * row], channels);
  }
  ReadEnvironment read{gather.picture(), {}, {}};
  if (!gather.lit()) return {{}, path + ": is black all over; there is no light in it", {}};
  if (gather.dark() > 0)
    read.remarks.push_back(path + ": " + std::to_string(gather.dark()) + " values below 0 or no numbers; taken as 0");
  if (gather.dazzling() > 0)
    read.remarks.push_back(path + ": " + std::to_string(gather.dazzling()) + " values above 1e7; taken as 1e7");
  return read;
}

}  // namespace

ReadEnvironment read_environment(const std::string& path) {
  try {
    return read_from(path);
  } catch (const std::exception& e) {
    return {{}, path + ": " + e.what() + "; the file is broken", {}};
  }
}

std::string environment_problem(const std::string& path) {
  std::string error;
  try {
    open(path, error);
  } catch (const std::exception& e) {
    error = path + ": " + e.what() + "; the file is broken";
  }
  return error;
}

}  // namespace weftlight::files
