#pragma once
// Shared by `render` and `reference`: the design with the options of the command line applied, the renderer with the
// design uploaded, and the output file.

#include <memory>
#include <string>

#include "commands/commands.h"
#include "commands/progress_line.h"
#include "commands/status_line.h"
#include "gl/headless_context.h"
#include "gl/renderer.h"

namespace weftlight::commands {

using design::Design, design::Scene;
using files::Image;
using gl::Frame, gl::HeadlessContext, gl::Renderer;

struct PictureSetup {
  Design design;
  std::unique_ptr<HeadlessContext> context;  // outlives the renderer
  std::unique_ptr<Renderer> renderer;

  StatusLine status;
  ProgressForm progress = ProgressForm::kTerminal;

  /// Return an exit code of the contract; problems are printed. open() does both of the others.
  int open(const PictureOptions& options);
  /// Reads the design and opens the renderer.
  int read(const PictureOptions& options);
  /// Uploads the design. cloth: false if it is not drawn, nor does the exposure depend on it.
  int upload(bool cloth = true);
  Frame frame(const PictureOptions& options) const;

 private:
  std::string draft_;  // the path of what was read
  int open_graphics();
};

/// The scene with the mesh of the options, which is framed as a whole if it is another: the draft's view is of its own.
/// A view that was asked for stays.
Scene on_mesh(Scene scene, const PictureOptions& options);

/// True for .exr, which holds scene-linear values; a .png is tone mapped.
bool writes_linear(const std::string& path);
base::Result<void> write_picture(const std::string& path, const Image& image);

}  // namespace weftlight::commands
