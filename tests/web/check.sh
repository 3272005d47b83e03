#!/usr/bin/env bash
# `./check web [FILE...]`: builds the editor for browsers and what it is held against on the desktop; compares what core makes
# of drafts in both, line by line, and drives the page in headless Chromium (page.js).
# Without files the shipped drafts are compared. Skipped (exit code 77) where Emscripten or Chromium cannot be had.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
editor/web/build.sh
export NODE_PATH=/usr/share/nodejs
cmake --build build/web --target core_answers
[[ -f build/check/build.ninja ]] || cmake --preset check >/dev/null
cmake --build build/check --target core_answers painted weftlight
files=("$@")
if ((${#files[@]} == 0)); then
  mapfile -t files < <(find presets/drafts presets/cloths -iname '*.wif' | LC_ALL=C sort)
fi
build/check/tests/web/core_answers "${files[@]}" >build/web/desktop.txt
# Node's own fetch, from version 18 on, does not take the path of a file, which Emscripten 3.1.6 would give it.
node --no-experimental-fetch build/web/tests/web/core_answers.js "${files[@]}" >build/web/browser.txt
diff build/web/desktop.txt build/web/browser.txt || { echo "The build for browsers makes something else of these drafts."; exit 1; }
echo "$(wc -l <build/web/browser.txt) drafts: the same in a browser's WebAssembly as on the desktop"

chromium=$(command -v chromium || command -v chromium-browser || true)
[[ -n $chromium ]] || { echo "skipped: Chromium is not installed"; exit 77; }
mkdir -p build/npm
if [[ ! -d build/npm/node_modules/ws ]]; then
  cp third_party/package.json third_party/package-lock.json build/npm/
  (cd build/npm && npm ci --silent --no-audit --no-fund --ignore-scripts --legacy-peer-deps) || { echo "skipped: npm brings no packages"; exit 77; }
fi
made=$(mktemp -d)
trap 'kill "${server:-}" 2>/dev/null || true; rm -rf "$made"' EXIT
cp presets/drafts/starter.wif "$made/mine.wif"
build/check/tests/web/painted "$made/mine.wif" "$made/painted.wif"
# The cloth alone, since the ground and a mesh have no ambient shadow in a browser; with one method, since how many samples
# of the threads there is time for decides otherwise (docs/web.md).
near() { # DRAFT METHOD
  local out=$made/pictures/$1_$2.wif
  sed 's/^\[CONTENTS\]\r\?$/[CONTENTS]\nPRIVATE WEFTLIGHT SCENE=true\nPRIVATE WEFTLIGHT LOOK=true/' \
    "presets/drafts/$1.wif" | sed '/^\[PRIVATE WEFTLIGHT SCENE\]/,$d' >"$out"
  printf '\n[PRIVATE WEFTLIGHT SCENE]\nMesh=plane\nView Azimuth=0\nView Elevation=75\nView Distance=0.14\n' >>"$out"
  printf '\n[PRIVATE WEFTLIGHT LOOK]\nMethod=%s\n' "$2" >>"$out"
}
mkdir "$made/pictures"
near overshot repeat
near twill_2_2 cell
near starter yarn
python3 editor/web/serve.py build/web/page 8117 >"$made/address" &
server=$!
for _ in $(seq 50); do [[ -s $made/address ]] && break; sleep 0.1; done
address=$(grep -o 'http://[^ ]*' "$made/address")
CHROMIUM=$chromium NODE_PATH=build/npm/node_modules node tests/web/page.js "$address" build/check/weftlight "$made"
size=0
for file in weftlight.wasm weftlight.js weftlight.data; do size=$((size + $(gzip -9c build/web/page/$file | wc -c))); done
echo "      the program with its presets: $((size / 1024)) kB compressed"
