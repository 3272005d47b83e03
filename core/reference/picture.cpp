#include "reference/picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/loops.h"
#include "reference/fibre_trace.h"

namespace weftlight::reference {

using base::for_each_job;

namespace {

constexpr int kMaxLayers = 8;            // of cloth behind cloth, through gaps
constexpr float kEnterThicknesses = 30;  // distance before a point, in thicknesses, at which a ray enters the cloth

/// Runs row(y) for every row on `threads` threads (0: all cores). Each pixel has its own seed, so the result does not
/// depend on them.
void each_row(int height, int threads, const std::stop_token& stop, const Progress& progress,
              const std::function<void(int)>& row) {
  std::atomic<int> done{0};
  std::mutex telling;
  for_each_job(height, threads, [&](int y) {
    if (stop.stop_requested()) return;
    row(y);
    const int finished = ++done;
    if (!progress) return;
    const std::lock_guard lock(telling);
    progress(static_cast<float>(finished) / static_cast<float>(height));
  });
}

/// Steps between the seeds of one pixel.
constexpr uint64_t kOtherSeed = 0xA24BAED4963EE407u;

uint64_t seed_of(int x, int y, int width) {
  return (static_cast<uint64_t>(y) * static_cast<uint64_t>(width) + static_cast<uint64_t>(x)) * 0x9E3779B97F4A7C15u + 1;
}

/// Local frame of a point of the drape.
struct LocalFrame {
  const MeshHit& hit;
  glm::vec3 to(glm::vec3 w) const { return {glm::dot(w, hit.weft), glm::dot(w, hit.warp), glm::dot(w, hit.normal)}; }
  glm::vec3 from(glm::vec3 l) const { return hit.weft * l.x + hit.warp * l.y + hit.normal * l.z; }
};

/// Interpolated normals may face away from an eye that still sees the triangle, at the silhouette of every fold: the
/// ray would then see the other face, or start inside a thread. They are tilted towards the eye until the cosine
/// exceeds what a ray needs that enters this far away.
void lean_to(MeshHit& hit, glm::vec3 direction) {
  constexpr float kMin = 1.1f / kEnterThicknesses;
  const float side = hit.front ? -1.0f : 1.0f, cosine = side * glm::dot(hit.normal, direction);
  if (cosine >= kMin) return;
  hit.normal = glm::normalize(hit.normal + direction * (side * (kMin - cosine)));
  hit.weft = glm::normalize(hit.weft - hit.normal * glm::dot(hit.weft, hit.normal));
  hit.warp = glm::cross(hit.normal, hit.weft);
}

/// One sample of the radiance along a ray through the flat cloth; last, its size on the cloth in mm.
using TraceRay = std::function<PathSample(glm::vec3, glm::vec3, const Surroundings&, RandomStream&, float)>;

/// Samples of a pixel of the finest preview (shaders/lattice.glsl): fibres are resolved as it resolves them.
constexpr float kSamplesOfAPixel = 34;

TraceRay ray_among(const ClothTracer& tracer, int bounces) {
  return [&tracer, bounces](glm::vec3 origin, glm::vec3 direction, const Surroundings& around, RandomStream& random,
                            float sample_mm) {
    return tracer.trace(origin, direction, 0, around, random, bounces, sample_mm);
  };
}

TraceRay ray_among(const FibreTracer& tracer) {
  return [&tracer](glm::vec3 origin, glm::vec3 direction, const Surroundings& around, RandomStream& random, float) {
    return tracer.trace(origin, direction, 0, around, random);
  };
}

/// Direction of the ray through a position on the picture, in pixels.
glm::vec3 ray_through(const DrapePicture& picture, glm::vec2 p) {
  const glm::vec4 far = picture.clip_to_world * glm::vec4(2 * p.x / static_cast<float>(picture.width) - 1,
                                                          1 - 2 * p.y / static_cast<float>(picture.height), 1, 1);
  return glm::normalize(glm::vec3(far) / far.w - picture.eye);
}

glm::vec2 middle_of(const DrapePicture& picture) { return 0.5f * glm::vec2(picture.width, picture.height); }

glm::vec3 axis_of(const DrapePicture& picture) { return ray_through(picture, middle_of(picture)); }

/// Angle of a pixel in the middle of the picture.
float pixel_angle(const DrapePicture& picture) {
  return glm::length(ray_through(picture, middle_of(picture) + glm::vec2(0, 1)) - axis_of(picture));
}

/// One sample of a pixel; its layers have a thread where the light's alpha is 1.
struct SeenSample {
  glm::vec4 light{0};
  PixelLayers layers;
};

/// The layers of a pixel from those of its samples.
class LayerSums {
 public:
  void add(const SeenSample& sample) {
    sum_.direct += sample.layers.direct;
    if (sample.light.a == 0) return;
    if (hits_++ == 0) sum_.uv_mm = sample.layers.uv_mm;
    sum_.depth_mm += sample.layers.depth_mm;
    sum_.normal += sample.layers.normal;
    sum_.albedo += sample.layers.albedo;
    vote(sample.layers);
  }
  PixelLayers mean(int samples) const {
    PixelLayers out = sum_;
    out.direct /= static_cast<float>(samples);
    if (hits_ == 0) return out;
    out.depth_mm /= static_cast<float>(hits_), out.albedo /= static_cast<float>(hits_);
    const float length = glm::length(out.normal);
    if (length > 0) out.normal /= length;
    return out;
  }

