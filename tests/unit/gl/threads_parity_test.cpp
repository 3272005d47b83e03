// The larger shared files on the GPU against the same text in C++: threads as bodies, their pattern and colours,
// shading of the methods, flyaway fibres. The cloth is uploaded as by the renderer.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "gl/gpu_cloth.h"
#include "packed_threads.h"
#include "pixel_program.h"

namespace weftlight::gl {

using cloth::Texel, cloth::ThreadTexture, cloth::texture_at;
using cloth::thread_formulas::texture_point;
using render_data::ThreadKind, render_data::thread_kind;

namespace {

using RayCase = std::array<vec4, 3>;  // position, side; towards the eye; towards the light, sample's cycles

constexpr const char* kRayMain = R"(
  ThreadGrid g = thread_grid(given(0).w > 0.0 ? 0 : 1);
  vec3 v = given(1).xyz;
  vec3 l = given(2).xyz;
  ThreadHit hit = first_thread(g, given(0).xy, v, 48);
  result = vec4(-1.0);
  if (hit.system >= 0) {
    int thread = hit.strand.thread;
    float length_mm = hit.system == 0 ? g.period.y : g.period.x;
    ThreadPoint p = thread_point(hit.system, hit.strand, hit.at);
    ThreadTexture x = thread_pattern(hit.system, thread, g.side);
    Texel t = texture_at(x, texture_point(x, fract(p.along / length_mm), p.turn, given(2).w, 1.0));
    vec4 look = thread_dye(hit_layer(g, hit), hit.system, thread, p.along);
    YarnLobes y = thread_lobes(int(look.w), look.rgb);
    if (row == 0) result = vec4(float(hit.system), float(thread), hit.at.z, 0.0);
    if (row == 1) result = vec4(threads_block(g, hit.at, l, 24, hit.system, thread) ? 1.0 : 0.0);
    if (row == 2) result = vec4(p.normal, p.turn);
    if (row == 3) result = vec4(p.axis, p.along);
    if (row == 4) result = vec4(t.groove, t.tone, t.ply, x.fibre_tan);
    if (row == 5) result = vec4(ply_normal(p, x, t.ply, length_mm), 0.0);
    FibreDetail d = fibre_detail(x, fract(p.along / length_mm), p.turn, sample_size(x, 0.03 * given(2).w, p.normal.z, length_mm), length_mm);
    SurfaceFrame frame_at = SurfaceFrame(p.normal, p.axis, p.around);
    float relief = fibre_relief(y.slope_cov.z, 0.0f);
    if (row == 7) result = vec4(d.texel.groove, d.texel.tone, d.fibre_tan, d.resolved.y);
    if (row == 8) result = vec4(detail_normal(frame_at, x, d, relief, length_mm, v), ply_light(frame_at, x, d, length_mm, l));
    if (row == 9) result = vec4(detail_lobes(y, d.resolved, relief).slope_cov, detail_gain(x, d, relief));
    if (row == 6) result = vec4(facet_radiance(y, p.normal, 1.0, p.axis + p.around * x.fibre_tan, vec3(0.0), l, v).key, 0.0);
  }
)";
constexpr int kRayRows = 10;
constexpr std::array<const char*, kRayRows> kRayNames{
    "first_thread", "threads_block",  "normal, turn", "axis, along",   "texture_at",
    "ply_normal",   "facet_radiance", "fibre_detail", "detail_normal", "detail_lobes"};

vec4 ray_on_cpu(PackedThreads& t, const RayCase& c, int row) {
  using cloth::thread_formulas::FibreDetail, cloth::thread_formulas::SurfaceFrame, cloth::thread_formulas::fibre_relief;
  const PackedThreads::ThreadGrid g = t.grid();
  const vec3 v(c[1]), l(c[2]);
  const PackedThreads::ThreadHit hit = t.first_thread(g, glm::vec2(c[0]), v, 48);
  if (hit.system < 0) return vec4(-1);
  const int thread = hit.strand.thread;
  const float length = hit.system == 0 ? g.period.y : g.period.x;
  const PackedThreads::ThreadPoint p = t.thread_point(hit.system, hit.strand, hit.at);
  const ThreadTexture x = t.pattern(hit.system, thread);
  const Texel texel = texture_at(x, texture_point(x, glm::fract(p.along / length), p.turn, c[2].w, 1.0f));
  const vec4 look = t.look(hit.system, thread);
  const FibreDetail detail =
      fibre_detail(x, glm::fract(p.along / length), p.turn, sample_size(x, 0.03f * c[2].w, p.normal.z, length), length);
  const SurfaceFrame frame{p.normal, p.axis, p.around};
  const formulas::YarnLobes y = formulas::yarn_of(t.yarn(static_cast<int>(look.w)), vec3(look));
  const float relief = fibre_relief(y.slope_cov.z, 0.0f);
  switch (row) {
    case 0:
      return {hit.system, thread, hit.at.z, 0};
    case 1:
      return vec4(t.threads_block(g, hit.at, l, 24, hit.system, thread) ? 1.0f : 0.0f);
    case 2:
      return {p.normal, p.turn};
    case 3:
      return {p.axis, p.along};
    case 4:
      return {texel.groove, texel.tone, texel.ply, x.fibre_tan};
    case 5:
      return {t.ply_normal(p, x, texel.ply, length), 0};
    case 6:
      return {formulas::facet_radiance(y, p.normal, 1, p.axis + p.around * x.fibre_tan, vec3(0), l, v).key, 0};
    case 7:
      return {detail.texel.groove, detail.texel.tone, detail.fibre_tan, detail.resolved.y};
    case 8:
      return {detail_normal(frame, x, detail, relief, length, v), ply_light(frame, x, detail, length, l)};
    default:
      return {formulas::detail_lobes(y, detail.resolved, relief).slope_cov, detail_gain(x, detail, relief)};
  }
}

vec3 slanted(float cosine, float turn) {
  const float s = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  return {s * std::cos(turn), s * std::sin(turn), cosine};
}

/// Fraction of the cases that differ by more than `most`, relative to 1 or to the value if it is larger.
double share_off(const std::vector<vec4>& gpu, const std::vector<vec4>& cpu, float most) {
  size_t off = 0;
  for (size_t k = 0; k < gpu.size(); ++k) {
    bool good = true;
    for (int i = 0; i < 4; ++i) good &= std::abs(gpu[k][i] - cpu[k][i]) <= most * std::max(1.0f, std::abs(cpu[k][i]));
    off += !good;
  }
  return static_cast<double>(off) / static_cast<double>(gpu.size());
}

using ThreadsParity = PixelTest;

/// Anywhere on the cloth, three of four on its front, eye and light at any slant; `last(k, u)`: what the light's fourth
/// number is, u in 0..1.
template <class Last>
std::vector<RayCase> ray_cases(const PackedCloth& p, int count, unsigned seed, const Last& last) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> u(0, 1);
  std::vector<RayCase> cases;
  for (int k = 0; k < count; ++k)
    cases.push_back({vec4(u(rng) * p.width_mm, u(rng) * p.depth_mm, 0, k % 4 == 3 ? -1.0f : 1.0f),
                     vec4(slanted(0.15f + 0.85f * u(rng), 6.2831853f * u(rng)), 0),
                     vec4(slanted(0.1f + 0.9f * u(rng), 6.2831853f * u(rng)), last(k, u(rng)))});
  return cases;
}

