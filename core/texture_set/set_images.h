#pragma once
// The images of a set: every row of a target's table packed band by band, and what the list and the contact sheet say
// of them.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "texture_set/contact_sheet.h"
#include "texture_set/face_source.h"
#include "texture_set/mip_images.h"
#include "texture_set/names.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

/// A set while it is written: what the sheet and the list will say.
struct SetImages {
  std::string folder, name;
  ExportTarget target = ExportTarget::kGltf;
  nlohmann::json maps = nlohmann::json::array();
  std::vector<SheetEntry> sheet;
  std::string problem;  // empty until something goes wrong; then nothing more is written
  // Told after each band: 0..1 of the face that is written. False: nobody wants the set any more.
  std::function<bool(float share)> going{};
  std::optional<MipContainer> mips{};
  Alpha alpha = Alpha::kAuto;  // as it was asked for
};

/// Between the name and the suffix of a file: "" or "_front" of the front, "_back" of the back.
std::string face_suffix(ExportTarget target, Face face);
/// File of a row's image.
std::string image_file(const ImageRow& row, const std::string& name, Face face);

/// All images of a face.
void write_face(SetImages& set, const FaceSource& source, Face face);

}  // namespace weftlight::texture_set
