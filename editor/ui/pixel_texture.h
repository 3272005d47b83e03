#pragma once
// A GL texture filled by the CPU.

#include <imgui.h>

#include <cstdint>
#include <span>
#include <vector>

#include "ui/imgui_compat.h"

namespace weftlight::ui {

class PixelTexture {
 public:
  PixelTexture() = default;
  ~PixelTexture();
  PixelTexture(const PixelTexture&) = delete;
  PixelTexture& operator=(const PixelTexture&) = delete;

  /// width x height pixels as ImGui packs them, row 0 on top. Each call changes name(), which Damage needs. `smooth`:
  /// linear filtering, for display at another size, at least half of its own.
  void set(int width, int height, std::span<const ImU32> pixels, bool smooth = false);
  bool empty() const { return name_ == 0; }
  unsigned name() const { return name_; }
  ImTextureID id() const { return texture_of(name()); }

  /// Deletes what set() has replaced, and those that are gone. Of the window, once a frame has been drawn: until then
  /// no new name is one that the last drawn frame had, however many frames of input are dropped in between.
  static void delete_replaced();
  /// After a GL context came back empty, as in a browser: fills all of them anew.
  static void upload_all();

 private:
  void upload(int width, int height, const ImU32* pixels, bool smooth);

  unsigned name_ = 0;
  // Where contexts come back: what was set.
  int width_ = 0, height_ = 0;
  bool smooth_ = false;
  std::vector<ImU32> pixels_;
};

}  // namespace weftlight::ui
