// The tabs of the editor: closing them, with a question about unsaved changes, and the actions of their menu.

#include <filesystem>
#include <utility>

#include "app/editor.h"
#include "base/text.h"

namespace weftlight::app {

using base::arg;
using base::fill;
using base::mark;
using base::tr;

void Editor::close(uint64_t id) { close(id, nullptr); }

void Editor::close(uint64_t id, const std::function<void()>& then) {
  const auto closed = [this, id, then] {
    session_.close(id, first_document);
    if (then) then();
  };
  const OpenDocument* open = session_.find(id);
  if (open == nullptr) return;
  if (saver_.saving(id))
    return saver_.after(id, [this, id, then] { when_no_dialog([this, id, then] { close(id, then); }); });
  if (open->document.is_saved()) return closed();
  session_.show(id);
  ask(Question{fill(tr("Save the changes to {draft}?"), arg("draft", open->document.shown_name())),
               tr("Your changes since the last save would be lost."),
               {mark("Save"), mark("Do not save"), mark("Cancel")}},
      [this, id, then, closed](int button) {
        if (button == 1) closed();
        // Again, since there may be edits meanwhile.
        if (button == 0) save_shown([this, id, then] { close(id, then); });
      });
}

void Editor::close_each(std::vector<uint64_t> ids) {
  if (ids.empty()) return;
  const uint64_t id = ids.front();
  ids.erase(ids.begin());
  close(id, [this, ids] { close_each(ids); });
}

void Editor::close_other_tabs() {
  std::vector<uint64_t> ids;
  for (const auto& open : session_.all())
    if (open->id != session_.active().id) ids.push_back(open->id);
  close_each(std::move(ids));
}

void Editor::close_tabs_to_right() {
  std::vector<uint64_t> ids;
  for (size_t i = session_.active_place() + 1; i < session_.all().size(); ++i) ids.push_back(session_.all()[i]->id);
  close_each(std::move(ids));
}

void Editor::duplicate() {
  const std::filesystem::path name = document().name();
  Document copy(document().now());
  copy.without_file(name.stem().string() + "-copy.wif");
  open_beside(std::move(copy), Origin::kOwn);
}

void Editor::reload() {
  if (document().path().empty()) return;
  if (document().is_saved()) return read_again();
  ask(Question{fill(tr("Reload {file}?"), arg("file", document().name())),
               tr("Your changes since the last save would be lost."),
               {mark("Reload"), mark("Cancel")}},
      [this](int button) {
        if (button == 0) read_again();
      });
}

void Editor::show_in_folder() {
  const std::string folder = std::filesystem::absolute(document().path()).parent_path().string();
  if (const std::string missing = platform::show_folder(folder); !missing.empty())
    say(fill(tr("No program shows folders here ({program} is missing). The folder is {folder}"),
             arg("program", missing), arg("folder", folder)));
}

}  // namespace weftlight::app