 private:
  /// The majority, if there is one (Boyer, Moore 1981).
  void vote(const PixelLayers& one) {
    if (votes_ == 0) sum_.system = one.system, sum_.thread = one.thread;
    votes_ += sum_.system == one.system && sum_.thread == one.thread ? 1 : -1;
  }
  PixelLayers sum_;
  int hits_ = 0, votes_ = 0;
};

struct DrapeTrace {
  const TraceRay& trace_ray;
  const MeshScene& cloth;
  const MeshScene* body;
  const DrapePicture& picture;
  float thickness;
  float pixel_angle;
  glm::vec3 axis;  // of the camera, away from the eye

  /// The back is seen in the front's (u, v), each thread at its own place: only z changes sign.
  glm::vec3 face(glm::vec3 l) const { return picture.front ? l : glm::vec3(l.x, l.y, -l.z); }

  /// Radiance that the body sends on from the sky to where a ray hit it.
  glm::vec3 sent_by_body(const MeshHit& hit, glm::vec3 direction, RandomStream& sampler) const {
    const glm::vec3 normal = glm::dot(hit.normal, direction) < 0 ? hit.normal : -hit.normal;
    const glm::vec3 from = hit.position + normal * thickness, towards = cosine_direction(normal, sampler);
    if (cloth.occluded(from, towards, 0) || body->occluded(from, towards, 0)) return glm::vec3(0);
    return picture.body_reflectance * picture.sky(towards);
  }

  glm::vec3 sky_from(glm::vec3 from, glm::vec3 direction, RandomStream& sampler) const {
    MeshHit hit;
    const bool stopped = body && body->intersect(from, direction, 0, hit);
    if (cloth.occluded(from, direction, thickness, stopped ? hit.t : MeshScene::kEndless)) return glm::vec3(0);
    return stopped ? sent_by_body(hit, direction, sampler) : picture.sky(direction);
  }

  /// `sampler`: of the sample, for as long as the surroundings are asked.
  Surroundings around(const MeshHit& hit, const LightSample& light, RandomStream& sampler) const {
    const LocalFrame frame{hit};
    Surroundings s;
    s.light_towards = face(frame.to(light.towards));
    s.light_radius_rad = light.radius_rad;
    s.light_irradiance = light.irradiance;
    // Nearby threads are occluders in the tubes; the mesh occludes from one thickness on.
    const auto start = [this, &hit](glm::vec3 world) {
      return hit.position + hit.normal * (glm::dot(world, hit.normal) > 0 ? thickness : -thickness);
    };
    s.hidden = [this, frame, start](glm::vec3 local) {
      const glm::vec3 world = frame.from(face(local)), from = start(world);
      return cloth.occluded(from, world, thickness) || (body && body->occluded(from, world, 0));
    };
    if (picture.sky) {
      s.sky = [this, frame, start, &sampler](glm::vec3 local) {
        const glm::vec3 world = frame.from(face(local));
        return sky_from(start(world), world, sampler);
      };
    }
    return s;
  }

