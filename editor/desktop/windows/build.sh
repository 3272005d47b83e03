#!/usr/bin/env bash
# Builds the program for Windows with mingw-w64, as a folder (build/windows/installed) and a .zip of it. Usage: build.sh
# Ends with exit code 77 where mingw-w64 cannot be had.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
cd "$root"
third_party/install.sh windows || true
command -v x86_64-w64-mingw32-g++-posix >/dev/null ||
  { echo "mingw-w64 is not installed, which the build for Windows needs (docs/other_systems.md)" >&2; exit 77; }
third_party/windows/libraries.sh
[[ -f build/windows/build.ninja ]] || cmake --preset windows >/dev/null
cmake --build build/windows
rm -rf build/windows/installed
cmake --install build/windows --prefix build/windows/installed --strip >/dev/null
(cd build/windows && rm -f ./*.zip && cpack >/dev/null)
ls "$root"/build/windows/*.zip
