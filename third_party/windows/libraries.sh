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

use_headers fmt tl glm nlohmann stb tiny_gltf.h CLI asio asio.hpp boost GLFW
for header in stb_image.h stb_image_write.h stb_truetype.h; do ln -sfn "/usr/include/stb/$header" "include/$header"; done

build_meshoptimizer
build_tinygltf
# zlib comes with mingw-w64's.
build_freetype "-DFT_CONFIG_OPTION_SYSTEM_ZLIB"
# Its own loader of OpenGL, as in Debian's library.
build_imgui ""

glfw=$(source_of glfw3)
library glfw "-D_GLFW_WIN32 -DUNICODE -D_UNICODE -DWINVER=0x0A00 -D_WIN32_WINNT=0x0A00" \
  "$glfw"/src/{context,init,input,monitor,vulkan,window,egl_context,osmesa_context,wgl_context}.c "$glfw"/src/win32_*.c

# libepoxy writes its functions from the registry of OpenGL, that is part of its source.
epoxy=$(source_of libepoxy)
mkdir -p sources/epoxy include/epoxy
for header in common gl wgl; do ln -sfn "$epoxy/include/epoxy/$header.h" "include/epoxy/$header.h"; done
for of in gl wgl; do
  python3 "$epoxy/src/gen_dispatch.py" --header --no-source --outputdir=include/epoxy "$epoxy/registry/$of.xml"
  python3 "$epoxy/src/gen_dispatch.py" --source --no-header --outputdir=sources/epoxy "$epoxy/registry/$of.xml"
done
printf '#define ENABLE_EGL 0\n#define ENABLE_GLX 0\n' >sources/epoxy/config.h
library epoxy "-Isources/epoxy -I$epoxy/src" \
  "$epoxy"/src/dispatch_{common,wgl}.c sources/epoxy/{gl,wgl}_generated_dispatch.c

# Debian's googletest holds its sources.
library gtest "-I/usr/src/googletest/googletest/include -I/usr/src/googletest/googletest" \
  /usr/src/googletest/googletest/src/gtest-all.cc
touch "$stamp"
