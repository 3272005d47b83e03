// Pictures of the draped cloth: drawn by OpenGL without a window, or ray traced; and arrays as picture files.

#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <mutex>

#include "base/text.h"
#include "design/methods.h"
#include "files/design_drape.h"
#include "files/files.h"
#include "gl/open_headless.h"
#include "gl/pipeline.h"
#include "gl/renderer.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "python/texts.h"
#include "render_data/reference_scene.h"
#include "scene/named_views.h"

namespace weftlight::python {

using base::ErrorKind, base::TaskProgress, base::failure, base::message;
using design::Design, design::Scene;
using draft::Face;
using files::Image, files::PixelType;
using gl::Frame, gl::HeadlessContext, gl::upload_once;
using reference::TracedImage;
using render_data::ReferenceScene, render_data::ReferenceView, render_data::StageWatch, render_data::TracedThreads;

namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 16384;

void check_picture(int width, int height) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
    bad_value(fmt::format("width and height are 1 to {} pixels", kMaxSide));
}

/// Simulates the drape of this fabric into the user's cache, if the scene asks for it.
void drape(const Design& design, const TaskProgress& task) {
  if (!design.scene.simulated_drape || !files::can_drape(design) || files::is_draped(design)) return;
  value_of(files::drape_cloth(design, [&task](double share) {
    task.report(static_cast<float>(share), "simulating the drape");
    return !task.stopped();
  }));
}

/// A context of OpenGL and the renderer in it, for one thread at a time.
class Graphics {
 public:
  Graphics() {
    const auto no_window = [] {
      return HeadlessContext::Opened(failure(ErrorKind::kGraphics, "a window is not opened from Python"));
    };
    auto opened = gl::open_headless(no_window);
    if (!opened) throw Failed({ErrorKind::kGraphics, message(opened.error())});
    context_ = std::move(*opened);
    auto made = gl::Renderer::create();
    context_->release();
    renderer_ = value_of(std::move(made));
  }
  ~Graphics() {
    if (!renderer_) return;
    const auto current = context_->make_current();
    renderer_.reset();
    context_.reset();
  }
  Graphics(const Graphics&) = delete;
  Graphics& operator=(const Graphics&) = delete;

  /// The pixels, linear or display-referred.
  Image draw(const Design& design, const Frame& frame, bool linear, const TaskProgress& task) {
    const std::lock_guard lock(mutex_);
    value_of(context_->make_current());
    const Released released{*context_};
    upload(design, task);
    renderer_->draw(design.scene, design.look, frame);
    value_of(renderer_->measure().cloth);
    Image image = renderer_->read_back(linear);
    value_of(renderer_->measure().cloth);
    return image;
  }
  std::string device() {
    const std::lock_guard lock(mutex_);
    value_of(context_->make_current());
    const Released released{*context_};
    return renderer_->device();
  }

 private:
  struct Released {
    HeadlessContext& context;
    ~Released() { context.release(); }
  };

  /// What the renderer has already is not made again.
  void upload(const Design& design, const TaskProgress& task) {
    if (uploaded_ && *uploaded_ == design) return;
    uploaded_.reset();
    drape(design, task);
    auto next = std::make_shared<const Design>(design);
    StageWatch watch{task.stop(), [&task](const char* stage, size_t done, size_t of) {
                       task.report(static_cast<float>(done) / static_cast<float>(of), stage);
                     }};
    value_of(upload_once(next, *renderer_, watch));
    uploaded_ = std::move(next);
  }

  std::mutex mutex_;
  std::unique_ptr<HeadlessContext> context_;
  std::unique_ptr<gl::Renderer> renderer_;
  std::shared_ptr<const Design> uploaded_;
};

/// (height, width, channels): the first channels of the texels.
template <class T, class Convert>
py::array_t<T> pixels_of(const Image& image, int channels, Convert convert) {
  py::array_t<T> out({image.height, image.width, channels});
  T* at = out.mutable_data();
  for (size_t i = 0; i < image.texels.size(); i += static_cast<size_t>(image.channels))
    for (int c = 0; c < channels; ++c) *at++ = convert(image.texels[i + static_cast<size_t>(c)]);
  return out;
}

py::array picture_of(const Image& image, bool linear, bool transparent) {
  const int channels = transparent ? 4 : 3;
  if (linear) return pixels_of<float>(image, channels, [](float v) { return v; });
  return pixels_of<uint8_t>(image, channels,
                            [](float v) { return static_cast<uint8_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f); });
}

struct PictureArguments {
  int width, height;
  Face face;
  float yarns_per_pixel;
  bool linear, transparent;
};

Frame frame_of(const PictureArguments& o) {
  Frame frame;
  frame.width = o.width, frame.height = o.height;
  frame.front = o.face;
  frame.yarns_per_pixel = o.yarns_per_pixel;
  frame.transparent = o.transparent;
  frame.ground = !o.transparent;
  return frame;
}

py::array render(Graphics& graphics, const Design& design, int width, int height, Face face, float yarns_per_pixel,
                 bool linear, bool transparent, const py::object& progress) {
  check_picture(width, height);
  const Frame frame = frame_of({width, height, face, yarns_per_pixel, linear, transparent});
  const Image image =
      long_call(progress, [&](const TaskProgress& task) { return graphics.draw(design, frame, linear, task); });
  return picture_of(image, linear, transparent);
}

std::unique_ptr<Graphics> new_graphics() {
  return long_call(py::none(), [](const TaskProgress&) { return std::make_unique<Graphics>(); });
}

