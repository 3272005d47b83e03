#!/usr/bin/env bash
# Makes the libraries of the build for browsers in build/web-libraries (or $1): links to the header-only ones of Debian's
# -dev packages, and those that must be compiled, from Debian's source packages (fetched by apt, kept in the folder).
# Does nothing where they are newer than this script. Nothing of it is committed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
to=${1:-$root/build/web-libraries}
stamp=$to/done
[[ -f $stamp && $stamp -nt ${BASH_SOURCE[0]} ]] && exit 0
export NODE_PATH=${NODE_PATH:-/usr/share/nodejs}
mkdir -p "$to" && cd "$to"
launch=$(command -v ccache || true)
cc="$launch emcc" cxx="$launch em++ -std=c++17" ar=emar
flags="-O2 -pthread -fwasm-exceptions -sSUPPORT_LONGJMP=wasm -Iinclude"
. "$root/third_party/debian_sources.sh"

use_headers fmt tl glm nlohmann fast_float stb tiny_gltf.h GLFW
# tinygltf names them without their folder.
for header in stb_image.h stb_image_write.h stb_truetype.h; do ln -sfn "/usr/include/stb/$header" "include/$header"; done

zlib=$(source_of zlib)
ln -sfn "$zlib/zlib.h" include/zlib.h && ln -sfn "$zlib/zconf.h" include/zconf.h
library z "-DHAVE_UNISTD_H" "$zlib"/{adler32,compress,crc32,deflate,infback,inffast,inflate,inftrees,trees,uncompr,zutil}.c

build_meshoptimizer
build_tinygltf
build_freetype "-DFT_CONFIG_OPTION_SYSTEM_ZLIB"
build_imgui "-DIMGUI_IMPL_OPENGL_ES3"
touch "$stamp"