/// Uploads a cloth; its strips, if it has any, first wrong, then in patches that begin and end anywhere.
void upload_in_pieces(GpuCloth& gpu, const PackedCloth& cloth) {
  PackedCloth wrong = cloth;
  for (uint32_t& strip : wrong.strips) strip = ~strip;
  gpu.upload(wrong);
  render_data::ClothPatches patches;
  size_t first = 0;
  for (const size_t end : {size_t{7}, size_t{1030}, size_t{4000}, cloth.strips.size()}) {
    if (end <= first || end > cloth.strips.size()) continue;
    const auto at = cloth.strips.begin();
    patches.strips.push_back({first, {at + static_cast<std::ptrdiff_t>(first), at + static_cast<std::ptrdiff_t>(end)}});
    first = end;
  }
  gpu.upload(patches);
}

TEST_F(ThreadsParity, RaysMeetTheSameThreadsInTheSameLight) {
  // A ray that grazes an edge, or the border of a fibre, may go either way by its last bit. On llvmpipe none does.
  constexpr double kEdges = 0.01;
  constexpr float kTolerance = 2e-3f;
  const Design even = twill(4, 2, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  const Cloth even_cloth = lay_out(even, drawdown(even.draft), Face::kFront, Period::kWholeDraft);
  const std::array cloths{packed(uneven_twill()),         packed(pockets()), packed(even_cloth), in_strips(even_cloth),
                          in_strips(unordered(300, 200)), packed(jammed()),  packed(gathered())};
  EXPECT_FALSE(cloths.back().asides.empty());
  EXPECT_GT(jammed().ends[0].squareness, 0.7f);
  for (const PackedCloth& p : cloths) {
    // The defines leave out code only here: the C++ has the whole text.
    const ThreadKind kind = thread_kind(p.lobes.threads);
    std::vector<std::string> defines;
    if (p.crossings.empty()) defines.push_back("COMPUTED_CROSSINGS");
    if (kind.even) defines.push_back("EVEN_THREADS");
    if (kind.one_layer) defines.push_back("ONE_LAYER");
    if (kind.smooth) defines.push_back("SMOOTH_YARNS");
    if (kind.straight) defines.push_back("STRAIGHT_THREADS");
    SCOPED_TRACE("cloth " + std::to_string(&p - cloths.data()));
    GpuCloth gpu_cloth;
    upload_in_pieces(gpu_cloth, p);
    gpu_cloth.bind();
    const std::vector<RayCase> cases = ray_cases(p, 2000, 7, [](int, float u) { return 0.3f * u; });
    const std::vector<vec4> all =
        run_pixels(pixel_program({"tables.glsl", "lobes.glsl", "methods.glsl", "thread_fetch.glsl"}, kRayMain, defines),
                   cases, kRayRows);
    PackedThreads front(p, 1), back(p, -1);
    for (int row = 0; row < kRayRows; ++row) {
      std::vector<vec4> cpu;
      for (const RayCase& c : cases) cpu.push_back(ray_on_cpu(c[0].w > 0 ? front : back, c, row));
      const auto from = all.begin() + row * static_cast<std::ptrdiff_t>(cases.size());
      const double off = share_off({from, from + static_cast<std::ptrdiff_t>(cases.size())}, cpu, kTolerance);
      EXPECT_LE(off, kEdges) << kRayNames[static_cast<size_t>(row)];
      const auto lit = std::count_if(cpu.begin(), cpu.end(), [](const vec4& c) { return c.x > 0; });
      EXPECT_GT(lit, 100) << kRayNames[static_cast<size_t>(row)];
      std::printf("  %s: %g of the cases are off\n", kRayNames[static_cast<size_t>(row)], off);
    }
  }
}

constexpr const char* kDyeMain = R"(
  ThreadGrid g = thread_grid(given(0).w > 0.0 ? 0 : 1);
  ThreadHit hit = first_thread(g, given(0).xy, given(1).xyz, 48);
  result = vec4(-1.0);
  if (hit.system >= 0) {
    ThreadPoint p = thread_point(hit.system, hit.strand, hit.at);
    result = thread_dye(hit_layer(g, hit), hit.system, hit.strand.thread, p.along);
  }
)";

