// Versions of a design in its file: the sections of each, as they would stand in a new file, under names of their own.
// A version does not lean on the public sections, which other programs may change; but a section that an earlier
// version has just so is not written again (docs/decisions/versions-stand-alone.md).

#include "design/versions.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/text.h"
#include "wif/design_sections.h"
#include "wif/encoding.h"
#include "wif/numbers.h"
#include "wif/private.h"

namespace weftlight::wif {

using base::arg, base::fill, base::tr;
using design::grid_cells, design::kMaxVersionCells, design::kMaxVersions, design::unused_version_name,
    design::version_name, design::version_of;

namespace {

/// "PRIVATE WEFTLIGHT VERSION 2"
std::string head_name(size_t number) { return std::string(kVersion).append(std::to_string(number)); }

/// The sections of one version in a file, by their names in a draft.
struct Parts {
  const WifSection* head = nullptr;
  std::map<std::string_view, const WifSection*> sections;

  const WifSection* find(std::string_view name) const {
    const auto found = sections.find(name);
    return found != sections.end() ? found->second : nullptr;
  }
};

/// By number, from 1.
std::map<int, Parts> parts_of(const WifText& text) {
  std::map<int, Parts> all;
  for (const WifSection& section : text.sections) {
    std::string_view rest = section.name;
    if (!is_version_section(rest)) continue;
    rest.remove_prefix(kVersion.size());
    const size_t blank = std::min(rest.find(' '), rest.size());
    const int number = leading_int(rest.substr(0, blank)).value_or(0);
    if (number < 1 || static_cast<size_t>(number) > kMaxVersions) continue;
    const std::string_view name = rest.substr(std::min(blank + 1, rest.size()));
    if (name.empty()) all[number].head = &section;
    else if (!is_version_section(name)) all[number].sections.emplace(name, &section);
  }
  return all;
}

void append_lines(std::string& bytes, const WifText& text, std::string_view name, const WifSection& section) {
  bytes.append("[").append(name).append("]\n");
  for (const WifSection::Block& block : section.blocks)
    for (int line = block.first; line < block.end; ++line)
      bytes.append(to_utf8(text.line(line), text.encoding)).append("\n");
}

/// The version as a file of its own.
std::string bytes_of(const WifText& text, const std::map<int, Parts>& all, const Parts& parts) {
  std::string bytes = "[WIF]\nVersion=1.1\n";
  for (const auto& [name, section] : parts.sections) append_lines(bytes, text, name, *section);
  for (const WifKey& key : parts.head->keys) {
    const std::string name = uppercase(key.key), suffix = uppercase(kSameAsIn);
    if (!name.ends_with(suffix)) continue;
    const std::string_view shared = std::string_view(name).substr(0, name.size() - suffix.size());
    const auto earlier = all.find(leading_int(key.value).value_or(0));
    const WifSection* section = earlier != all.end() ? earlier->second.find(shared) : nullptr;
    if (section && !parts.find(shared)) append_lines(bytes, text, shared, *section);
    if (bytes.size() > kMaxDraftBytes) break;
  }
  return bytes;
}

}  // namespace

void read_versions(const WifText& text, Diagnostics& diagnostics, Design& design) {
  const std::map<int, Parts> all = parts_of(text);
  uint64_t bytes_left = kMaxDraftBytes;
  int64_t cells_left = kMaxVersionCells;
  for (const auto& [number, parts] : all) {
    if (!parts.head) continue;
    const std::string bytes = bytes_of(text, all, parts);
    const bool fits = bytes.size() <= bytes_left;
    Diagnostics own;
    std::optional<ParsedWif> parsed = fits ? parse_wif(bytes, own) : std::nullopt;
    if (!parsed || grid_cells(parsed->design.draft) > cells_left) {
      diagnostics.warn(parts.head->blocks.front().header, "version",
                       fill(tr("version {number} of the draft cannot be read"), arg("number", number)),
                       tr("left out; its lines are kept while the other versions are not changed"));
      if (parsed || !fits) return;  // too large; so would be the others
      continue;
    }
    bytes_left -= bytes.size(), cells_left -= grid_cells(parsed->design.draft);
    const WifKey* name = parts.head->find("Name");
    std::string words = name ? version_name(unescaped(to_utf8(name->value, text.encoding))) : std::string();
    if (words.empty()) words = fill(tr("Version {number}"), arg("number", number));
    design.versions.push_back(
        {unused_version_name(design.versions, words), std::make_shared<const Design>(version_of(parsed->design))});
  }
}

bool is_version_section(std::string_view name) { return name.starts_with(kVersion); }

std::vector<WifEntries> version_lines(const WifText& text) {
  std::vector<WifEntries> out;
  for (const WifSection& section : text.sections) {
    if (!is_version_section(section.name)) continue;
    WifEntries& lines = out.emplace_back(WifEntries{section.name, {}});
    for (const WifKey& key : section.keys)
      lines.entries.push_back({key.number, key.number < 0 ? std::string(key.key) : std::string(),
                               to_utf8(key.value, text.encoding), false});
    std::stable_sort(lines.entries.begin(), lines.entries.end(),
                     [](const WifEntry& a, const WifEntry& b) { return a.number < b.number; });
  }
  return out;
}

void append_versions(std::vector<WifEntries>& out, const Design& design) {
  std::map<std::string, std::vector<std::pair<size_t, size_t>>> owners;  // by name: number of a version, place in `out`
  for (size_t i = 0; i < design.versions.size(); ++i) {
    WifEntries head{head_name(i + 1), {{-1, "Name", escaped(design.versions[i].name), true}}};
    std::vector<WifEntries> own;
    for (WifEntries& section : new_file_sections(*design.versions[i].design)) {
      auto& earlier = owners[section.name];
      const auto same = std::find_if(earlier.begin(), earlier.end(),
                                     [&](const auto& owner) { return out[owner.second].entries == section.entries; });
      if (same != earlier.end()) {
        head.entries.push_back({-1, std::string(section.name).append(kSameAsIn), std::to_string(same->first), false});
        continue;
      }
      earlier.emplace_back(i + 1, out.size() + 1 + own.size());
      section.name = std::string(head.name).append(" ").append(section.name);
      own.push_back(std::move(section));
    }
    out.push_back(std::move(head));
    std::move(own.begin(), own.end(), std::back_inserter(out));
  }
}

}  // namespace weftlight::wif
