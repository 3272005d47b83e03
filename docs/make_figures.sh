#!/usr/bin/env bash
# Renders the pictures of docs/figures.md from the shipped drafts. Needs ImageMagick's `convert` (to JPEG).
# Usage: docs/make_figures.sh [path of weftlight]
source "$(dirname "${BASH_SOURCE[0]}")/pictures.sh" figures "$@"

picture() {  # name draft options...
  local name=$1 draft=$2
  shift 2
  "$weftlight" render "$draft" -o "$work/$name.png" --samples 48 "$@"
  convert "$work/$name.png" -quality 90 "$out/$name.jpg"
}
with() {  # new-name draft key=value...: a copy with yarn 1 changed
  local name=$1 draft=$2
  shift 2
  cp "$draft" "$work/$name.wif"
  local change
  # Numbers that are the usual ones are not in the file.
  for change in "$@"; do sed -i -e "/^1 ${change%%=*}=/d" -e "s/^1 Name=.*/&\n1 $change/" "$work/$name.wif"; done
  echo "$work/$name.wif"
}

# new-name draft factor: a copy with thicker yarn, so that the weave is visible on a whole garment
heavier() {
  awk -F= -v k="$3" -v OFS== '
    /^\[/ { thick = ($0 ~ /(SPACING|THICKNESS)\]/) }
    /^(Spacing|Thickness)=/ || /^[0-9]+ Diameter=/ || (thick && /^[0-9]+=/) { $2 *= k }
    /^[0-9]+ Turns=/ { $2 /= k }
    { print }' "$2" >"$work/$1.wif"
  echo "$work/$1.wif"
}

# 2 and 4: a colour scheme and its cloth
"$weftlight" drawdown "$drafts/starter.wif" -o "$out/scheme.png"
picture colour_texture "$drafts/starter.wif" --mesh plane --view 0,0 --size 640x640 --method flat --yarns-per-pixel 0.1

# 3: thread textures: loose twist; tighter with flyaway fibres; thick fibres; tight twist
thread=$root/presets/yarns/cotton.wif
close=(--mesh plane --view 0,0 --size 400x400 --yarns-per-pixel 0.0075)
picture thread_a "$(with a "$thread" Turns=150 Hairiness=0 Grooves=0.6 Plies=1)" "${close[@]}" --method flat
picture thread_b "$(with b "$thread" Turns=450 Hairiness=0.9 Grooves=0.6 Plies=1)" "${close[@]}" --method flat
picture thread_c "$(with c "$thread" Turns=450 Hairiness=0.5 Grooves=0.6 Plies=1 Fibre=140)" "${close[@]}" --method flat
picture thread_d "$(with d "$thread" Turns=900 Hairiness=0.5 Grooves=0.6 Plies=1)" "${close[@]}" --method flat

# 5: one garment, many weaves
for draft in herringbone houndstooth glen_check overshot denim shadow_weave; do
  picture "tunic_$draft" "$(heavier "$draft" "$drafts/$draft.wif" 3)" --mesh tunic --size 480x480
done

# 6: two contrasting colours at normal and at grazing view; the method of the paper and ours
for method in vrst03 auto; do
  picture "shot_normal_$method" "$drafts/shot_taffeta.wif" --mesh plane --view 0,4 --size 480x320 --method $method
  picture "shot_grazing_$method" "$drafts/shot_taffeta.wif" --mesh plane --view 78,4 --size 480x320 --method $method
  picture "shot_skirt_$method" "$drafts/shot_taffeta.wif" --mesh skirt --size 480x480 --method $method
done

# 7: the lobes of cotton and of silk satin in the same colours; and gaps that transmit light
lobes() {  # name draft
  sed -e '/^\[COLOR TABLE\]/,/^$/ { s/^1=.*/1=122,24,44/; s/^2=.*/2=140,36,50/ }' "$2" >"$work/$1.wif"
  picture "$1" "$work/$1.wif" --mesh skirt --size 480x560
}
lobes lobes_cotton "$root/presets/yarns/cotton.wif"
lobes lobes_satin "$drafts/satin_8.wif"
picture gauze "$drafts/gauze.wif" --mesh curtain --size 480x560

# 8: zooming in
i=0
for step in 2 0.7 0.25 0.08 0.03; do
  i=$((i + 1))
  picture "zoom_$i" "$drafts/starter.wif" --size 480x360 --yarns-per-pixel $step
done

# Future work in the paper: fibres at the silhouette
rim() {  # name yarn
  { cat "$root/presets/yarns/$2.wif"; printf '\n[PRIVATE WEFTLIGHT SCENE]\nMesh=sphere\nView Distance=0.05\nPan X=-1\nPan Y=-3.8\n'; } >"$work/$1.wif"
  picture "$1" "$work/$1.wif" --size 480x360
}
rim rim_wool wool
rim rim_cotton cotton
rim rim_silk silk