/// Every second thread in five colours along it, each starting elsewhere.
Cloth dyed(Cloth cloth) {
  cloth.dyes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5f, 0.5f, 0}, {0.2f, 0.4f, 0.6f}}};
  for (std::vector<ThreadBody>* threads : {&cloth.ends, &cloth.picks})
    for (size_t i = 0; i < threads->size(); i += 2)
      (*threads)[i].dye = 0, (*threads)[i].dye_phase = static_cast<int>(i % 5);
  return cloth;
}

TEST_F(ThreadsParity, ThreadsHaveTheirColoursAlongThem) {
  // Where one colour ends, a ray may take either by its last bit; a border that sways is taken as straight there.
  constexpr double kEdges = 0.01;
  for (const Cloth& cloth : {dyed(uneven_twill()), dyed(pockets())}) {
    const PackedCloth p = packed(cloth);
    const ThreadKind kind = thread_kind(p.lobes.threads);
    EXPECT_TRUE(kind.dyed);
    std::vector<std::string> defines{"DYED_ALONG"};
    if (kind.one_layer) defines.push_back("ONE_LAYER");
    GpuCloth gpu_cloth;
    gpu_cloth.upload(p);
    gpu_cloth.bind();
    const std::vector<RayCase> cases = ray_cases(p, 2000, 11, [](int, float u) { return u; });
    const std::vector<vec4> gpu = run_pixels(
        pixel_program({"tables.glsl", "lobes.glsl", "methods.glsl", "thread_fetch.glsl"}, kDyeMain, defines), cases, 1);
    PackedThreads front(p, 1), back(p, -1);
    std::vector<vec4> cpu;
    for (const RayCase& c : cases) {
      PackedThreads& t = c[0].w > 0 ? front : back;
      const PackedThreads::ThreadHit hit = t.first_thread(t.grid(), glm::vec2(c[0]), vec3(c[1]), 48);
      cpu.push_back(vec4(-1));
      if (hit.system < 0) continue;
      const PackedThreads::ThreadPoint at = t.thread_point(hit.system, hit.strand, hit.at);
      const cloth::Linear& colour =
          colour_along(cloth, hit.system == 0 ? System::kWarp : System::kWeft, hit.strand.thread, at.along);
      const float yarn = t.look(hit.system, hit.strand.thread).w;
      cpu.back() = {colour.r, colour.g, colour.b, yarn};
    }
    EXPECT_LE(share_off(gpu, cpu, 1e-4f), kEdges);
  }
}

