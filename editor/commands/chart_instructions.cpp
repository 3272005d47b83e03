#include "commands/chart_instructions.h"

#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>

#include "cloth/thread_scene.h"
#include "light/formulas.h"
#include "light/yarn_lobes.h"

namespace weftlight::commands {
namespace {

using namespace formulas;

/// Single steps from the child's second stop to its third; the first run of `work` has bound its symbols.
std::optional<long> steps_between_stops(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) return std::nullopt;
  long steps = 0;
  while (true) {
    if (ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) != 0) return std::nullopt;
    if (waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) return std::nullopt;
    if (WSTOPSIG(status) == SIGSTOP) return steps;
    ++steps;
  }
}

std::optional<long> steps_of(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child < 0) return std::nullopt;
  if (child == 0) {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(1);
    work();
    raise(SIGSTOP);
    work();
    raise(SIGSTOP);
    _exit(0);
  }
  const std::optional<long> steps = steps_between_stops(child);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  return steps;
}

/// What a pixel has in hand when its textures are fetched.
struct PixelInput {
  YarnLobes warp, weft;
  vec3 n{0.2f, 0.1f, 0.97f};
  vec3 slopes{0.05f, 0, 0.04f};
  vec3 l, v;
  vec3 color{0.4f, 0.3f, 0.2f}, key{2.3f};
  vec4 horizon{0.3f, 0.35f, 0.32f, 0.28f}, spread{0.1f, 0.1f, 0.12f, 0.1f};
  vec2 gap{0.05f, 0.06f};
  float light_sine = 0.09f;
  ThreadScene* threads = nullptr;
  std::vector<ThreadTexture> ends, picks;
  int samples = 1;
};

/// Keeps the compiler from folding the input or dropping the result.
void keep(const void* p) { asm volatile("" : : "r"(p) : "memory"); }

vec3 flat_pixel(const PixelInput& x) { return x.color * x.key * (max(x.l.z, 0.0f) / 3.14159265f); }

vec3 vrst03_pixel(const PixelInput& x) {
  const vec3 h = normalize(x.l + x.v);
  const vec3 d = vrst03_difference(x.l, x.v);
  // The two cube maps' texels and the boolean of the nearest light direction.
  const float around = floor(atan(x.l.y, x.l.x) * 0.15915494f * 8.0f + 0.5f);
  const float elevation = asin(clamp(x.l.z, 0.0f, 1.0f));
  const vec3 brdf = h * d * (x.color / max(x.color, vec3(0.02f)));
  return x.key * brdf * (max(x.l.z, 0.0f) * (around + elevation));
}

float thread_light_pixel(const PixelInput& x) {
  const HorizonTaps taps = horizon_taps(atan(x.l.y, x.l.x), 16);
  return horizon_visibility(x.l.z, horizon_mix(taps, x.horizon), horizon_mix(taps, x.spread), x.light_sine);
}

vec3 facet_pixel(const PixelInput& x, const YarnLobes& yarn, vec3 fibre) {
  const LobeFrame f = lobe_frame(normalize(x.n), fibre);
  const YarnLobes y = yarn_widen(yarn, lobe_covariance(f, x.slopes));
  const LobeShared s = lobe_shared(y);
  const vec3 wo = lobe_local(f, x.v), wi = lobe_local(f, x.l);
  return lobe_reflect(y, s, lobe_side(y, s, wi), lobe_side(y, s, wo), wi, wo) * wi.z;
}

vec2 masking_pixel(const PixelInput& x) {
  const float area = gaussian_area(max(dot(x.n, x.v), 0.02f), sqrt(variance_along(x.slopes, x.v.x, x.v.y)));
  return system_masking(vec2(0.5f), vec2(area, area), 0.1f, x.v);
}

/// One sample of a pixel, as shaders/rung_yarn.glsl takes it; the light's ray is followed where it must be, which
/// is every `kLitFor`th sample (the others are told apart by the horizons).
vec3 yarn_sample(const PixelInput& x, vec2 at, bool doubtful) {
  constexpr int kViewCells = 48, kLightCells = 24;
  ThreadScene& scene = *x.threads;
  const auto grid = scene.grid();
  const auto hit = scene.first_thread(grid, at, x.v, kViewCells);
  if (hit.system < 0) return vec3(0);
  const auto p = scene.thread_point(hit.system, hit.strand, hit.at);
  const float length = hit.system == 0 ? grid.period.y : grid.period.x;
  const ThreadTexture& pattern = (hit.system == 0 ? x.ends : x.picks)[static_cast<size_t>(hit.strand.thread)];
  const Texel texel =
      texture_at(pattern, thread_formulas::texture_point(pattern, fract(p.along / length), p.turn, 1, 0));
  const Answer a = facet_answer(hit.system == 0 ? x.warp : x.weft, p.normal, 1, p.axis + p.around * pattern.fibre_tan,
                                vec3(0), x.l, x.v);
  if (doubtful && scene.threads_block(grid, hit.at, x.l, kLightCells, hit.system, hit.strand.thread)) return vec3(0);
  return a.key * texel.groove;
}

vec3 yarn_pixel(const PixelInput& x) {
  constexpr int kLitFor = 6;
  const ThreadScene& scene = *x.threads;
  vec3 sum(0);
  for (int i = 0; i < x.samples; ++i) {
    keep(&x);
    const vec2 r = fract(vec2(0.75487767f, 0.56984029f) * (static_cast<float>(i) + 0.5f));
    sum += yarn_sample(x, r * scene.grid().period, i % kLitFor == 0);
  }
  return sum * x.key / static_cast<float>(x.samples);
}

