// Views of the cloth: drape or flat swatch, and named views.

#include <algorithm>
#include <utility>

#include "app/editor.h"
#include "base/text.h"
#include "session/scene_views.h"

namespace weftlight::app {

using base::mark;
using base::tr;

void Editor::reset_view() {
  const Design& d = document().now();
  view().cloth.camera = view().cloth.flat ? flat_orbit(d, pane_.x, pane_.y) : orbit_of(d.scene);
}

void Editor::toggle_flat() {
  DocumentView& v = view();
  v.cloth.flat = !v.cloth.flat;
  if (v.cloth.flat) v.cloth.draped = v.cloth.camera;
  v.cloth.camera = v.cloth.flat ? flat_orbit(document().now(), pane_.x, pane_.y) : v.cloth.draped;
  preview_.submit(hung());
  frames_due_ = std::max(frames_due_, 3);
}

bool Editor::update_drape() {
  const Draper::News news = draper_.take_news();
  if (!news.said.empty()) say(news.said);
  if (news.draped) preview_.submit(hung());
  return news.any;
}

std::shared_ptr<const Design> Editor::hung() const {
  if (!view().cloth.flat) return document().snapshot();
  Design flat = document().now();
  flat.scene.mesh = kFlatMesh;
  return std::make_shared<const Design>(std::move(flat));
}

void Editor::keep_view() {
  if (view().cloth.flat)
    return say(tr("The flat swatch has one view. Press F for the drape, whose view can be saved."));
  commit({tr("Save view"), [camera = view().cloth.camera](Design d) {
            d.scene = with_orbit(d.scene, camera);
            return d;
          }});
}

void Editor::go_to_view(const std::string& name) {
  const std::optional<NamedView> to = view_named(document().now(), name, pane_.x, pane_.y);
  if (!to) return say(tr("There is no view of that name."));
  const MaybeEdit edit = session::go_to_view(view().cloth, document().now(), *to);
  if (edit) commit(*edit);
  preview_.submit(hung());
  frames_due_ = std::max(frames_due_, 3);
}

void Editor::keep_view_as() {
  ask(NamePrompt{tr("Save this view"), tr("Drape, light and camera are saved with the draft."),
                 free_view_name(document().now()), mark("Save")},
      [this](int) {
        commit(keep_view_edit(view().cloth, std::get<NamePrompt>(dialog_).name));
        say(tr("Saved with the draft. Find it in View, Views of the cloth."));
      });
}

void Editor::change_views() {
  NamesPrompt prompt{tr("Views of the cloth"), {}, {}};
  for (const NamedView& v : document().now().views) prompt.names.push_back(v.name);
  prompt.before = prompt.names;
  ask(std::move(prompt), [this](int) { commit(rename_views_edit(std::get<NamesPrompt>(dialog_).names)); });
}

}  // namespace weftlight::app
