#pragma once
// The --ui-map file: positions of all controls, rewritten once the layout is stable.

#include <cstdint>
#include <string>

#include "ui/ui_map.h"

namespace weftlight::app {

using ui::UiMap;

std::string ui_map_json(const UiMap& map, uint64_t frame);

class UiMapFile {
 public:
  explicit UiMapFile(std::string path) : path_(std::move(path)) {}
  /// Counts the frame; writes the map if it is stable and has changed.
  void frame(const UiMap& map);

 private:
  std::string path_;
  UiMap last_, before_;
  uint64_t frame_ = 0;
};

}  // namespace weftlight::app
