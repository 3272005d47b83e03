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

using base::arg;
using base::fill;
using base::tr;

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

GLuint compile(GLenum stage, const std::string& name, const std::string& text, std::string& error) {
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  char log[4096] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  error = fill(tr("{file} does not compile: {log}"), arg("file", name), arg("log", std::string(log)));
  glDeleteShader(shader);
  return 0;
}

void bind_slots(GLuint program) {
  glUseProgram(program);
  for (int slot = 0; slot < kSamplerCount; ++slot) {
    const GLint at = glGetUniformLocation(program, kSamplerNames[slot]);
    if (at >= 0) glUniform1i(at, slot);
  }
}

/// Checks the block size of the driver against the C++ struct (interop.h asserts the offsets). Returns an error, or
/// empty.
std::string bind_block(GLuint program, const char* name, GLuint binding, size_t bytes) {
  const GLuint block = glGetUniformBlockIndex(program, name);
  if (block == GL_INVALID_INDEX) return {};
  glUniformBlockBinding(program, block, binding);
  GLint size = 0;
  glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  if (static_cast<size_t>(size) == bytes) return {};
  return fill(
      tr("{block}: the driver lays it out in {driver} bytes, the program in {program}; update the graphics driver"),
      arg("block", name), arg("driver", size), arg("program", bytes));
}

}  // namespace

std::string with_includes(const std::string& text, std::string& error) {
  Loader loader{shaders_dir(), {}, {}, {}};
  std::istringstream in(text);
  const std::string resolved = loader.resolved(in);
  error = loader.error;
  return error.empty() ? resolved : std::string();
}

std::string shader_text(const std::string& file, const std::vector<std::string>& defines, std::string& error) {
  std::string text = "#version 330 core\n";
  for (const std::string& define : defines) text += "#define " + define + "\n";
  Loader loader{shaders_dir(), method_of(defines), {}, {}};
  text += loader.file(file);
  if (loader.error.empty()) return text;
  error = loader.error;
  return {};
}

GlProgram build_program(const std::string& vert, const std::string& frag, const std::vector<std::string>& defines,
                        std::string& error) {
  const std::string vert_text = shader_text(vert, defines, error);
  const std::string frag_text = shader_text(frag, defines, error);
  if (vert_text.empty() || frag_text.empty()) return {};
  const GLuint v = compile(GL_VERTEX_SHADER, vert, vert_text, error);
  if (!v) return {};
  const GLuint f = compile(GL_FRAGMENT_SHADER, frag, frag_text, error);
  if (!f) {
    glDeleteShader(v);
    return {};
  }
  GlProgram program;
  glAttachShader(program.get(), v);
  glAttachShader(program.get(), f);
  for (GLuint slot = 0; slot < kAttributeCount; ++slot)
    glBindAttribLocation(program.get(), slot, kAttributeNames[slot]);
  glBindFragDataLocation(program.get(), 0, "out_color");
  glLinkProgram(program.get());
  glDeleteShader(v);
  glDeleteShader(f);
  GLint ok = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &ok);
  if (!ok) {
    char log[4096] = "";
    glGetProgramInfoLog(program.get(), sizeof log, nullptr, log);
    error = fill(tr("{vertex} + {fragment} do not link: {log}"), arg("vertex", vert), arg("fragment", frag),
                 arg("log", std::string(log)));
    return {};
  }
  bind_slots(program.get());
  error = bind_block(program.get(), "FrameBlock", kFrameBinding, sizeof(interop::FrameData));
  if (error.empty()) error = bind_block(program.get(), "ClothBlock", kClothBinding, sizeof(interop::ClothData));
  if (!error.empty()) return {};
  return program;
}

}  // namespace weftlight::gl
