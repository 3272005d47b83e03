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

/// A program that the driver may still be compiling on threads of its own (GL_KHR_parallel_shader_compile).
class CompilingProgram {
 public:
  /// Hands the given vertex and fragment shader to the driver. An error when a file is missing.
  static base::Result<CompilingProgram> begin(const std::string& vert, const std::string& frag,
                                              const std::vector<std::string>& defines);
  /// Whether finished() waits no more; true where the driver compiles on this thread.
  bool is_done() const;
  /// The linked program, its samplers and blocks bound, or why it does not compile. Waits; called once.
  base::Result<GlProgram> finished();

 private:
  std::string vert_name_, frag_name_;
  GlVertexShader vert_;
  GlFragmentShader frag_;
  GlProgram program_;
};

/// Compiles and links into `program`, and waits for it.
base::Result<void> build_into(GlProgram& program, const std::string& vert, const std::string& frag,
                              const std::vector<std::string>& defines);

}  // namespace weftlight::gl
