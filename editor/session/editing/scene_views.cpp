#include "session/editing/scene_views.h"

#include <algorithm>

#include "base/text.h"
#include "base/utf8.h"

namespace weftlight::session {

using base::arg, base::cut_utf8, base::fill, base::tr;

namespace {

bool is_taken(const std::vector<NamedView>& views, const std::string& name) {
  return std::ranges::any_of(views, [&](const NamedView& v) { return v.name == name; });
}

std::string cleaned(const std::string& name) {
  const size_t first = name.find_first_not_of(" \t"), last = name.find_last_not_of(" \t");
  return first == std::string::npos ? ""
                                    : std::string(cut_utf8(name.substr(first, last - first + 1), kLongestViewName));
}

std::string numbered_name(const std::vector<NamedView>& views, const std::string& name, int from) {
  for (int n = from;; ++n)
    if (std::string numbered = name + " " + std::to_string(n); !is_taken(views, numbered)) return numbered;
}

}  // namespace

Scene seen_scene(const ClothView& view, const Design& design) {
  Scene scene = with_orbit(design.scene, view.camera);
  if (!view.flat) return scene;
  scene.mesh = scene::kFlatMesh;
  return view.grazing ? scene::lit_grazing(scene) : scene;
}

std::string free_view_name(const Design& design) {
  return numbered_name(design.views, tr("View"), static_cast<int>(design.views.size()) + 1);
}

Edit keep_view_edit(const ClothView& view, std::string name) {
  name = cleaned(name);
  return {fill(tr("Save view {name}"), arg("name", name)),
          [name, camera = view.camera, flat = view.flat, grazing = view.grazing](Design d) {
            if (name.empty()) return d;
            const Scene scene = flat && grazing ? scene::lit_grazing(d.scene) : d.scene;
            const NamedView kept{name, with_orbit(scene, camera), flat};
            const auto same = std::ranges::find(d.views, name, &NamedView::name);
            if (same != d.views.end()) *same = kept;
            else if (d.views.size() < kMaxKeptViews) d.views.push_back(kept);
            return d;
          }};
}

MaybeEdit go_to_view(ClothView& view, const Design& design, const NamedView& to) {
  if (to.flat && !view.flat) view.draped = view.camera;
  view.flat = to.flat;
  view.grazing = false;  // the saved scene includes its light
  view.true_distance = false;
  view.camera = orbit_of(to.scene);
  // The camera that a draft opens with does not change.
  const Scene scene = with_orbit(to.scene, orbit_of(design.scene));
  if (scene == design.scene) return {};
  return Edit{fill(tr("Go to view {name}"), arg("name", to.name)), [scene](Design d) {
                d.scene = with_orbit(scene, orbit_of(d.scene));
                return d;
              }};
}

Edit rename_views_edit(std::vector<std::string> names) {
  return {tr("Change views"), [names = std::move(names)](Design d) {
            std::vector<NamedView> kept;
            for (size_t i = 0; i < d.views.size(); ++i) {
              NamedView view = d.views[i];
              if (i < names.size()) view.name = cleaned(names[i]);
              if (view.name.empty()) continue;
              if (is_taken(kept, view.name)) view.name = numbered_name(kept, view.name, 2);
              kept.push_back(std::move(view));
            }
            d.views = std::move(kept);
            return d;
          }};
}

}  // namespace weftlight::session