constexpr const char* kFloatMain = R"(
  ThreadGrid g = thread_grid(given(0).w > 0.0 ? 0 : 1);
  IrawanPoint p = irawan_point(g, given(0).xy);
  result = vec4(-1.0);
  if (p.system >= 0 && row == 0) result = vec4(float(p.system), float(p.thread), p.above ? 1.0 : 0.0, 0.0);
  if (p.system >= 0 && row == 1) result = vec4(p.at, p.size);
  if (row == 2) result = vec4(irawan_specular(p, given(2).w, given(2).xyz, given(1).xyz));
)";

TEST_F(ThreadsParity, FloatsOfThePeerShineAlike) {
  // A point on the edge of a stripe may go either way by its last bit.
  constexpr double kEdges = 0.002;
  const PackedCloth p = packed(uneven_twill());
  GpuCloth gpu_cloth;
  gpu_cloth.upload(p);
  gpu_cloth.bind();
  const std::vector<RayCase> cases = ray_cases(p, 4000, 9, [](int k, float u) { return k % 3 == 0 ? 0 : u - 0.5f; });
  const std::vector<vec4> all = run_pixels(
      pixel_program({"tables.glsl", "lobes.glsl", "methods.glsl", "thread_fetch.glsl", "irawan.glsl"}, kFloatMain),
      cases, 3);
  PackedThreads front(p, 1), back(p, -1);
  for (int row = 0; row < 3; ++row) {
    std::vector<vec4> cpu;
    for (const RayCase& c : cases) {
      PackedThreads& t = c[0].w > 0 ? front : back;
      const PackedThreads::IrawanPoint point = t.irawan_point(t.grid(), glm::vec2(c[0]));
      vec4 result(-1);
      if (point.system >= 0 && row == 0) result = {point.system, point.thread, point.above, 0};
      if (point.system >= 0 && row == 1) result = {point.at, point.size};
      if (row == 2) result = vec4(t.irawan_specular(point, c[2].w, vec3(c[2]), vec3(c[1])));
      cpu.push_back(result);
    }
    const auto from = all.begin() + row * static_cast<std::ptrdiff_t>(cases.size());
    const double off = share_off({from, from + static_cast<std::ptrdiff_t>(cases.size())}, cpu, 2e-3f);
    EXPECT_LE(off, kEdges) << "row " << row;
    EXPECT_GT(std::count_if(cpu.begin(), cpu.end(), [](const vec4& c) { return c.x > 0; }), 200) << "row " << row;
    std::printf("  row %d: %g of the cases are off\n", row, off);
  }
}

using MethodCase = std::array<vec4, 8>;

