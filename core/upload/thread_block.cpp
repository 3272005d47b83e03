#include "upload/thread_block.h"

#include <algorithm>
#include <bit>
#include <glm/gtc/packing.hpp>

#include "cloth/centre_line.h"
#include "cloth/thread_scene.h"
#include "shaders/interop.h"
#include "upload/cloth_block.h"

namespace weftlight::upload {
namespace {

uint32_t bits(float v) { return std::bit_cast<uint32_t>(v); }
uint32_t bits(int v) { return static_cast<uint32_t>(v); }

void append(std::vector<uint32_t>& to, const std::array<uint32_t, 4>& texel) {
  to.insert(to.end(), texel.begin(), texel.end());
}

void append_threads(std::vector<uint32_t>& to, const Cloth& cloth, System system,
                    const std::vector<glm::vec4>& bodies) {
  const auto& threads = system == System::kWarp ? cloth.ends : cloth.picks;
  const float length_mm = system == System::kWarp ? cloth.depth_mm : cloth.width_mm;
  for (size_t i = 0; i < threads.size(); ++i) {
    const ThreadBody& body = threads[i];
    const glm::vec4& b = bodies[i];
    const ThreadTexture x =
        thread_texture(cloth.yarns[static_cast<size_t>(body.yarn)], body, system, static_cast<int>(i), length_mm);
    append(to, {bits(b.x), bits(b.y), bits(b.z), bits(b.w)});
    append(to, {bits(body.colour.r), bits(body.colour.g), bits(body.colour.b), bits(body.yarn)});
    append(to, {bits(x.fibres), bits(x.advance), bits(x.fibre_tan), bits(x.plies)});
    append(to, {bits(x.ply_advance), bits(x.ply_relief_mm), bits(x.phase), bits(x.ply_phase)});
    append(to, {bits(x.singles), bits(x.stray_advance), bits(x.nodes), bits(x.depth)});
    append(to, {bits(x.hair), bits(x.radius_mm), x.seed, 0});
  }
}

void append_bins(std::vector<uint32_t>& to, const std::vector<int>& first) {
  for (const int thread : first) to.push_back(bits(thread));
  to.resize((to.size() + 3) / 4 * 4);
}

}  // namespace

std::vector<uint32_t> thread_records(const Cloth& cloth, float top_mm) {
  const ThreadTables t = thread_tables(cloth);
  std::vector<uint32_t> to;
  const auto texels = [&] { return static_cast<uint32_t>(to.size() / 4); };
  to.resize(16);
  std::array<uint32_t, 4> tables{};
  for (const System s : {System::kWarp, System::kWeft}) {
    const size_t k = s == System::kWarp ? 0 : 1;
    tables[k] = texels();
    append_threads(to, cloth, s, t.bodies[k]);
    tables[k + 2] = texels();
    append_bins(to, t.first[k]);
  }
  const uint32_t yarns = texels();
  for (const Yarn& yarn : cloth.yarns) {
    for (const interop::vec4& v : yarn_numbers(yarn.lobes))
      append(to, {bits(v[0]), bits(v[1]), bits(v[2]), bits(v[3])});
  }
  const uint32_t blocks = static_cast<uint32_t>((t.count.x + CROSSING_BLOCK - 1) / CROSSING_BLOCK);
  const std::array<uint32_t, 16> head{
      bits(t.count.x), bits(t.count.y), bits(t.bins.x), bits(t.bins.y), bits(t.period.x), bits(t.period.y),
      bits(t.spacing), bits(top_mm),    tables[0],      tables[1],      tables[2],        tables[3],
      yarns,           blocks,          bits(t.even.x), bits(t.even.y)};
  std::copy(head.begin(), head.end(), to.begin());
  const size_t row = size_t{4} * THREAD_MAP_WIDTH;
  to.resize((to.size() + row - 1) / row * row);
  return to;
}

std::vector<uint16_t> packed_crossings(const std::vector<glm::vec4>& crossings) {
  std::vector<uint16_t> out;
  out.reserve(crossings.size() * 4);
  for (const glm::vec4& c : crossings) {
    for (int i = 0; i < 4; ++i) out.push_back(glm::packHalf1x16(c[i]));
  }
  return out;
}

CellRect touched_crossings(const Cloth& cloth, const CellRect& dirty) {
  constexpr int kMargin = kFloatReach + 1;  // of heights, and one more for their slopes
  const int ends = static_cast<int>(cloth.ends.size()), picks = static_cast<int>(cloth.picks.size());
  CellRect r{dirty.end0 - kMargin, dirty.end1 + kMargin, dirty.pick0 - kMargin, dirty.pick1 + kMargin};
  // What leaves the period comes in on its other side: then all of that axis.
  if (r.end0 < 0 || r.end1 > ends) r.end0 = 0, r.end1 = ends;
  if (r.pick0 < 0 || r.pick1 > picks) r.pick0 = 0, r.pick1 = picks;
  return r;
}

}  // namespace weftlight::upload
