#pragma once
// The shader programs of the cloth, one for each method and kind of cloth, compiled when first needed.

#include <compare>
#include <map>
#include <optional>
#include <string>

#include "base/result.h"
#include "design/design.h"
#include "gl/shader_program.h"
#include "render_data/thread_block.h"

namespace weftlight::gl {

inline constexpr int kFullTaps = 12, kQuickTaps = 4;  // of the shadow's filter
// Bit masks of the methods in a program of `auto`.
inline constexpr int kYarnMethod = 1, kCellMethod = 2, kRepeatMethod = 4, kAllMethods = 15;

/// What a program of the cloth is compiled for.
struct ProgramKey {
  design::Method method = design::Method::kAuto;
  int taps = kFullTaps;
  int methods = kAllMethods;
  bool more_lit = false;           // with the lights of an environment beside the key light
  render_data::ThreadKind kind{};  // properties of the cloth
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy takes the 0 of <=> for a pointer
  auto operator<=>(const ProgramKey&) const = default;
};

/// One that fails is not tried again.
struct ClothProgram {
  GlProgram program;
  base::Result<void> built;
  bool drawn = false;
  bool wanted = false;                          // a picture was drawn without it
  std::optional<CompilingProgram> compiling{};  // until it is asked for the result
};

class ClothPrograms {
 public:
  /// Waits for the driver.
  ClothProgram& compiled(const ProgramKey& key);
  /// The one that compiles soonest. Waits for the driver.
  ClothProgram& quick(bool more_lit);
  /// Null while the driver compiles it. It is begun with the second call, so that where the driver compiles on this
  /// thread there is a picture to look at.
  ClothProgram* if_compiled(const ProgramKey& key);

  bool held = false;  // for tests: if_compiled() finds what is not made yet still being compiled

 private:
  std::map<ProgramKey, ClothProgram> programs_;
};

}  // namespace weftlight::gl
