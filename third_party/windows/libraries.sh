#!/usr/bin/env bash
# Makes the libraries of the build for Windows in build/windows-libraries (or $1): links to the header-only ones of
# Debian's -dev packages, and those that must be compiled, from Debian's source packages. Does nothing where they are
# newer than this script. Nothing of it is committed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
to=${1:-$root/build/windows-libraries}
stamp=$to/done
[[ -f $stamp && $stamp -nt ${BASH_SOURCE[0]} ]] && exit 0
mkdir -p "$to" && cd "$to"
machine=x86_64-w64-mingw32
launch=$(command -v ccache || true)
cc="$launch $machine-gcc-posix" cxx="$launch $machine-g++-posix -std=c++17" ar=$machine-ar flags="-O2 -Iinclude"
. "$root/third_party/debian_sources.sh"

use_headers fmt tl glm nlohmann stb tiny_gltf.h CLI asio asio.hpp boost
for header in stb_image.h stb_image_write.h; do ln -sfn "/usr/include/stb/$header" "include/$header"; done

build_meshoptimizer
build_tinygltf

# Debian's googletest holds its sources.
library gtest "-I/usr/src/googletest/googletest/include -I/usr/src/googletest/googletest" \
  /usr/src/googletest/googletest/src/gtest-all.cc
touch "$stamp"
