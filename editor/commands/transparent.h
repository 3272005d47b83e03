#pragma once
// Pictures of the cloth over nothing.

#include "commands/backdrop.h"
#include "commands/picture_setup.h"

namespace weftlight::commands {

/// PictureSetup::frame(), without backdrop and ground if they are not shown.
Frame frame_over(const PictureSetup& setup, const PictureOptions& options, Backdrop backdrop);
/// Writes the renderer's last picture, or says why there is none. It is premultiplied by its alpha. A transparent .png
/// keeps the alpha, with colours that are not premultiplied, as that format demands.
base::Result<void> write_drawn(const std::string& path, gl::Renderer& renderer, Backdrop backdrop);
/// The same of an image that more was laid over.
base::Result<void> write_picture(const std::string& path, const Image& image, Backdrop backdrop);

}  // namespace weftlight::commands
