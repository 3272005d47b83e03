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
command -v ccache >/dev/null && export ccache=ccache
mkdir -p "$to"/{include,lib,sources,apt/lists/partial,apt/cache/archives/partial}
cd "$to"

for header in fmt tl glm nlohmann fast_float stb tiny_gltf.h GLFW; do
  [[ -e /usr/include/$header ]] || { echo "The package that holds /usr/include/$header is missing" >&2; exit 1; }
  ln -sfn "/usr/include/$header" "include/$header"
done
# tinygltf names them without their folder.
for header in stb_image.h stb_image_write.h; do ln -sfn "/usr/include/stb/$header" "include/$header"; done


# The system's own list of mirrors, asked for sources, without touching what apt knows.
cat >apt/sources.list <<LIST
deb-src http://deb.debian.org/debian $(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}") main
LIST
ask=(-o "Dir::Etc::SourceList=$to/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null
  -o "Dir::State::Lists=$to/apt/lists" -o "Dir::Cache=$to/apt/cache" -o APT::Sandbox::User=root)
source_of() { # PACKAGE: prints the folder with its source
  local found
  found=$(find sources -maxdepth 1 -type d -name "$1-*" | head -1)
  if [[ -z $found ]]; then
    [[ -f apt/asked ]] || { apt-get "${ask[@]}" -qq update >&2 && touch apt/asked; }
    (cd sources && apt-get "${ask[@]}" -qq source "$1" >&2)
    found=$(find sources -maxdepth 1 -type d -name "$1-*" | head -1)
  fi
  echo "$to/$found"
}
# library NAME "FLAGS" FILES...: compiles them into lib/libNAME.a
library() {
  local name=$1 flags=$2 objects=() file
  shift 2
  mkdir -p "objects/$name"
  for file in "$@"; do
    printf '%s\0%s\0' "$file" "objects/$name/$(basename "$file").o"
  done | xargs -0 -n 2 -P "$(nproc)" sh -c \
    'case $1 in *.c) c=emcc ;; *) c="em++ -std=c++17" ;; esac; exec ${ccache:-} $c -O2 -pthread -fwasm-exceptions -sSUPPORT_LONGJMP=wasm -w '"$flags"' -c "$1" -o "$2"' --
  for file in "$@"; do objects+=("objects/$name/$(basename "$file").o"); done
  rm -f "lib/lib$name.a"
  emar rcs "lib/lib$name.a" "${objects[@]}"
}

zlib=$(source_of zlib)
ln -sfn "$zlib/zlib.h" include/zlib.h && ln -sfn "$zlib/zconf.h" include/zconf.h
library z "-DHAVE_UNISTD_H" "$zlib"/{adler32,compress,crc32,deflate,infback,inffast,inflate,inftrees,trees,uncompr,zutil}.c

meshoptimizer=$(source_of meshoptimizer)
ln -sfn "$meshoptimizer/src/meshoptimizer.h" include/meshoptimizer.h
library meshoptimizer "" "$meshoptimizer"/src/*.cpp

# Debian's tinygltf is a shared library; its one header holds the source. The pictures of a glTF file are not read.
cat >sources/tinygltf.cpp <<'SOURCE'
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>
SOURCE
library tinygltf "-Iinclude" sources/tinygltf.cpp

# The outlines of fonts, with the drivers that the page's fonts need.
freetype=$(source_of freetype)
ln -sfn "$freetype/include/ft2build.h" include/ft2build.h && ln -sfn "$freetype/include/freetype" include/freetype
cat >include/freetype_modules.h <<'MODULES'
FT_USE_MODULE(FT_Module_Class, autofit_module_class)
FT_USE_MODULE(FT_Driver_ClassRec, tt_driver_class)
FT_USE_MODULE(FT_Driver_ClassRec, cff_driver_class)
FT_USE_MODULE(FT_Module_Class, psaux_module_class)
FT_USE_MODULE(FT_Module_Class, psnames_module_class)
FT_USE_MODULE(FT_Module_Class, pshinter_module_class)
FT_USE_MODULE(FT_Module_Class, sfnt_module_class)
FT_USE_MODULE(FT_Renderer_Class, ft_smooth_renderer_class)
MODULES
library freetype "-Iinclude -DFT2_BUILD_LIBRARY -DFT_CONFIG_OPTION_SYSTEM_ZLIB '-DFT_CONFIG_MODULES_H=<freetype_modules.h>'" \
  "$freetype"/src/base/{ftbase,ftbitmap,ftdebug,ftglyph,ftinit,ftmm,ftsynth,ftsystem}.c \
  "$freetype"/src/{gzip/ftgzip,autofit/autofit,truetype/truetype,cff/cff,psaux/psaux,psnames/psnames,pshinter/pshinter,sfnt/sfnt,smooth/smooth}.c

# As Debian's library: with the backends for GLFW and OpenGL, std::string, and glyphs by FreeType.
imgui=$(source_of imgui)
mkdir -p include/imgui
for header in "$imgui"/im*.h "$imgui"/backends "$imgui"/misc; do ln -sfn "$header" "include/imgui/$(basename "$header")"; done
library imgui "-Iinclude -Iinclude/imgui -DIMGUI_ENABLE_FREETYPE -DIMGUI_IMPL_OPENGL_ES3" \
  "$imgui"/{imgui,imgui_draw,imgui_tables,imgui_widgets}.cpp "$imgui"/misc/cpp/imgui_stdlib.cpp \
  "$imgui"/misc/freetype/imgui_freetype.cpp "$imgui"/backends/imgui_impl_{glfw,opengl3}.cpp
touch "$stamp"
