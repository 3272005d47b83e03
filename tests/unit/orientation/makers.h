#pragma once
// All that the program shows a weave in, each made from the marked design's file.

#include <functional>

#include "../scratch.h"
#include "paths.h"
#include "seen.h"

namespace weftlight::orientation {

/// Where the file is, and room for what is made of it.
struct Workplace {
  Scratch scratch{"orientation"};
  std::string draft() const { return scratch / "marked.wif"; }
};

/// One kind of picture, in all the ways that it can be asked for. Empty with `skipped` set where it cannot be made
/// here.
struct Maker {
  const char* name;
  std::vector<Seen> (*make)(const Workplace& at, std::string& skipped);
};
inline void PrintTo(const Maker& maker, std::ostream* out) { *out << maker.name; }

// flat_pictures.cpp
std::vector<Seen> drawdowns(const Workplace& at, std::string& skipped);
std::vector<Seen> printed_drafts(const Workplace& at, std::string& skipped);
std::vector<Seen> printed_swatches(const Workplace& at, std::string& skipped);
std::vector<Seen> thumbnails(const Workplace& at, std::string& skipped);
std::vector<Seen> window_drawdowns(const Workplace& at, std::string& skipped);
// texture_pictures.cpp
std::vector<Seen> texture_images(const Workplace& at, std::string& skipped);
std::vector<Seen> texture_previews(const Workplace& at, std::string& skipped);
std::vector<Seen> textured_meshes(const Workplace& at, std::string& skipped);
// cloth_pictures.cpp
std::vector<Seen> rendered_cloths(const Workplace& at, std::string& skipped);
std::vector<Seen> traced_cloths(const Workplace& at, std::string& skipped);

}  // namespace weftlight::orientation
