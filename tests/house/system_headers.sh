#!/usr/bin/env bash
# Only core/platform asks the system: system_headers.sh SOURCE
# Elsewhere a file includes the C++ library and the libraries below, tests for no compiler or system, uses no extension of
# one compiler, and calls none of the system's functions that the C++ library's headers happen to bring along. Tests themselves are free: they play
# killed programs, full disks and looms.
set -euo pipefail
cd "$1"

# Folders and files that may, and why. A line goes when its reason does.
exceptions=(
  core/platform/             # this is the place
  core/base/loops.cpp        # tells the thread sanitizer of oneTBB's ordering; no system
  core/base/json.h           # the one door to nlohmann's JSON
)
# Libraries whose headers end in .h or stand in a folder; the C++ library's do neither.
libraries='CLI/|GLFW/|OpenImageIO/|backends/imgui_|cairo|embree[34]/|epoxy/|GLES3/|fmt/|ft2build\.h|glm/|imgui|meshoptimizer\.h|nlopt\.h|nlohmann/json_fwd\.hpp|pybind11/|tbb/|tiny_gltf\.h|stb_image\.h|zlib\.h|Eigen/|tl/'
systems='__(linux|unix|APPLE|MACH|GNUC|GLIBC|GLIBCXX|clang|CYGWIN|MINGW32|ANDROID|EMSCRIPTEN|x86_64|i386|aarch64|FreeBSD)_*|_WIN(32|64)|_MSC_VER|_POSIX_[A-Z_]*|_GNU_SOURCE'
calls='getenv|secure_getenv|setenv|unsetenv|putenv|environ|isatty|fileno|fdopen|popen|fseeko|ftello|localtime_r|gmtime_r|clock_gettime|sigaction|fsync|getpid|fork|mmap|realpath|mkdtemp|mkstemp|strerror_r'
extensions='__attribute__|__declspec|__builtin_[a-z]|\[\[(gnu|clang|msvc)::|\b_mm(256|512)?_[a-z]+_(ps|pd|epi|si)|^[[:space:]]*#[[:space:]]*pragma[[:space:]]+(GCC|clang|omp)\b'

mapfile -t files < <(
  for folder in core editor shaders tools python; do
    [[ -d $folder ]] && find "$folder" \( -name '*.cpp' -o -name '*.h' \) -type f
  done | LC_ALL=C sort | grep -vF "$(printf '%s\n' "${exceptions[@]}")")
((${#files[@]} > 100)) || { echo "only ${#files[@]} files found"; exit 1; }

found=$(
  { grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<([^>]*[./][^>]*|csignal|csetjmp)>' "${files[@]}" || true; } |
    { grep -vE "include[[:space:]]*<($libraries)" || true; }
  grep -nHE '#.*\b('"$systems"')\b' "${files[@]}" || true
  grep -nHE "$extensions" "${files[@]}" || true
  grep -nHE '(^|[^[:alnum:]_.>"])('"$calls"')[[:space:]]*\(' "${files[@]}" || true
  grep -nHE '"/(proc|dev|sys)/' "${files[@]}" || true
)
if [[ -n $found ]]; then
  echo "The system is asked outside core/platform (interfaces: core/README.md):"
  echo "$found"
  exit 1
fi
for exception in "${exceptions[@]}"; do
  [[ -e $exception ]] || { echo "tests/house/system_headers.sh excepts $exception, which is not there"; exit 1; }
done
# An interface is for every system: its own header includes the C++ library alone, and what stands for C++23's <expected>.
# What is compiled beforehand for all rooms has GLM as well.
if grep -nE '#[[:space:]]*include[[:space:]]*<[^>]*[./][^>]*>' core/platform/*.h |
  grep -vE '<tl/expected\.hpp>|^core/platform/precompiled\.h:[0-9]+:#include <glm/glm\.hpp>'; then
  echo "A header of core/platform names a system."
  exit 1
fi
echo "${#files[@]} files ask nobody but core/platform"
