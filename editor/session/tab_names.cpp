#include "session/tab_names.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"

namespace weftlight::session {

using base::tr;

namespace {

bool has_file(const OpenDocument& open) { return !open.document.path().empty(); }

}  // namespace

std::vector<std::string> tab_names(const Session& session) {
  const auto& all = session.all();
  std::vector<std::string> plain;
  for (const auto& open : all) plain.push_back(open->document.shown_name());
  std::vector<std::string> names = plain;
  for (size_t i = 0; i < all.size(); ++i) {
    size_t same = 0, earlier = 0;
    for (size_t other = 0; other < all.size(); ++other) {
      if (plain[other] != plain[i]) continue;
      ++same;
      if (!has_file(*all[other]) && all[other]->id < all[i]->id) ++earlier;
    }
    const std::filesystem::path folder = std::filesystem::path(all[i]->document.path()).parent_path();
    if (same > 1 && !folder.empty()) names[i] += " \xE2\x80\x93 " + folder.filename().string();
    if (!has_file(*all[i]) && earlier > 0) names[i] += " " + std::to_string(earlier + 1);
  }
  return names;
}

std::string tab_name(const Session& session, uint64_t id) {
  const auto& all = session.all();
  const auto at = std::ranges::find_if(all, [id](const auto& open) { return open->id == id; });
  return at == all.end() ? std::string() : tab_names(session)[static_cast<size_t>(at - all.begin())];
}

std::string loss_text(const Session& session, std::span<const uint64_t> unsaved) {
  const bool in_files = std::ranges::all_of(unsaved, [&](uint64_t id) {
    const OpenDocument* open = session.find(id);
    return open == nullptr || has_file(*open);
  });
  if (in_files) return tr("Your changes since the last save would be lost.");
  return unsaved.size() == 1 ? tr("It has not been saved yet and would be lost.")
                             : tr("Whatever has not been saved would be lost.");
}

}  // namespace weftlight::session