void bind_renderer(py::module_& module) {
  const auto picture = [](auto define) {
    define(py::arg("design"), py::arg("width") = 1280, py::arg("height") = 800, py::kw_only(),
           py::arg("face") = Face::kFront, py::arg("yarns_per_pixel") = 0.0f, py::arg("linear") = false,
           py::arg("transparent") = false, py::arg("progress") = py::none());
  };
  py::class_<Graphics> renderer(module, "Renderer", "Draws many pictures with one context of OpenGL.");
  renderer.def(py::init(&new_graphics)).def_property_readonly("device", [](Graphics& graphics) {
    return unlocked([&] { return graphics.device(); });
  });
  picture([&renderer](auto... arguments) {
    renderer.def("render", &render, arguments..., "A picture of the draped cloth.");
  });
  picture([&module](auto... arguments) {
    module.def(
        "render",
        [](const Design& design, int width, int height, Face face, float yarns_per_pixel, bool linear, bool transparent,
           const py::object& progress) {
          check_picture(width, height);
          return render(*new_graphics(), design, width, height, face, yarns_per_pixel, linear, transparent, progress);
        },
        arguments..., "A picture of the draped cloth.");
  });
}

ReferenceView view_of(const Design& design, int width, int height, int spp, int bounces, Face face, bool fibres,
                      const TaskProgress& task) {
  ReferenceView view;
  view.scene = design.scene;
  view.width = width, view.height = height;
  view.front = face;
  view.spp = spp, view.bounces = bounces;
  view.fibres = fibres;
  view.stop = task.stop();
  return view;
}

TracedImage traced(const Design& design, const ReferenceView& view, const TaskProgress& task) {
  drape(design, task);
  ReferenceScene scene;
  value_of(scene.update(design, {}, view.fibres ? TracedThreads::kFibres : TracedThreads::kTubes));
  if (view.fibres) value_of(scene.prepare_fibres(view));
  return scene.trace(view, [&task](float share) { task.report(share, "tracing"); });
}

/// (height, width, 4), linear and premultiplied.
py::array_t<float> reference_picture(const Design& design, int width, int height, int spp, int bounces, Face face,
                                     bool fibres, const py::object& progress) {
  check_picture(width, height);
  if (spp < 1 || spp > 1 << 20 || bounces < 0) bad_value("spp is 1 to 1048576, bounces are 0 or more");
  const TracedImage image = long_call(progress, [&](const TaskProgress& task) {
    return traced(design, view_of(design, width, height, spp, bounces, face, fibres, task), task);
  });
  py::array_t<float> out({image.height, image.width, 4});
  float* at = out.mutable_data();
  for (const glm::vec4& p : image.pixels) *at++ = p.r, *at++ = p.g, *at++ = p.b, *at++ = p.a;
  return out;
}

PixelType pixel_type(const std::string& depth) {
  constexpr std::array<std::string_view, 4> kNames{"8", "16", "half", "float"};
  for (size_t i = 0; i < kNames.size(); ++i)
    if (depth == kNames[i]) return static_cast<PixelType>(i);
  bad_value(fmt::format("'{}' is not one of '8', '16', 'half', 'float'", depth));
}

/// An array of bytes means 0..255, any other 0..1.
Image image_of(const py::array& given) {
  const bool bytes = given.dtype().kind() == 'u' && given.dtype().itemsize() == 1;
  const Numbers pixels = Numbers::ensure(given);
  if (!pixels) throw py::error_already_set();
  if (pixels.ndim() != 2 && pixels.ndim() != 3) bad_value("pixels have the shape (height, width[, channels])");
  const py::ssize_t channels = pixels.ndim() == 3 ? pixels.shape(2) : 1;
  if (channels < 1 || channels > 4) bad_value("a picture has 1 to 4 channels");
  if (pixels.shape(0) > kMaxSide * 4 || pixels.shape(1) > kMaxSide * 4 || pixels.size() == 0)
    bad_value(fmt::format("a picture has 1 to {} pixels a side", kMaxSide * 4));
  Image image{static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)), static_cast<int>(channels), {}};
  image.texels.assign(pixels.data(), pixels.data() + pixels.size());
  if (bytes)
    for (float& v : image.texels) v /= 255.0f;
  return image;
}

void bind_images(py::module_& module) {
  module.def(
      "write_image",
      [](const fs::path& path, const py::array& pixels, const std::string& depth) {
        const Image image = image_of(pixels);
        const PixelType type = pixel_type(depth);
        unlocked([&] { value_of(files::write_image(path.string(), image, type)); });
      },
      py::arg("path"), py::arg("pixels"), py::arg("depth") = "8", "An array as .png, .jpg, .tif or .exr.");
}

Scene named_view(const Design& design, const std::string& name, int width, int height) {
  check_picture(width, height);
  if (const auto view = scene::view_named(design, name, static_cast<float>(width), static_cast<float>(height)))
    return scene::drawn_scene(*view);
  bad_value(fmt::format("no view is called '{}'; the views are {}", name, fmt::join(scene::view_names(design), ", ")));
}

}  // namespace

void bind_pictures(py::module_& module) {
  bind_renderer(module);
  bind_images(module);
  module.def("reference", &reference_picture, py::arg("design"), py::arg("width") = 1280, py::arg("height") = 800,
             py::kw_only(), py::arg("spp") = 64, py::arg("bounces") = 2, py::arg("face") = Face::kFront,
             py::arg("fibres") = false, py::arg("progress") = py::none(), "The cloth ray traced.");
  module.def("view", &named_view, py::arg("design"), py::arg("name"), py::arg("width") = 1280, py::arg("height") = 800,
             "The scene of a named view.");
}

}  // namespace weftlight::python
