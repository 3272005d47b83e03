# Read by the scripts that build libraries for another system: Debian's source packages, fetched by apt and kept in the
# folder `to`, and compiling them with $cc, $cxx, $ar and $flags. The caller has set these and stands in the folder.

# use_headers NAME...: links to headers of Debian's -dev packages, so that nothing else of /usr/include is seen.
use_headers() {
  local header
  for header in "$@"; do
    [[ -e /usr/include/$header ]] || { echo "The package that holds /usr/include/$header is missing" >&2; exit 1; }
    ln -sfn "/usr/include/$header" "include/$header"
  done
}

# The system's own list of mirrors, asked for sources, without touching what apt knows.
mkdir -p apt/lists/partial apt/cache/archives/partial sources objects include lib
cat >apt/sources.list <<LIST
deb-src http://deb.debian.org/debian $(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}") main
LIST
ask=(-o "Dir::Etc::SourceList=$to/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null
  -o "Dir::State::Lists=$to/apt/lists" -o "Dir::Cache=$to/apt/cache" -o APT::Sandbox::User=root)

# source_of PACKAGE: prints the folder with its source. Where a mirror lacks the part that Debian adds, it is the original's,
# whose checksum apt has compared.
source_of() {
  local found
  found=$(find sources -maxdepth 1 -type d -name "$1-*" | head -1)
  if [[ -z $found ]]; then
    [[ -f apt/asked ]] || { apt-get "${ask[@]}" -qq update >&2 && touch apt/asked; }
    if ! (cd sources && apt-get "${ask[@]}" -qq source "$1" >&2); then
      mkdir -p "sources/$1-original"
      tar -xf sources/"$1"_*.orig.tar.* -C "sources/$1-original" --strip-components=1 >&2 || exit 1
    fi
    found=$(find sources -maxdepth 1 -type d -name "$1-*" | head -1)
  fi
  echo "$to/$found"
}

# library NAME "FLAGS" FILES...: compiles them into lib/libNAME.a
library() {
  local name=$1 own=$2 objects=() file
  shift 2
  mkdir -p "objects/$name"
  for file in "$@"; do
    printf '%s\0%s\0' "$file" "objects/$name/$(basename "$file").o"
  done | xargs -0 -n 2 -P "$(nproc)" sh -c \
    'case $1 in *.c) c="'"$cc"'" ;; *) c="'"$cxx"'" ;; esac; exec $c '"$flags -w $own"' -c "$1" -o "$2"' --
  for file in "$@"; do objects+=("objects/$name/$(basename "$file").o"); done
  rm -f "lib/lib$name.a"
  $ar rcs "lib/lib$name.a" "${objects[@]}"
}

# What several systems need, each as the editor uses it.

build_meshoptimizer() {
  local from
  from=$(source_of meshoptimizer)
  ln -sfn "$from/src/meshoptimizer.h" include/meshoptimizer.h
  library meshoptimizer "" "$from"/src/*.cpp
}

# Debian's tinygltf is a shared library; its one header holds the source. The pictures of a glTF file are not read.
build_tinygltf() {
  cat >sources/tinygltf.cpp <<'SOURCE'
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>
SOURCE
  library tinygltf "" sources/tinygltf.cpp
}

# build_freetype "FLAGS": the outlines of fonts, with the drivers that the fonts of the program need.
build_freetype() {
  local from
  from=$(source_of freetype)
  ln -sfn "$from/include/ft2build.h" include/ft2build.h && ln -sfn "$from/include/freetype" include/freetype
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
  library freetype "$1 -DFT2_BUILD_LIBRARY '-DFT_CONFIG_MODULES_H=<freetype_modules.h>'" \
    "$from"/src/base/{ftbase,ftbitmap,ftdebug,ftglyph,ftinit,ftmm,ftsynth,ftsystem}.c \
    "$from"/src/{gzip/ftgzip,autofit/autofit,truetype/truetype,cff/cff,psaux/psaux,psnames/psnames,pshinter/pshinter,sfnt/sfnt,smooth/smooth}.c
}

# build_imgui "FLAGS": as Debian's library, with the backends for GLFW and OpenGL, std::string, and glyphs by FreeType.
build_imgui() {
  local from header
  from=$(source_of imgui)
  mkdir -p include/imgui
  for header in "$from"/im*.h "$from"/backends "$from"/misc; do ln -sfn "$header" "include/imgui/$(basename "$header")"; done
  library imgui "-Iinclude/imgui -DIMGUI_ENABLE_FREETYPE $1" \
    "$from"/{imgui,imgui_draw,imgui_tables,imgui_widgets}.cpp "$from"/misc/cpp/imgui_stdlib.cpp \
    "$from"/misc/freetype/imgui_freetype.cpp "$from"/backends/imgui_impl_{glfw,opengl3}.cpp
}