  PixelLayers layers_of(const PathSample& traced, const MeshHit& hit, glm::vec3 direction) const {
    PixelLayers layers;
    layers.depth_mm = hit.t * glm::dot(direction, axis);
    layers.normal = LocalFrame{hit}.from(face(traced.normal));
    layers.uv_mm = hit.uv_mm;
    layers.albedo = traced.albedo, layers.direct = traced.direct;
    layers.system = traced.system, layers.thread = traced.thread;
    return layers;
  }

  SeenSample sample(glm::vec3 direction, RandomStream& sampler) const {
    float t_min = 0;
    MeshHit stop;
    const LightSample light =
        picture.light ? picture.light(sampler)
                      : LightSample{picture.light_towards, picture.light_irradiance, picture.light_radius_rad};
    const bool stopped = body && body->intersect(picture.eye, direction, 0, stop);
    for (int layer = 0; layer < kMaxLayers; ++layer) {
      MeshHit hit;
      if (!cloth.intersect(picture.eye, direction, t_min, hit)) return {};
      if (stopped && stop.t < hit.t) return {};
      lean_to(hit, direction);
      const LocalFrame frame{hit};
      const glm::vec3 local = face(frame.to(direction));
      const glm::vec3 at(hit.uv_mm, 0);
      // Enters the cloth above the point, but at grazing views no further away than the surface is locally flat.
      const PathSample traced =
          trace_ray(at - local * (kEnterThicknesses * thickness), local, around(hit, light, sampler), sampler,
                    pixel_angle * hit.t /
                        std::sqrt(kSamplesOfAPixel * std::max(std::abs(glm::dot(hit.normal, direction)), 0.1f)));
      if (traced.hit) return {glm::vec4(traced.radiance, 1), layers_of(traced, hit, direction)};
      t_min = hit.t + thickness;
    }
    return {};
  }
};

TracedImage trace_pixels(const DrapeTrace& drape, const DrapePicture& picture, const Progress& progress) {
  TracedImage image{picture.width, picture.height, {}};
  image.pixels.resize(static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
  if (picture.layers) image.layers.resize(image.pixels.size());
  each_row(picture.height, picture.threads, picture.stop, progress, [&](int y) {
    for (int x = 0; x < picture.width; ++x) {
      const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x);
      const uint64_t seed = seed_of(x, y, picture.width) + picture.seed * kOtherSeed;
      RandomStream sampler(seed);
      const glm::vec2 shift(sampler.next(), sampler.next());
      if (picture.first_sample > 0) {
        sampler = RandomStream(seed + static_cast<uint64_t>(picture.first_sample) * 0xD1B54A32D192ED03u);
      }
      glm::vec4 sum(0);
      LayerSums layers;
      for (int k = 0; k < picture.spp; ++k) {
        const glm::vec2 p = glm::vec2(x, y) + pixel_sample(picture.first_sample + k, shift);
        const SeenSample seen = drape.sample(ray_through(picture, p), sampler);
        sum += seen.light;
        if (picture.layers) layers.add(seen);
      }
      image.pixels[pixel] = sum / static_cast<float>(picture.spp);
      if (picture.layers) image.layers[pixel] = layers.mean(picture.spp);
    }
  });
  return image;
}

TracedImage trace_flat_pixels(const TraceRay& trace_ray, float thickness, const FlatPicture& picture,
                              const Progress& progress) {
  TracedImage image{picture.width, picture.height, {}};
  image.pixels.resize(static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
  const glm::vec2 across = picture.step_x_mm, down = picture.step_y_mm;
  const float sample_mm = picture.fibre_detail
                              ? std::sqrt(std::abs(across.x * down.y - across.y * down.x) / kSamplesOfAPixel)
                              : kCoarseSample_mm;
  each_row(picture.height, 0, {}, progress, [&](int y) {
    for (int x = 0; x < picture.width; ++x) {
      RandomStream sampler(seed_of(x, y, picture.width) + picture.seed * 0xD1B54A32D192ED03u);
      const glm::vec2 shift(sampler.next(), sampler.next());
      glm::vec4 sum(0);
      for (int k = 0; k < picture.spp; ++k) {
        const glm::vec2 p = glm::vec2(x, y) + pixel_sample(k, shift);
        const glm::vec2 at = picture.corner_mm + p.x * picture.step_x_mm + p.y * picture.step_y_mm;
        const float away = 2 * thickness / std::max(picture.view.z, 1e-4f);
        const PathSample traced =
            trace_ray(glm::vec3(at, 0) + picture.view * away, -picture.view, picture.around, sampler, sample_mm);
        sum += glm::vec4(traced.radiance, traced.hit ? 1.0f : 0.0f);
      }
      image.pixels[static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x)] =
          sum / static_cast<float>(picture.spp);
    }
  });
  return image;
}

}  // namespace

TracedImage trace_drape(const TubeScene& tubes, const MeshScene& cloth, const MeshScene* body,
                        const DrapePicture& picture, const Progress& progress) {
  const ClothTracer tracer(tubes, picture.colours);
  const TraceRay trace_ray = ray_among(tracer, picture.bounces);
  return trace_pixels(
      {trace_ray, cloth, body, picture, tubes.z_max() - tubes.z_min(), pixel_angle(picture), axis_of(picture)}, picture,
      progress);
}

TracedImage trace_drape(const FibreScene& fibres, const MeshScene& cloth, const MeshScene* body,
                        const DrapePicture& picture, const Progress& progress) {
  const FibreTracer tracer(fibres, {}, lamp_spread(picture.first_sample + picture.spp));
  const TraceRay trace_ray = ray_among(tracer);
  return trace_pixels({trace_ray, cloth, body, picture, fibres.thickness_mm(), pixel_angle(picture), axis_of(picture)},
                      picture, progress);
}

SeenPatch seen_patch(const MeshScene& cloth, const MeshScene* body, const DrapePicture& picture) {
  constexpr int kStep = 3;  // pixels
  SeenPatch seen;
  bool any = false;
  for (int y = 0; y <= picture.height + kStep - 1; y += kStep)
    for (int x = 0; x <= picture.width + kStep - 1; x += kStep) {
      const glm::vec3 direction = ray_through(picture, {std::min(x, picture.width), std::min(y, picture.height)});
      MeshHit hit, stop;
      if (!cloth.intersect(picture.eye, direction, 0, hit)) continue;
      if (body && body->intersect(picture.eye, direction, 0, stop) && stop.t < hit.t) continue;
      seen.low = any ? glm::min(seen.low, hit.uv_mm) : hit.uv_mm;
      seen.high = any ? glm::max(seen.high, hit.uv_mm) : hit.uv_mm;
      any = true;
    }
  return seen;
}

TracedImage trace_flat(const TubeScene& tubes, const FlatPicture& picture, const Progress& progress) {
  const ClothTracer tracer(tubes, picture.colours);
  return trace_flat_pixels(ray_among(tracer, picture.bounces), tubes.z_max() - tubes.z_min(), picture, progress);
}

TracedImage trace_flat(const FibreScene& fibres, const FlatPicture& picture, const Progress& progress) {
  const FibreTracer tracer(fibres);
  return trace_flat_pixels(ray_among(tracer), fibres.z_max() - fibres.z_min(), picture, progress);
}

}  // namespace weftlight::reference