constexpr const char* kMethodMain = R"(
  vec3 l = given(0).xyz;
  vec3 v = given(1).xyz;
  vec4 a = given(2);
  vec4 b = given(3);
  vec4 c = given(4);
  vec4 d = given(5);
  YarnData data = record_yarn(floatBitsToUint(a), floatBitsToUint(b), floatBitsToUint(c), floatBitsToUint(d));
  vec3 color = given(6).rgb;
  YarnLobes y = yarn_of(data, color);
  vec4 e = given(7);
  if (row == 0) result = vec4(facet_radiance(y, normalize(vec3(e.xy - 0.5, 1.0)), 0.9, vec3(1.0, e.z, 0.0), vec3(e.x, 0.0, e.y), l, v).key, 0.0);
  if (row == 1) result = vec4(facet_radiance(y, vec3(0.0, 0.0, 1.0), 1.0, vec3(0.0, 1.0, 0.0), vec3(0.0), l, v).diffuse, 0.0);
  if (row == 2) result = vec4(system_radiance(y, e, 0.5 + e.x, e.z, d, l, v).key, 0.0);
  if (row == 3) result = vec4(response_coord(v), half_slopes(l, v));
  if (row == 4) {
    EngineMaterial m = EngineMaterial(color, data.tint.w, color * e.x, 0.1 + e.y, vec2(0.1 + e.z, 0.1 + e.w), vec3(0.5 + e.x, 0.4 + e.y, 0.3), 0.9 - 0.5 * e.y, e.x);
    result = vec4(engine_radiance(m, lobe_frame(normalize(vec3(e.xy - 0.5, 1.0)), vec3(1.0, 0.0, 0.0)), l, v).key, 0.0);
  }
  if (row == 5) result = vec4(gradient_factor(a, b, e), region_factor(e.x, e.y + 0.1), slope_coord(l.x / l.z), lattice_point(lattice_of(lattice_for(e.x, vec4(0.1, 0.2, 0.3, 0.4), vec4(0.5, 0.6, 0.7, 9.0), 21)), 5, 3, e.y).x);
  if (row == 6) result = vec4(flyaway_key(color, color * e.x, normalize(vec3(e.xyz - 0.5)), vec3(0.0, 0.0, 1.0), l, v), flyaway_fraction(e.w));
  if (row == 7) result = vec4(flyaway_sky(color, color * e.x), 0.0);
  FaceFlyaway f = face_flyaway(flyaway_bits(uint(1000.0 * e.x), uint(10.0 * e.y)), vec2(0.5 + e.z, 0.5 + e.w), 0.5 + e.x);
  if (row == 8) result = vec4(f.middle, f.reach, f.bend);
  if (row == 9) result = vec4(flyaway_at(f, f.middle + f.way * (f.reach * (e.y - 0.5)), vec2(0.1, 0.0), vec2(0.0, 0.1)), fuzz_left(e.z, e.x, e.y), face_cell(e.x, e.y, 0.2));
)";
constexpr int kMethodRows = 10;
constexpr std::array<const char*, kMethodRows> kMethodNames{
    "facet_radiance, key", "facet_radiance, diffuse", "system_radiance", "response_coord, half_slopes",
    "engine_radiance",     "gradient, region, slope", "flyaway_key",     "flyaway_sky",
    "face_flyaway",        "flyaway_at, fuzz_left"};

