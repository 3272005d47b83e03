#include "gl/shader_program.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>

#include "base/resources.h"
#include "base/text.h"
#include "shaders/interop.h"

namespace weftlight::gl {

using base::ErrorKind, base::Result, base::arg, base::failed, base::failure, base::fill, base::shaders_dir, base::tr;

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMethodWord = "METHOD";

struct Loader {
  fs::path folder;
  std::string method;  // for METHOD in an included name
  std::set<std::string> seen;
  std::string error;

  std::string file(const std::string& name);
  std::string resolved(std::istream& in);
};

/// The text of a file with its includes, each once.
std::string Loader::file(const std::string& name) {
  if (!seen.insert(name).second) return {};
  std::ifstream in(folder / name);
  if (in) return resolved(in);
  error = fill(tr("{file}: shader file missing; set WEFTLIGHT_SHADERS to the folder of shaders"),
               arg("file", (folder / name).string()));
  return {};
}

std::string Loader::resolved(std::istream& in) {
  std::string line, out;
  while (error.empty() && std::getline(in, line)) {
    if (line.rfind("#pragma once", 0) == 0) continue;
    if (line.rfind("#include \"", 0) == 0) {
      std::string name = line.substr(10, line.find('"', 10) - 10);
      if (const size_t at = name.find(kMethodWord); at != std::string::npos)
        name.replace(at, kMethodWord.size(), method);
      out += file(name);
      continue;
    }
    out += line;
    out += '\n';
  }
  return out;
}

/// The method name in the define of cloth.frag, "METHOD yarn".
std::string method_of(const std::vector<std::string>& defines) {
  for (const std::string& define : defines)
    if (define.rfind(std::string(kMethodWord) + " ", 0) == 0) return define.substr(kMethodWord.size() + 1);
  return {};
}

/// Asks for no status: that would wait for the driver.
void compile(GLuint shader, const std::string& text) {
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
}

Result<void> compiled(GLuint shader, const std::string& name) {
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return {};
  char log[4096] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  return failure(ErrorKind::kGraphics,
                 fill(tr("{file} does not compile: {log}"), arg("file", name), arg("log", std::string(log))));
}

void bind_slots(GLuint program) {
  glUseProgram(program);
  for (int slot = 0; slot < kSamplerCount; ++slot) {
    const GLint at = glGetUniformLocation(program, kSamplerNames[slot]);
    if (at >= 0) glUniform1i(at, slot);
  }
}

/// Checks the block size of the driver against the C++ struct (interop.h asserts the offsets).
Result<void> bind_block(GLuint program, const char* name, GLuint binding, size_t bytes) {
  const GLuint block = glGetUniformBlockIndex(program, name);
  if (block == GL_INVALID_INDEX) return {};
  glUniformBlockBinding(program, block, binding);
  GLint size = 0;
  glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  if (static_cast<size_t>(size) == bytes) return {};
  return failure(
      ErrorKind::kGraphics,
      fill(
          tr("{block}: the driver lays it out in {driver} bytes, the program in {program}; update the graphics driver"),
          arg("block", name), arg("driver", size), arg("program", bytes)));
}

}  // namespace

Result<std::string> with_includes(const std::string& text) {
  Loader loader{shaders_dir(), {}, {}, {}};
  std::istringstream in(text);
  std::string resolved = loader.resolved(in);
  if (!loader.error.empty()) return failure(ErrorKind::kGraphics, loader.error);
  return resolved;
}

Result<std::string> shader_text(const std::string& file, const std::vector<std::string>& defines) {
  std::string text = opengl::kShaderHead;
  for (const std::string& define : defines) text += "#define " + define + "\n";
  Loader loader{shaders_dir(), method_of(defines), {}, {}};
  text += loader.file(file);
  if (!loader.error.empty()) return failure(ErrorKind::kGraphics, loader.error);
  return text;
}

Result<CompilingProgram> CompilingProgram::begin(const std::string& vert, const std::string& frag,
                                                 const std::vector<std::string>& defines) {
  const Result<std::string> vert_text = shader_text(vert, defines);
  if (!vert_text) return failed(vert_text);
  const Result<std::string> frag_text = shader_text(frag, defines);
  if (!frag_text) return failed(frag_text);
  CompilingProgram begun;
  begun.vert_name_ = vert, begun.frag_name_ = frag;
  compile(begun.vert_.get(), *vert_text);
  compile(begun.frag_.get(), *frag_text);
  const GLuint program = begun.program_.get();
  glAttachShader(program, begun.vert_.get());
  glAttachShader(program, begun.frag_.get());
  for (GLuint slot = 0; slot < kAttributeCount; ++slot) glBindAttribLocation(program, slot, kAttributeNames[slot]);
  opengl::name_output(program, "out_color");
  glLinkProgram(program);
  return begun;
}

bool CompilingProgram::is_done() const { return !opengl::compiles_aside() || opengl::is_linked(program_.name()); }

Result<GlProgram> CompilingProgram::finished() {
  if (auto ok = compiled(vert_.get(), vert_name_); !ok) return failed(ok);
  if (auto ok = compiled(frag_.get(), frag_name_); !ok) return failed(ok);
  const GLuint program = program_.get();
  GLint ok = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (!ok) {
    char log[4096] = "";
    glGetProgramInfoLog(program, sizeof log, nullptr, log);
    return failure(ErrorKind::kGraphics, fill(tr("{vertex} + {fragment} do not link: {log}"), arg("vertex", vert_name_),
                                              arg("fragment", frag_name_), arg("log", std::string(log))));
  }
  bind_slots(program);
  if (auto bound = bind_block(program, "FrameBlock", kFrameBinding, sizeof(interop::FrameData)); !bound)
    return failed(bound);
  if (auto bound = bind_block(program, "ClothBlock", kClothBinding, sizeof(interop::ClothData)); !bound)
    return failed(bound);
  return std::move(program_);
}

Result<void> build_into(GlProgram& program, const std::string& vert, const std::string& frag,
                        const std::vector<std::string>& defines) {
  Result<CompilingProgram> begun = CompilingProgram::begin(vert, frag, defines);
  if (!begun) return failed(begun);
  Result<GlProgram> built = begun->finished();
  if (!built) return failed(built);
  program = std::move(*built);
  return {};
}

}  // namespace weftlight::gl
