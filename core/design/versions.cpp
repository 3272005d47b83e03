#include "design/versions.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "base/utf8.h"

namespace weftlight::design {

using base::arg, base::cut_utf8, base::fill, base::tr;

namespace {

bool is_taken(const std::vector<Version>& versions, const std::string& name) {
  return std::ranges::find(versions, name, &Version::name) != versions.end();
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

int64_t cells_of(const std::vector<Version>& versions) {
  int64_t sum = 0;
  for (const Version& version : versions) sum += grid_cells(version.design->draft);
  return sum;
}

/// Moves what a version keeps.
void move_woven(Design& to, Design&& from) {
  to.draft = std::move(from.draft);
  to.yarns = std::move(from.yarns);
  to.finish = from.finish;
  to.plan = std::move(from.plan);
  to.weaves = std::move(from.weaves);
  to.warp_assembly = std::move(from.warp_assembly), to.weft_assembly = std::move(from.weft_assembly);
  to.loom.leading = from.loom.leading, to.loom.locked = from.loom.locked;
}

bool same_but_color(const Threads& a, const Threads& b) {
  return a.spacing_mm == b.spacing_mm && a.thickness_mm == b.thickness_mm && a.yarn == b.yarn;
}

}  // namespace

int64_t grid_cells(const Draft& draft) {
  int64_t sum = 0;
  for (const BitMatrix* grid : {&draft.threading, &draft.tieup, &draft.treadling, &draft.liftplan})
    sum += int64_t{grid->rows()} * grid->cols();
  return sum;
}

Design version_of(const Design& design) {
  Design kept;
  move_woven(kept, Design(design));
  return kept;
}

bool has_room_for_version(const Design& design) {
  return design.versions.size() < kMaxVersions &&
         cells_of(design.versions) + grid_cells(design.draft) <= kMaxVersionCells;
}

std::string version_name(std::string_view typed) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t first = typed.find_first_not_of(kBlanks), last = typed.find_last_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  const std::string_view cut = cut_utf8(typed.substr(first, last - first + 1), kLongestVersionName);
  return std::string(cut.substr(0, cut.find_last_not_of(kBlanks) + 1));
}

Design with_version(Design design, std::string_view name) {
  Version kept{version_name(name), nullptr};
  if (kept.name.empty()) return design;
  const auto same = std::ranges::find(design.versions, kept.name, &Version::name);
  if (same == design.versions.end() && !has_room_for_version(design)) return design;
  kept.design = std::make_shared<const Design>(version_of(design));
  if (same != design.versions.end()) *same = std::move(kept);
  else design.versions.push_back(std::move(kept));
  return design;
}

Design at_version(Design design, const Version& version) {
  move_woven(design, Design(*version.design));
  return design;
}

Design with_renamed_version(Design design, size_t version, std::string_view name) {
  const std::string wanted = version_name(name);
  if (wanted.empty() || version >= design.versions.size() || design.versions[version].name == wanted) return design;
  design.versions[version].name = unused_version_name(design.versions, wanted);
  return design;
}

Design without_version(Design design, size_t version) {
  if (version < design.versions.size())
    design.versions.erase(design.versions.begin() + static_cast<std::ptrdiff_t>(version));
  return design;
}

std::string unused_version_name(const std::vector<Version>& versions, const std::string& name) {
  std::string out = name;
  for (int n = 2; is_taken(versions, out); ++n) {
    const std::string number = std::to_string(n);
    out = std::string(cut_utf8(name, kLongestVersionName - 1 - number.size())).append(" ").append(number);
  }
  return out;
}

std::string free_version_name(const Design& design) {
  for (size_t n = design.versions.size() + 1;; ++n)
    if (std::string name = fill(tr("Version {number}"), arg("number", n)); !is_taken(design.versions, name))
      return name;
}

const Version* version_named(const Design& design, std::string_view name) {
  const auto same = [&](const Version& v) {
    return std::equal(v.name.begin(), v.name.end(), name.begin(), name.end(),
                      [](char a, char b) { return lower(a) == lower(b); });
  };
  auto found = std::ranges::find(design.versions, name, &Version::name);
  if (found == design.versions.end()) found = std::find_if(design.versions.begin(), design.versions.end(), same);
  return found != design.versions.end() ? &*found : nullptr;
}

const Version* current_version(const Design& design) {
  const auto is_now = [&](const Version& v) {
    const Design& d = *v.design;
    return d.draft == design.draft && d.yarns == design.yarns && d.finish == design.finish && d.plan == design.plan &&
           d.weaves == design.weaves && d.warp_assembly == design.warp_assembly &&
           d.weft_assembly == design.weft_assembly && d.loom.leading == design.loom.leading &&
           d.loom.locked == design.loom.locked;
  };
  const auto found = std::find_if(design.versions.begin(), design.versions.end(), is_now);
  return found != design.versions.end() ? &*found : nullptr;
}

bool is_colourway(const Design& a, const Design& b) {
  const Draft &x = a.draft, &y = b.draft;
  return a.yarns == b.yarns && a.finish == b.finish && x.shafts == y.shafts && x.treadles == y.treadles &&
         x.rising == y.rising && x.shed_control == y.shed_control && x.threading == y.threading && x.tieup == y.tieup &&
         x.treadling == y.treadling && x.liftplan == y.liftplan && same_but_color(x.warp, y.warp) &&
         same_but_color(x.weft, y.weft);
}

}  // namespace weftlight::design
