#!/usr/bin/env bash
# Builds the editor as a page into build/web/page, with all that it needs from Debian.
# Ends with exit code 77 where Emscripten cannot be had.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
third_party/install.sh web
for tool in em++ node python3; do
  command -v $tool >/dev/null || { echo "$tool is not installed, which the build for browsers needs (docs/web.md)" >&2; exit 77; }
done
export NODE_PATH=/usr/share/nodejs  # where Debian's Emscripten finds its parser of JavaScript
# Debian's own, without a shim before it; and ccache need not run the preprocessor beside the compiler.
[[ ! -x /usr/bin/python3 ]] || export EMSDK_PYTHON=/usr/bin/python3
export CCACHE_DEPEND=1
third_party/web/libraries.sh
[[ -f build/web/build.ninja ]] || cmake --preset web >/dev/null
log=build/web/build.log
if [[ -t 1 ]]; then
  cmake --build build/web --target weftlight
else
  cmake --build build/web --target weftlight >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
fi
# The handbook, where python3-markdown is there.
cmake --build build/web --target handbook >"$log" 2>&1 || true
