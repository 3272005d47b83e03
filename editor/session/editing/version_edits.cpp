#include "session/editing/version_edits.h"

#include <cstddef>
#include <utility>

#include "base/text.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr, base::tr_n;
using design::at_version, design::current_version, design::has_room_for_version, design::is_colourway,
    design::version_name, design::with_renamed_version, design::with_version, design::without_version;

Edit keep_version_edit(const std::string& name) {
  Edit edit{fill(tr("Save version {name}"), arg("name", version_name(name))),
            [name](Design d) { return with_version(std::move(d), name); }};
  edit.why = [name](const Design& d) -> std::string {
    if (version_name(name).empty()) return tr("A version needs a name.");
    if (!has_room_for_version(d)) return tr("There is no room for another version in this draft. Delete one first.");
    return tr("This version is already saved.");
  };
  return edit;
}

MaybeEdit go_to_version_edit(const Design& design, const Version& version) {
  const Version* now = current_version(design);
  if (now && *now->design == *version.design) return {};
  return Edit{fill(tr("Restore version {name}"), arg("name", version.name)),
              [version](Design d) { return at_version(std::move(d), version); }};
}

Edit rename_version_edit(size_t version, const std::string& name) {
  return {tr("Rename version"),
          [version, name](Design d) { return with_renamed_version(std::move(d), version, name); }};
}

Edit delete_version_edit(const Design& design, size_t version) {
  return {fill(tr("Delete version {name}"), arg("name", design.versions.at(version).name)),
          [version](Design d) { return without_version(std::move(d), version); }};
}

const Version* next_version(const Design& design, int step) {
  if (design.versions.empty()) return nullptr;
  const Version* now = current_version(design);
  if (!now) return step > 0 ? &design.versions.front() : &design.versions.back();
  const auto count = static_cast<std::ptrdiff_t>(design.versions.size());
  const auto at = now - design.versions.data();
  return &design.versions[static_cast<size_t>((at + step + count) % count)];
}

std::string version_words(const Design& now, const Version& version) {
  if (current_version(now) == &version) return tr("same as the current draft");
  if (is_colourway(now, *version.design)) return tr("other colours");
  const draft::Draft& draft = version.design->draft;
  if (draft.ends() == now.draft.ends() && draft.picks() == now.draft.picks()) return tr("another weave");
  return fill(tr("{ends}, {picks}"),
              arg("ends", fill(tr_n("{count} end", "{count} ends", draft.ends()), arg("count", draft.ends()))),
              arg("picks", fill(tr_n("{count} pick", "{count} picks", draft.picks()), arg("count", draft.picks()))));
}

}  // namespace weftlight::session
