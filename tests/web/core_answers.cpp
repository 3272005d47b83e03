// What core makes of drafts, one line for each: core_answers FILE... The same program is built for browsers and for the
// desktop, and `./check web` compares the lines: a draft is read, written, woven and drawn alike in both.

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "base/hash.h"
#include "cloth/maps.h"
#include "draft/drawdown.h"
#include "wif/wif.h"

namespace weftlight {
namespace {

using base::content_hash;

template <class T>
uint64_t hash_of(const T* values, size_t count, uint64_t from) {
  return content_hash({reinterpret_cast<const char*>(values), count * sizeof(T)}, from);
}

uint64_t hash_of(const draft::BitMatrix& cells) {
  uint64_t hash = content_hash({});
  for (int r = 0; r < cells.rows(); ++r) hash = hash_of(cells.row(r).data(), cells.row(r).size(), hash);
  return hash;
}

/// Of the heights and slopes in thousandths of a millimetre: the last bit of a square root may differ between machines.
uint64_t hash_of(const cloth::Maps& maps) {
  uint64_t hash = content_hash({});
  for (const float height : maps.height_mm.at_) {
    const auto rounded = static_cast<int32_t>(height * 1000 + 1000.5f);
    hash = hash_of(&rounded, 1, hash);
  }
  return hash_of(maps.thread.at_.data(), maps.thread.at_.size(), hash);
}

void answer(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const wif::WifRead read = wif::read_wif(bytes);
  const std::string name = path.substr(path.find_last_of('/') + 1);
  if (!read.file) {
    std::printf("%s: %s\n", name.c_str(), message(read.file.error()).c_str());
    return;
  }
  const design::Design& design = read.file->design;
  const draft::BitMatrix cells = draft::drawdown(design.draft);
  const cloth::Cloth laid = cloth::lay_out(design, cells, draft::Face::kFront, cloth::Period::kRepeat);
  const cloth::Maps maps = cloth::bake(laid, {.width = 64, .height = 64, .azimuths = 4});
  const bool same = wif::write_wif(*read.file, design) == bytes;
  std::printf("%s: %d remarks, written back %s, new %016llx, plain %016llx, drawdown %016llx, maps %016llx\n",
              name.c_str(), static_cast<int>(read.diagnostics.size()), same ? "alike" : "changed",
              static_cast<unsigned long long>(content_hash(wif::write_new_wif(design))),
              static_cast<unsigned long long>(content_hash(wif::write_plain_wif(design))),
              static_cast<unsigned long long>(hash_of(cells)), static_cast<unsigned long long>(hash_of(maps)));
}

}  // namespace
}  // namespace weftlight

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) weftlight::answer(argv[i]);
}
