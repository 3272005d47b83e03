#!/usr/bin/env bash
# Renders docs/engines/*.jpg: preview, reference, three.js, Godot, Cycles and EEVEE side by side. Needs node, Chromium, what npm brings
# (./check installs it), Blender with numpy, Xvfb, and ImageMagick.
# Usage: docs/make_engines.sh [path of weftlight]; DRAFTS="denim satin_8" for some of them.
source "$(dirname "${BASH_SOURCE[0]}")/pictures.sh" engines "$@"

for name in ${DRAFTS:-satin_8 denim gauze plain}; do
  node "$root/docs/engines.js" "$weftlight" "$root/build/npm/node_modules" "$(command -v chromium)" "$(command -v blender)" \
    "$drafts/$name.wif" "$work"
  convert "$work/$name"/{preview,reference,three_js,godot,blender,eevee}.png -gravity center -crop 240x220+0+10 +repage +append -quality 88 \
    "$out/$name.jpg"
done
