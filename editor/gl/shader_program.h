#pragma once
// Loads shaders from shaders/: #include is resolved by text, options become #defines, and samplers and uniform blocks
// are bound to the slots of shaders/interop.h.

#include <string>
#include <vector>

#include "base/result.h"
#include "gl/gl_objects.h"

namespace weftlight::gl {

/// `text` with its includes resolved, each file once. An error when a file is missing.
base::Result<std::string> with_includes(const std::string& text);

/// The text of a shader file with includes resolved and defines after #version. Where a define says "METHOD name",
/// METHOD in an included file's name is that name. An error when a file is missing.
base::Result<std::string> shader_text(const std::string& file, const std::vector<std::string>& defines);

/// Compiles and links the given vertex and fragment shader.
base::Result<GlProgram> build_program(const std::string& vert, const std::string& frag,
                                      const std::vector<std::string>& defines);
/// The same into `program`.
base::Result<void> build_into(GlProgram& program, const std::string& vert, const std::string& frag,
                              const std::vector<std::string>& defines);

}  // namespace weftlight::gl
