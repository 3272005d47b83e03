#include "app/ui_map_file.h"

#include "base/json.h"
#include "wif/wif.h"

namespace weftlight::app {

using base::write_file_atomically;
using ui::UiControl, ui::UiGrid;

std::string ui_map_json(const UiMap& map, uint64_t frame) {
  nlohmann::ordered_json json = {
      {"frame", frame}, {"controls", nlohmann::json::array()}, {"grids", nlohmann::json::array()}};
  for (const UiControl& c : map.controls)
    json["controls"].push_back({{"name", c.name}, {"x", c.x}, {"y", c.y}, {"w", c.w}, {"h", c.h}});
  for (const UiGrid& g : map.grids)
    json["grids"].push_back({{"name", g.name},
                             {"origin", g.origin},
                             {"step_a", g.step_a},
                             {"step_b", g.step_b},
                             {"count_a", g.count_a},
                             {"count_b", g.count_b}});
  return json.dump(1) + "\n";
}

void UiMapFile::frame(const UiMap& map) {
  ++frame_;
  // A changing layout (a menu that opens, a dialog that finds its size) is not written.
  const bool settled = map == before_;
  before_ = map;
  if (path_.empty() || !settled || map == last_) return;
  if (write_file_atomically(path_, ui_map_json(map, frame_))) last_ = map;
}

}  // namespace weftlight::app
