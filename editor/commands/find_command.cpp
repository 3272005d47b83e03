// `find`: the drafts of a folder that have what is asked for, from the same index as the window's.

#include <cstdio>

#include "base/json.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "base/utf8.h"
#include "collection/colour_names.h"
#include "collection/folder_index.h"
#include "collection/query.h"
#include "commands/commands.h"
#include "commands/status_line.h"
#include "platform/file.h"

namespace weftlight::commands {

using base::arg, base::as_utf8, base::fill, base::tr, base::tr_n;
using collection::DraftEntry, collection::FolderIndex, collection::found_drafts, collection::kColourNames,
    collection::look_through;

namespace {

const char* family_id(const DraftEntry& e) { return analysis::kWeaveFamilyNames[static_cast<size_t>(e.family)].id; }

nlohmann::ordered_json as_json(const DraftEntry& e) {
  nlohmann::ordered_json json = {{"path", as_utf8(e.path)}, {"readable", e.readable}};
  if (!e.readable) return json;
  json.update({{"title", e.title},
               {"author", e.author},
               {"ends", e.ends},
               {"picks", e.picks},
               {"shafts", e.shafts},
               {"treadles", e.treadles},
               {"family", family_id(e)},
               {"colours", nlohmann::ordered_json::array()}});
  for (size_t i = 0; i < kColourNames.size(); ++i)
    if (e.colours >> i & 1) json["colours"].push_back(kColourNames[i].id);
  return json;
}

std::string text_of(const DraftEntry& e) {
  if (!e.readable) return fill(tr("{path}: cannot be read"), arg("path", e.path));
  const std::string shafts = fill(tr_n("{count} shaft", "{count} shafts", e.shafts), arg("count", e.shafts));
  const std::string treadles = fill(tr_n("{count} treadle", "{count} treadles", e.treadles), arg("count", e.treadles));
  const std::string loom =
      e.treadles == 0 ? shafts : fill(tr("{shafts}, {treadles}"), arg("shafts", shafts), arg("treadles", treadles));
  const std::string weave = tr(analysis::kWeaveFamilyNames[static_cast<size_t>(e.family)].label);
  const char* facts = e.title.empty() || e.title == weave ? tr("{path}: {ends} x {picks}, {loom}, {weave}")
                                                          : tr("{path}: {ends} x {picks}, {loom}, {weave}; {title}");
  return fill(facts, arg("path", e.path), arg("ends", e.ends), arg("picks", e.picks), arg("loom", loom),
              arg("weave", weave), arg("title", e.title));
}

void print_found(const FolderIndex& index, const std::vector<int>& found, bool json) {
  if (!json) {
    for (const int i : found) std::printf("%s\n", text_of((*index.entries)[static_cast<size_t>(i)]).c_str());
    return;
  }
  nlohmann::ordered_json out = {{"drafts", nlohmann::ordered_json::array()},
                                {"of", index.entries->size()},
                                {"unread_folders", nlohmann::ordered_json::array()}};
  for (const int i : found) out["drafts"].push_back(as_json((*index.entries)[static_cast<size_t>(i)]));
  for (const std::string& folder : index.unread) out["unread_folders"].push_back(as_utf8(folder));
  std::printf("%s\n", out.dump(1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

}  // namespace

int find_command(const FindOptions& options) {
  if (platform::file_facts(options.folder).kind != platform::FileKind::kFolder)
    return fail({base::ErrorKind::kInput, tr("is not a folder; give a folder of drafts"), options.folder});
  FolderIndex index;
  {
    StatusLine line;
    const base::TaskProgress progress({}, [&line](float, const std::string& said) { line.show(said); });
    index = look_through(options.folder, options.fresh ? "" : collection::index_folder(), progress);
  }
  for (const std::string& folder : index.unread)
    print_problem(fill(tr("{folder}: cannot be read, and is left out"), arg("folder", folder)));
  if (index.left_out > 0)
    print_problem(
        fill(tr_n("{count} more draft is not listed; give a subfolder",
                  "{count} more drafts are not listed; give a subfolder", static_cast<long long>(index.left_out)),
             arg("count", index.left_out)));
  const std::vector<int> found = found_drafts(*index.entries, options.query);
  if (found.empty() && !options.json)
    print_problem(index.entries->empty() ? tr("There are no drafts in this folder.") : tr("No draft matches."));
  print_found(index, found, options.json);
  return kDone;
}

}  // namespace weftlight::commands
