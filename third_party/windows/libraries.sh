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

# configured PACKAGE MAKE-FOLDER OPTION...: builds a library by its own configure into the folder `prefix`.
configured() {
  local package=$1 folder=$2 from
  shift 2
  from=$(source_of "$package")
  mkdir -p "objects/$package"
  (cd "objects/$package"
    export CC=$cc AR=$ar RANLIB=$machine-ranlib CFLAGS="-O2 -w -DCAIRO_WIN32_STATIC_BUILD -I$to/prefix/include" \
      PKG_CONFIG_LIBDIR=$to/prefix/lib/pkgconfig PKG_CONFIG="pkg-config --static"
    # What configure is made of is newer in some archives, and needs no making.
    [[ -f Makefile ]] || "$from/configure" --host=$machine --prefix="$to/prefix" --enable-static --disable-shared "$@" >log 2>&1
    make -j"$(nproc)" ACLOCAL=: AUTOMAKE=: AUTOCONF=: AUTOHEADER=: -C "$folder" install >>log 2>&1) ||
    { tail -20 "objects/$package/log" >&2; exit 1; }
}

# Drafts on paper: PDF, SVG and PNG, with the fonts of Windows.
mkdir -p prefix/lib/pkgconfig
printf 'Name: zlib\nDescription: of mingw-w64\nVersion: 1.2\nLibs: -lz\n' >prefix/lib/pkgconfig/zlib.pc
configured libpng1.6 .
configured pixman pixman --disable-gtk --disable-libpng --disable-openmp
(cd objects/pixman && make install-pkgconfigDATA >>log)
configured cairo src --enable-win32 --enable-win32-font --enable-png --enable-pdf --enable-svg --disable-xlib --disable-xcb \
  --disable-ft --disable-fc --disable-gobject --disable-ps --disable-script --disable-tee --disable-interpreter \
  --disable-trace --disable-gtk-doc --disable-valgrind --disable-pthread --disable-symbol-lookup

# Debian's googletest holds its sources.
library gtest "-I/usr/src/googletest/googletest/include -I/usr/src/googletest/googletest" \
  /usr/src/googletest/googletest/src/gtest-all.cc
touch "$stamp"
