#pragma once
// Whether pictures show anything beside the cloth.

namespace weftlight::commands {

struct PictureOptions;

enum class Backdrop { kShown, kTransparent };

int render_command(const PictureOptions& options, Backdrop backdrop);
int reference_command(const PictureOptions& options, Backdrop backdrop);

}  // namespace weftlight::commands
