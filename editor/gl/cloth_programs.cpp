#include "gl/cloth_programs.h"

#include <utility>
#include <vector>

#include "render_data/packed_maps.h"

namespace weftlight::gl {

using design::Method, design::method_name;
using render_data::kShadowAzimuths;

namespace {

std::vector<std::string> defines_of(const ProgramKey& key) {
  const std::string name(method_name(key.method));
  std::vector<std::string> defines{"METHOD " + name, "SHADE shade_" + name, "SHADOW_TAPS " + std::to_string(key.taps),
                                   "SHADOW_AZIMUTHS " + std::to_string(kShadowAzimuths),
                                   "METHODS " + std::to_string(key.methods)};
  if (key.taps == kQuickTaps) defines.push_back("QUICK");
  if (key.more_lit) defines.push_back("MORE_LIT");
  if (key.kind.even) defines.push_back("EVEN_THREADS");
  if (key.kind.one_layer) defines.push_back("ONE_LAYER");
  if (key.kind.smooth) defines.push_back("SMOOTH_YARNS");
  if (key.kind.straight) defines.push_back("STRAIGHT_THREADS");
  if (key.kind.closed) defines.push_back("CLOSED_CLOTH");
  if (key.kind.dyed) defines.push_back("DYED_ALONG");
  if (key.kind.computed) defines.push_back("COMPUTED_CROSSINGS");
  return defines;
}

void fail(const ProgramKey& key, ClothProgram& program, base::Error why) {
  why.text.insert(0, std::string(method_name(key.method)) + ": ");
  program.built = base::Failure(std::move(why));
}

bool is_made(const ClothProgram& program) { return program.program.name() || !program.built; }

/// Hands it to the driver, once. The driver may still be compiling it afterwards.
void begin(const ProgramKey& key, ClothProgram& program) {
  if (program.compiling || is_made(program)) return;
  base::Result<CompilingProgram> begun = CompilingProgram::begin("cloth.vert", "cloth.frag", defines_of(key));
  if (begun) program.compiling = std::move(*begun);
  else fail(key, program, begun.error());
}

/// Waits for the driver.
void finish(const ProgramKey& key, ClothProgram& program) {
  if (!program.compiling) return;
  base::Result<GlProgram> made = program.compiling->finished();
  program.compiling.reset();
  if (made) program.program = std::move(*made);
  else fail(key, program, made.error());
}

}  // namespace

ClothProgram& ClothPrograms::compiled(const ProgramKey& key) {
  ClothProgram& program = programs_[key];
  begin(key, program);
  finish(key, program);
  return program;
}

ClothProgram& ClothPrograms::quick(bool more_lit) {
  return compiled({Method::kAuto, kQuickTaps, kRepeatMethod, more_lit, {}});
}

ClothProgram* ClothPrograms::if_compiled(const ProgramKey& key) {
  ClothProgram& program = programs_[key];
  if (!is_made(program) && !std::exchange(program.wanted, true)) return nullptr;
  begin(key, program);
  if (program.compiling && (held || !program.compiling->is_done())) return nullptr;
  finish(key, program);
  return &program;
}

}  // namespace weftlight::gl
