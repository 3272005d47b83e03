#!/usr/bin/env bash
# `./check windows`: builds core for Windows with mingw-w64 and runs its tests under Wine (docs/other_systems.md).
# Usage: tests/windows/check.sh [options of ctest]
# Skipped (exit code 77) where mingw-w64 or Wine cannot be had.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
third_party/install.sh windows || true
for tool in x86_64-w64-mingw32-g++-posix wine; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed (third_party/packages.txt, windows)"; exit 77; }
done
third_party/windows/libraries.sh
# Wine's own folder of settings and its Windows, so that a user's is left alone; nothing is drawn.
export WINEPREFIX=$root/build/windows/wine WINEDEBUG=-all WINEDLLOVERRIDES=winemenubuilder.exe=d DISPLAY=
[[ -f build/windows/build.ninja ]] || cmake --preset windows >/dev/null
cmake --build --preset windows --target windows_tests
[[ -d $WINEPREFIX ]] || wine wineboot --init >/dev/null 2>&1
ctest --test-dir build/windows --output-on-failure -j "$(nproc)" "$@"
