#pragma once
// What most files include from other libraries, read once for many files (weftlight_precompile). A file still names
// what it uses: without WEFTLIGHT_PRECOMPILE, as for Windows, nothing else brings it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>
#if __has_include(<glm/glm.hpp>)
#include <glm/glm.hpp>
#endif
