#include "ui/redraw.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "opengl/opengl.h"
#include "ui/pixel_texture.h"

namespace weftlight::ui {

Redraw::~Redraw() {
  if (framebuffer_ == 0) return;
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &picture_);
}

void Redraw::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width, height_ = height;
  if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_), glGenTextures(1, &picture_);
  glBindTexture(GL_TEXTURE_2D, picture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, opengl::kWindowLayout, opengl::kWindowType, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_, 0);
  damage_.invalidate();
}

/// Draws ImGui's commands with their clip rectangles, which become scissors, cut to the area.
void Redraw::draw_area(ImDrawData& data, const Area& area) const {
  const float sx = data.FramebufferScale.x, sy = data.FramebufferScale.y;
  const int x = static_cast<int>(area.x0 * sx), y = static_cast<int>(static_cast<float>(height_) - area.y1 * sy);
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, static_cast<int>(std::ceil((area.x1 - area.x0) * sx)),
            static_cast<int>(std::ceil((area.y1 - area.y0) * sy)));
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(background_);
  glClearColor(c.x, c.y, c.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  std::vector<ImVec4> kept;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    for (ImDrawCmd& cmd : data.CmdLists[i]->CmdBuffer) {
      ImVec4& r = cmd.ClipRect;
      kept.push_back(r);
      r = {std::max(r.x, area.x0), std::max(r.y, area.y0), std::min(r.z, area.x1), std::min(r.w, area.y1)};
      if (r.x >= r.z || r.y >= r.w) r = {0, 0, 0, 0};
    }
  }
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  auto before = kept.begin();
  for (int i = 0; i < data.CmdListsCount; ++i)
    for (ImDrawCmd& cmd : data.CmdLists[i]->CmdBuffer) cmd.ClipRect = *before++;
}

bool Redraw::draw(ImDrawData& data, int width, int height, ImU32 background, bool show) {
  if (width < 1 || height < 1) return false;
  resize(width, height);
  if (background != background_) damage_.invalidate();
  background_ = background;
  const std::vector<Area> areas = damage_.changed_areas(data);
  if (areas.empty() && !show) {
    PixelTexture::delete_replaced();
    return false;
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width, height);
  for (const Area& area : areas) draw_area(data, area);
  PixelTexture::delete_replaced();
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return true;
}

}  // namespace weftlight::ui
