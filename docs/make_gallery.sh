#!/usr/bin/env bash
# Renders docs/gallery/*.jpg: each cloth draped and in close-up. Needs ImageMagick.
# Usage: docs/make_gallery.sh [path of weftlight]; CLOTHS="denim linen" for some of them.
source "$(dirname "${BASH_SOURCE[0]}")/pictures.sh" gallery "$@"

for name in ${CLOTHS:-denim chambray oxford gabardine tweed flannel silk_satin shot_taffeta organza linen damask ottoman chintz double_weave}; do
  cloth=$root/presets/cloths/$name.wif
  [ -f "$cloth" ] || cloth=$root/presets/drafts/$name.wif
  case $name in damask) near=0.16 ;; flannel) near=0.12 ;; linen|denim) near=0.1 ;; *) near=0.06 ;; esac  # shows the border of a block; the nap; slubs
  "$weftlight" render "$cloth" -o "$work/form.png" --size 560x460 --samples "${SAMPLES:-16}"
  "$weftlight" render "$cloth" -o "$work/near.png" --size 560x460 --samples "${SAMPLES:-16}" --mesh plane --view 15,25 \
    --yarns-per-pixel $near
  for part in form near; do convert "$work/$part.png" -quality 88 "$out/${name}_$part.jpg"; done
done
