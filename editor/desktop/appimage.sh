#!/usr/bin/env bash
# Makes an AppImage of an installed build: one file that runs on most Linux systems, if they are not older than this one.
# Untried as a whole: the runtime that begins the file is in no package of Debian's. Tried without it: the folder that it
# would mount runs by its AppRun on a bare Debian 12.
# Usage: editor/desktop/appimage.sh BUILD [RUNTIME]    (RUNTIME: runtime-x86_64 of github.com/AppImage/type2-runtime)
set -euo pipefail
build=$(cd "$1" && pwd) runtime=${2:-}
folder=$build/Weftlight.AppDir
rm -rf "$folder"
DESTDIR=$folder cmake --install "$build" --prefix /usr --strip >/dev/null
ln -s usr/share/applications/weftlight.desktop usr/share/icons/hicolor/scalable/apps/weftlight.svg "$folder/"
ln -s weftlight.svg "$folder/.DirIcon"
cat >"$folder/AppRun" <<'RUN'
#!/bin/sh
here=$(dirname "$(readlink -f "$0")")
LD_LIBRARY_PATH=$here/usr/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} exec "$here/usr/bin/weftlight" "$@"
RUN
chmod +x "$folder/AppRun"
# Every library but those that must be the system's own: the C library, and what talks to the kernel, the graphics driver,
# the window system and the fonts.
system='^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|GL|EGL|GLX|GLdispatch|OpenGL|drm|gbm|X11|X11-xcb|xcb|xcb-dri[23]|Xau|Xdmcp|wayland-.*|fontconfig|freetype|expat|z|gcc_s|stdc\+\+))\.so'
mkdir -p "$folder/usr/lib"
ldd "$folder/usr/bin/weftlight" "$folder"/usr/libexec/weftlight/*.so | awk '$3 ~ /^\// {print $3}' | while read -r library; do
  [[ $(basename "$library") =~ $system ]] || cp -L "$library" "$folder/usr/lib/"
done
if [[ -z $runtime ]]; then
  echo "$folder is ready; with a runtime it becomes one file."
  exit 0
fi
mksquashfs "$folder" "$build/weftlight.squashfs" -root-owned -noappend -comp zstd >/dev/null
cat "$runtime" "$build/weftlight.squashfs" >"$build/Weftlight-x86_64.AppImage"
chmod +x "$build/Weftlight-x86_64.AppImage"
rm "$build/weftlight.squashfs"