vec4 method_on_cpu(const MethodCase& given, int row) {
  using formulas::EngineMaterial, formulas::FaceFlyaway, formulas::YarnData, formulas::YarnLobes, formulas::face_cell,
      formulas::face_flyaway, formulas::flyaway_bits, formulas::flyaway_fraction, formulas::flyaway_key,
      formulas::flyaway_sky, formulas::fuzz_left, formulas::gradient_factor, formulas::half_slopes,
      formulas::lattice_for, formulas::lattice_of, formulas::lattice_point, formulas::lobe_frame,
      formulas::region_factor, formulas::response_coord, formulas::slope_coord, formulas::yarn_of;
  const vec3 l(given[0]), v(given[1]), color(given[6]);
  const vec4 e = given[7];
  YarnData data{};
  std::memcpy(&data, &given[2], sizeof data);
  const YarnLobes y = yarn_of(data, color);
  const vec3 n = normalize(vec3(e.x - 0.5f, e.y - 0.5f, 1));
  switch (row) {
    case 0:
      return {facet_radiance(y, n, 0.9f, vec3(1, e.z, 0), vec3(e.x, 0, e.y), l, v).key, 0};
    case 1:
      return {facet_radiance(y, vec3(0, 0, 1), 1, vec3(0, 1, 0), vec3(0), l, v).diffuse, 0};
    case 2:
      return {system_radiance(y, e, 0.5f + e.x, e.z, given[5], l, v).key, 0};
    case 3:
      return {response_coord(v), half_slopes(l, v)};
    case 4: {
      const EngineMaterial m{color,
                             data.tint.w,
                             color * e.x,
                             0.1f + e.y,
                             {0.1f + e.z, 0.1f + e.w},
                             vec3(0.5f + e.x, 0.4f + e.y, 0.3f),
                             0.9f - 0.5f * e.y,
                             e.x};
      return {engine_radiance(m, lobe_frame(n, vec3(1, 0, 0)), l, v).key, 0};
    }
    case 5:
      return {
          gradient_factor(given[2], given[3], e), region_factor(e.x, e.y + 0.1f), slope_coord(l.x / l.z),
          lattice_point(lattice_of(lattice_for(e.x, {0.1f, 0.2f, 0.3f, 0.4f}, {0.5f, 0.6f, 0.7f, 9.0f}, 21)), 5, 3, e.y)
              .x};
    case 6:
      return {flyaway_key(color, color * e.x, normalize(vec3(e) - 0.5f), vec3(0, 0, 1), l, v), flyaway_fraction(e.w)};
    case 7:
      return {flyaway_sky(color, color * e.x), 0};
    default: {
      const FaceFlyaway f =
          face_flyaway(flyaway_bits(static_cast<uint32_t>(1000 * e.x), static_cast<uint32_t>(10 * e.y)),
                       {0.5f + e.z, 0.5f + e.w}, 0.5f + e.x);
      if (row == 8) return {f.middle, f.reach, f.bend};
      return {flyaway_at(f, f.middle + f.way * (f.reach * (e.y - 0.5f)), {0.1f, 0}, {0, 0.1f}),
              fuzz_left(e.z, e.x, e.y), face_cell(e.x, e.y, 0.2f)};
    }
  }
}

TEST_F(ThreadsParity, MethodsAndFlyawaysAgree) {
  constexpr float kTolerance = 6e-3f;  // tables read by texture units (parity_test.cpp)
  GpuCloth tables;
  tables.upload(PackedCloth{});
  tables.bind();
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> u(0, 1);
  const auto four = [&] { return vec4(u(rng), u(rng), u(rng), u(rng)); };
  std::vector<MethodCase> cases;
  for (int k = 0; k < 1500; ++k) {
    vec4 widths = four() + vec4(0.05f, 0.05f, 0, 0), tint = four();
    tint.w = k % 5 == 0 ? 1.0f : 0.0f;
    cases.push_back({vec4(slanted(0.05f + 0.95f * u(rng), 6.2831853f * u(rng)), 0),
                     vec4(slanted(0.05f + 0.95f * u(rng), 6.2831853f * u(rng)), 0), widths,
                     four() + vec4(0, 0.05f, 0.05f, 0), tint,
                     vec4(0.02f + 0.1f * u(rng), 1 + 5 * u(rng), 3 * u(rng) - 1, 0), four(), four()});
  }
  const std::vector<vec4> all = run_pixels(pixel_program({"tables.glsl", "lobes.glsl", "lattice.glsl", "methods.glsl",
                                                          "engine.glsl", "thread_records.glsl", "flyaway.glsl"},
                                                         kMethodMain),
                                           cases, kMethodRows);
  for (int row = 0; row < kMethodRows; ++row) {
    std::vector<vec4> cpu;
    for (const MethodCase& c : cases) cpu.push_back(method_on_cpu(c, row));
    const auto from = all.begin() + row * static_cast<std::ptrdiff_t>(cases.size());
    const double off = share_off({from, from + static_cast<std::ptrdiff_t>(cases.size())}, cpu, kTolerance);
    // An integer number of samples may flip by the last bit.
    EXPECT_LE(off, row == 5 ? 2e-3 : 0.0) << kMethodNames[static_cast<size_t>(row)];
    EXPECT_GT(std::count_if(cpu.begin(), cpu.end(), [](const vec4& c) { return c.x != 0; }), 1000);
  }
}

}  // namespace
}  // namespace weftlight::gl
