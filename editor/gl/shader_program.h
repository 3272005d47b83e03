#pragma once
// Loads shaders from shaders/: #include is resolved by text, options become #defines, and samplers and uniform blocks
// are bound to the slots of shaders/interop.h.

#include <string>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/names.h"

namespace weftlight::gl {

/// `text` with its includes resolved, each file once. Empty with `error` set when a file is missing.
std::string with_includes(const std::string& text, std::string& error);

/// The text of a shader file with includes resolved and defines after #version. Where a define says "METHOD name",
/// METHOD in an included file's name is that name. Empty with `error` set when a file is missing.
std::string shader_text(const std::string& file, const std::vector<std::string>& defines, std::string& error);

/// Compiles and links the given vertex and fragment shader. Its name() is 0 with `error` set on failure.
GlProgram build_program(const std::string& vert, const std::string& frag, const std::vector<std::string>& defines,
                        std::string& error);

}  // namespace weftlight::gl
