#!/usr/bin/env bash
# Renders the pictures of docs/truth.md: the ray-traced threads, the preview, and their absolute difference, four times as
# bright; and cloths as fibres beside the same as tubes. Needs ImageMagick. Usage: docs/make_truth.sh [path of weftlight]
# ONLY=fibres or ONLY=tubes makes a part.
source "$(dirname "${BASH_SOURCE[0]}")/pictures.sh" truth "$@"

scene() {  # name draft options...
  local name=$1 draft=$drafts/$2.wif
  shift 2
  "$weftlight" reference "$draft" -o "$work/truth.png" --spp "${SPP:-96}" --size 420x320 "$@"
  "$weftlight" render "$draft" -o "$work/auto.png" --size 420x320 --samples 48 "$@"
  convert "$work/truth.png" "$work/auto.png" -compose difference -composite -evaluate multiply 4 "$work/difference.png"
  for part in truth auto difference; do convert "$work/$part.png" -quality 90 "$out/${name}_$part.jpg"; done
  # Relative RMSE of the pixels, for the table.
  printf '%s %s\n' "$name" "$(compare -metric RMSE "$work/truth.png" "$work/auto.png" null: 2>&1 | sed 's/.*(\(.*\))/\1/')"
}

# A shipped cloth at 1/32 yarn a pixel, as fibres and as tubes; prints time and memory for the table.
fibres() {  # name cloth options...
  local name=$1 cloth=$root/presets/cloths/$2.wif began
  shift 2
  local view=(--size 320x240 --mesh plane --yarns-per-pixel 0.03125 --view 20,15 "$@")
  began=$SECONDS
  "$weftlight" reference "$cloth" -o "$work/fibres.png" --fibres --spp "${SPP:-64}" "${view[@]}"
  printf '%s %s s\n' "$name" "$((SECONDS - began))"
  "$weftlight" reference "$cloth" -o "$work/tubes.png" --spp "${SPP:-96}" "${view[@]}"
  for part in fibres tubes; do convert "$work/$part.png" -quality 88 "$out/${name}_$part.jpg"; done
}

if [[ ${ONLY:-fibres} == fibres ]]; then
  fibres cotton chambray
  fibres linen linen
  fibres worsted gabardine
  fibres filament silk_satin
fi
[[ ${ONLY:-tubes} == tubes ]] || exit 0

scene plain_near plain --mesh plane --view 15,10 --yarns-per-pixel 0.04
scene twill_near twill_2_2 --mesh plane --view -30,20 --yarns-per-pixel 0.06
scene satin_near satin_8 --mesh plane --view 20,15 --yarns-per-pixel 0.06
scene starter_middle starter --mesh tablecloth --yarns-per-pixel 0.2
scene overshot_middle overshot --mesh tunic --yarns-per-pixel 0.5
scene gauze_near gauze --mesh curtain --yarns-per-pixel 0.15
scene starter_far starter --mesh tablecloth
scene shot_far shot_taffeta --mesh skirt
