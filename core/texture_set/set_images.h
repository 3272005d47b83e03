#pragma once
// The images of a set: the rows of its target are packed band by band and recorded for the list and the contact
// sheet.

#include <functional>
#include <string>
#include <vector>

#include "base/json.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/export_target.h"
#include "texture_set/face_source.h"
#include "texture_set/material_files.h"
#include "texture_set/mip_images.h"

namespace weftlight::texture_set {

using draft::Face;

/// A set while it is written, with the records for the contact sheet and the list.
struct SetImages {
  std::string folder, name;
  const ExportTarget& target;
  nlohmann::json maps = nlohmann::json::array();
  std::vector<SheetEntry> sheet;
  // Called after each band with the fraction of the face that is written. False stops the export.
  std::function<bool(float fraction)> keep_going{};
  MipChoice mips{};
  Alpha alpha = Alpha::kAuto;  // as requested
  Constants constants{};       // of the images that turned out to be constant
  nlohmann::json factors = nlohmann::json::array();
  Image swatch{};                            // of the contact sheet
  std::array<EmbeddedImages, 2> embedded{};  // by face, of targets that have them
  std::array<double, 2> white_scale{1, 1};   // by face, of the images for recolouring
};

/// Writes all images of a face, whose horizons are released. kCancelled if keep_going() stopped it.
base::Result<void> write_face(SetImages& set, FaceSource& source, Face face);

}  // namespace weftlight::texture_set
