#!/usr/bin/env bash
# `./check web`: builds core for browsers and for the desktop, and compares what both make of drafts, line by line.
# Usage: tests/web/check.sh [FILE...]; without files the shipped drafts.
# Skipped (exit code 77) where Emscripten cannot be had.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
third_party/install.sh web
for tool in em++ node; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
export NODE_PATH=/usr/share/nodejs  # where Debian's Emscripten finds its parser of JavaScript
third_party/web/libraries.sh
[[ -f build/web/build.ninja ]] || cmake --preset web >/dev/null
cmake --build build/web --target core_answers
[[ -f build/check/build.ninja ]] || cmake --preset check >/dev/null
cmake --build build/check --target core_answers
files=("$@")
if ((${#files[@]} == 0)); then
  mapfile -t files < <(find presets/drafts presets/cloths -iname '*.wif' | LC_ALL=C sort)
fi
build/check/tests/web/core_answers "${files[@]}" >build/web/desktop.txt
# Node's own fetch, from version 18 on, does not take the path of a file, which Emscripten 3.1.6 would give it.
node --no-experimental-fetch build/web/tests/web/core_answers.js "${files[@]}" >build/web/browser.txt
diff build/web/desktop.txt build/web/browser.txt || { echo "The build for browsers makes something else of these drafts."; exit 1; }
echo "$(wc -l <build/web/browser.txt) drafts: the same in a browser's WebAssembly as on the desktop"
