#pragma once
// What the build for browsers includes before every file, compiled once (dependencies.cmake): what libc++ lacks, and
// the headers of other people that most files include; not JSON, which base/json.h must precede.

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <tl/expected.hpp>
#include <unordered_map>
#include <variant>
#include <vector>

#include "standard_library.h"