vec3 cell_pixel(const PixelInput& x) {
  const vec2 seen = masking_pixel(x);
  const vec3 sent = facet_pixel(x, x.warp, vec3(0, 1, 0)) * seen.x + facet_pixel(x, x.weft, vec3(1, 0, 0)) * seen.y;
  return sent * x.key * (thread_light_pixel(x) * coverage_by_view(0.9f, x.gap, 0.2f, x.v));
}

/// The measured answers of both systems.
vec3 cloth_pixel(const PixelInput& x) {
  const vec2 h = half_slopes(x.l, x.v);
  const vec2 slopes(slope_coord(h.x), slope_coord(h.y));
  const vec2 at = response_coord(x.l) + response_coord(x.v);
  const vec4 broad = x.horizon * (at.x + at.y);
  const Answer warp = system_answer(x.warp, broad, slopes, 0.5f, 0.8f, x.l, x.v);
  const Answer weft = system_answer(x.weft, broad, slopes, 0.5f, 0.8f, x.l, x.v);
  return mixed_answer(warp, weft, x.gap, slopes).key * x.key * coverage_by_view(0.9f, x.gap, 0.2f, x.v);
}

/// The same, each system leaned with the four samples of its facets, where the view finds them.
vec3 repeat_pixel(const PixelInput& x) {
  const vec2 h = half_slopes(x.l, x.v);
  const vec2 slopes(slope_coord(h.x), slope_coord(h.y));
  const vec2 at = response_coord(x.l) + response_coord(x.v);
  const vec4 broad = x.horizon * (at.x + at.y);
  Answer warp = system_answer(x.warp, broad, slopes, 0.5f, 0.8f, x.l, x.v);
  Answer weft = system_answer(x.weft, broad, slopes, 0.5f, 0.8f, x.l, x.v);
  const vec2 towards = vec2(x.v.x, x.v.y) / (x.v.z * x.gap);
  const float row = min(0.25f * std::abs(log2(dot(x.gap, x.gap))), 1.0f);
  vec4 facets[2] = {vec4(towards.x), vec4(towards.y)};
  for (int i = 0; i < 4; ++i) {
    keep(&x);
    const vec2 aside = x.gap * (0.25f - 0.125f * row) + towards * row;
    facets[0] += 0.25f * x.spread * aside.x, facets[1] += 0.25f * x.horizon * aside.y;
  }
  warp.key *= lean_factor(broad, facets[0], x.spread);
  weft.key *= lean_factor(broad, facets[1], x.spread);
  const vec2 seen = x.gap * vec2(region_factor(slopes.x, towards.x), region_factor(slopes.y, towards.y));
  return mixed_answer(warp, weft, seen, slopes).key * x.key * coverage_by_view(0.9f, x.gap, 0.2f, x.v);
}

vec3 engine_pixel(const PixelInput& x) {
  const EngineMaterial m{x.color, 0, sqrt(x.color), 0.5f, sqrt(2.0f * vec2(x.slopes.x, x.slopes.z)), 0.04f, 1, 0.8f};
  return engine_answer(m, lobe_frame(normalize(x.n), vec3(1, 0, 0)), x.l, x.v).key * x.key;
}

using PixelFormula = vec3 (*)(const PixelInput&);

PixelFormula formula_of(Method method) {
  switch (method) {
    case Method::kFlat:
      return flat_pixel;
    case Method::kVrst03:
      return vrst03_pixel;
    case Method::kCloth:
      return cloth_pixel;
    case Method::kRepeat:
      return repeat_pixel;
    case Method::kCell:
      return cell_pixel;
    case Method::kYarn:
      return yarn_pixel;
    case Method::kEngine:
      return engine_pixel;
    default:
      return nullptr;
  }
}

std::vector<ThreadTexture> textures_of(const Cloth& cloth, System system) {
  const auto& threads = system == System::kWarp ? cloth.ends : cloth.picks;
  std::vector<ThreadTexture> out;
  for (size_t i = 0; i < threads.size(); ++i) {
    out.push_back(thread_texture(cloth.yarns[static_cast<size_t>(threads[i].yarn)], threads[i], system,
                                 static_cast<int>(i), system == System::kWarp ? cloth.depth_mm : cloth.width_mm));
  }
  return out;
}

YarnLobes first_lobes(const Cloth& cloth, const std::vector<ThreadBody>& threads) {
  const ThreadBody& thread = threads.front();
  return yarn_lobes(cloth.yarns[static_cast<size_t>(thread.yarn)].lobes, thread.colour);
}

}  // namespace

std::optional<long> count_instructions(const std::function<void()>& work) {
  const std::optional<long> all = steps_of(work), nothing = steps_of([] {});
  if (!all || !nothing) return std::nullopt;
  return *all - *nothing;
}

std::optional<long> formula_instructions(Method method, const Cloth& cloth, glm::vec3 view, glm::vec3 light,
                                         int samples) {
  const PixelFormula formula = formula_of(method);
  if (!formula || cloth.ends.empty() || cloth.picks.empty()) return std::nullopt;
  PixelInput input;
  input.warp = first_lobes(cloth, cloth.ends);
  input.weft = first_lobes(cloth, cloth.picks);
  input.l = light, input.v = view;
  ThreadScene threads(cloth);
  input.threads = &threads, input.samples = samples;
  input.ends = textures_of(cloth, System::kWarp), input.picks = textures_of(cloth, System::kWeft);
  return count_instructions([formula, &input] {
    keep(&input);
    const vec3 result = formula(input);
    keep(&result);
  });
}

}  // namespace weftlight::commands
