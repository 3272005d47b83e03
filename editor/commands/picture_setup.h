#pragma once
// What `render` and `reference` share: the design with the command line's options in it, the renderer with
// everything uploaded, and the file that comes out.

#include <memory>
#include <string>

#include "commands/commands.h"
#include "commands/names.h"
#include "commands/status_line.h"
#include "gl/context.h"
#include "gl/renderer.h"

namespace weftlight::commands {

struct PictureSetup {
  Design design;
  std::unique_ptr<HeadlessContext> context;  // outlives the renderer
  std::unique_ptr<Renderer> renderer;

  StatusLine status;  // what it is at, on a terminal

  /// An exit code of the contract; what went wrong is printed.
  int open(const PictureOptions& options);
  Frame frame(const PictureOptions& options) const;
};

/// .exr holds scene-linear values, .png the finished picture.
bool writes_linear(const std::string& path);
/// Empty: done; else what went wrong.
std::string write_picture(const std::string& path, const Image& image);

}  // namespace weftlight::commands
