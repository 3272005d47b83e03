#!/usr/bin/env bash
# Renders docs/macro/*.jpg: shipped cloths at 1/32 yarn a pixel, in real time and as traced fibres. Needs ImageMagick.
# Usage: docs/make_macro.sh [path of weftlight]; CLOTHS="denim linen" for some of them, SPP=N rays a pixel of the fibres, 0 keeps their pictures.
source "$(dirname "${BASH_SOURCE[0]}")/pictures.sh" macro "$@"

for name in ${CLOTHS:-chambray linen tweed gabardine silk_satin shot_taffeta denim flannel organza damask silk_crepe_de_chine cotton_twill}; do
  cloth=$root/presets/cloths/$name.wif
  view=(--size 320x240 --mesh plane --yarns-per-pixel 0.03125 --view 15,25)
  "$weftlight" render "$cloth" -o "$work/near.png" --method yarn --samples 34 "${view[@]}"
  parts=(near)
  if [[ ${SPP:-48} != 0 ]]; then
    "$weftlight" reference "$cloth" -o "$work/fibres.png" --fibres --spp "${SPP:-48}" "${view[@]}"
    parts+=(fibres)
  fi
  for part in "${parts[@]}"; do convert "$work/$part.png" -quality 85 "$out/${name}_$part.jpg"; done
done
