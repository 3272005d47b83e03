#pragma once
// Cost that repeats to the last digit: the instructions that this processor executes for the formulas a rung
// evaluates at one pixel (shaders/*.glsl as C++), counted by single steps in a process of its own. Texture
// fetches, which are not formulas, are not in it; the tables that the formulas ask for are.

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "cloth/cloth.h"
#include "commands/names.h"

namespace weftlight::commands {

/// Empty where the system does not let a process step its own child.
std::optional<long> count_instructions(const std::function<void()>& work);

/// `view` and `light` unit, in cloth space; samples a pixel: of rung yarn alone. Empty also for methods that have no
/// formulas here.
std::optional<long> formula_instructions(Method method, const Cloth& cloth, glm::vec3 view, glm::vec3 light,
                                         int samples = 1);

}  // namespace weftlight::commands
