#pragma once
// Runs a shared formula file on the GPU for many cases at once: a column of pixels a case, a row an output.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gl/gl_objects.h"
#include "gl/open_headless.h"
#include "gl/shader_program.h"
#include "light/formulas.h"
#include "shaders/interop.h"

namespace weftlight::gl {

using base::problem_of;

inline GLuint compiled(GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  char log[2048] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  EXPECT_TRUE(ok) << log;
  return shader;
}

/// `main_text` follows the shared files; in it given(row) is a case's input, `row` the index of the output, `result`
/// its value.
inline GlProgram pixel_program(const std::vector<std::string>& files, const std::string& main_text,
                               const std::vector<std::string>& defines = {}) {
  std::string text = "#version 330 core\n";
  for (const std::string& define : defines) text += "#define " + define + "\n";
  for (const std::string& file : files) text += "#include \"" + file + "\"\n";
  text += R"(
uniform sampler2D cases;
out vec4 out_color;
vec4 given(int i) { return texelFetch(cases, ivec2(int(gl_FragCoord.x), i), 0); }
void main() {
  int row = int(gl_FragCoord.y);
  vec4 result = vec4(0.0);
)" + main_text +
          "  out_color = result;\n}\n";
  GlProgram program;
  const GLuint vert = compiled(GL_VERTEX_SHADER,
                               "#version 330 core\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, "
                               "gl_VertexID == 2 ? 3 : -1, 0, 1); }\n");
  const base::Result<std::string> whole = with_includes(text);
  EXPECT_EQ(problem_of(whole), "");
  const GLuint frag = compiled(GL_FRAGMENT_SHADER, whole.value_or(""));
  glAttachShader(program.get(), vert);
  glAttachShader(program.get(), frag);
  glLinkProgram(program.get());
  glDeleteShader(vert);
  glDeleteShader(frag);
  GLint ok = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &ok);
  EXPECT_TRUE(ok);
  glUseProgram(program.get());
  for (int slot = 0; slot < kSamplerCount; ++slot)
    glUniform1i(glGetUniformLocation(program.get(), kSamplerNames[static_cast<size_t>(slot)]), slot);
  glUniform1i(glGetUniformLocation(program.get(), "cases"), kSamplerCount);
  return program;
}

inline void make_plane(GlTexture& texture, int width, int height, const float* values) {
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, values);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// rows[input][case] to [output][case], `questions` of them.
template <class Case>
std::vector<glm::vec4> run_pixels(const GlProgram& program, const std::vector<Case>& cases, int questions) {
  const int width = static_cast<int>(cases.size()), inputs = static_cast<int>(Case{}.size());
  std::vector<glm::vec4> rows;
  for (size_t row = 0; row < Case{}.size(); ++row)
    for (const Case& c : cases) rows.push_back(c[row]);
  GlTexture input, output;
  glActiveTexture(GL_TEXTURE0 + kSamplerCount);
  make_plane(input, width, inputs, &rows[0].x);
  glActiveTexture(GL_TEXTURE0 + kSamplerCount + 1);
  make_plane(output, width, questions, nullptr);
  GlFramebuffer frame;
  glBindFramebuffer(GL_FRAMEBUFFER, frame.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output.get(), 0);
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  glUseProgram(program.name());
  GlVertexArray array;
  glBindVertexArray(array.get());
  glViewport(0, 0, width, questions);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<glm::vec4> results(cases.size() * static_cast<size_t>(questions));
  glReadPixels(0, 0, width, questions, GL_RGBA, GL_FLOAT, &results[0].x);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  return results;
}

class PixelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto opened = open_headless();
    if (!opened) GTEST_SKIP() << "no graphics: " << problem_of(opened);
    context_ = std::move(*opened);
  }
  std::unique_ptr<HeadlessContext> context_;
};

}  // namespace weftlight::gl
