#include "gl/shader_program.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "shaders/interop.h"

namespace weftlight::gl {
namespace {

namespace fs = std::filesystem;

bool append_file(const fs::path& file, std::set<std::string>& seen, std::string& out, std::string& error) {
  if (!seen.insert(file.filename().string()).second) return true;
  std::ifstream in(file);
  if (!in) {
    error = file.string() + ": shader file missing; set WEFTLIGHT_SHADERS to the folder of shaders";
    return false;
  }
  std::string line;
  while (std::getline(in, line)) {
    if (line.rfind("#pragma once", 0) == 0) continue;
    if (line.rfind("#include \"", 0) == 0) {
      const size_t end = line.find('"', 10);
      const std::string name = fs::path(line.substr(10, end - 10)).filename().string();
      if (!append_file(file.parent_path() / name, seen, out, error)) return false;
      continue;
    }
    out += line;
    out += '\n';
  }
  return true;
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
  error = name + " does not compile: " + log;
  glDeleteShader(shader);
  return 0;
}

void bind_slots(GLuint program) {
  glUseProgram(program);
  for (int slot = 0; slot < kSamplerCount; ++slot) {
    const GLint at = glGetUniformLocation(program, kSamplerNames[slot]);
    if (at >= 0) glUniform1i(at, slot);
  }
  const GLuint frame = glGetUniformBlockIndex(program, "FrameBlock");
  if (frame != GL_INVALID_INDEX) glUniformBlockBinding(program, frame, kFrameBinding);
  const GLuint cloth = glGetUniformBlockIndex(program, "ClothBlock");
  if (cloth != GL_INVALID_INDEX) glUniformBlockBinding(program, cloth, kClothBinding);
}

}  // namespace

std::string shaders_dir() {
  if (const char* set = std::getenv("WEFTLIGHT_SHADERS")) return set;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path beside = program.parent_path() / "shaders";
  if (!program.empty() && fs::exists(beside / "cloth.frag", ignored)) return beside.string();
  return WEFTLIGHT_SOURCE_DIR "/shaders";
}

std::string shader_text(const std::string& file, const std::vector<std::string>& defines, std::string& error) {
  std::string text = "#version 330 core\n";
  for (const std::string& define : defines) text += "#define " + define + "\n";
  std::set<std::string> seen;
  if (!append_file(fs::path(shaders_dir()) / file, seen, text, error)) return {};
  return text;
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
    error = vert + " + " + frag + " do not link: " + log;
    return {};
  }
  bind_slots(program.get());
  return program;
}

}  // namespace weftlight::gl
