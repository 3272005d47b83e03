#!/usr/bin/env bash
# Makes the pictures of docs/handbook: drives the real window by real clicks on a display of its own, and renders cloth.
# Needs Xvfb, xdotool, ImageMagick and python3. Usage: docs/make_handbook.sh [path of weftlight]; PAGES="loom plan" for some.
source "$(dirname "${BASH_SOURCE[0]}")/pictures.sh" handbook/pictures "$@"

export HOME=$work/home XDG_CONFIG_HOME=$work/home/config DISPLAY=
unset WAYLAND_DISPLAY XDG_STATE_HOME XDG_CACHE_HOME
window= server=
trap 'kill $window $server 2>/dev/null || true; rm -rf "$work"' EXIT

open_display() {  # width height
  exec 3<> <(:)
  Xvfb -displayfd 3 -screen 0 "$1x$2x24" -nolisten tcp -noreset 2>/dev/null &
  server=$!
  read -r number <&3
  export DISPLAY=:$number
}
close_window() { if [[ -n $window ]]; then kill $window && wait $window 2>/dev/null || true; fi; window=; }
open_window() {  # draft [settings as JSON]
  close_window
  rm -rf "$HOME" "$work/map.json"
  mkdir -p "$XDG_CONFIG_HOME/weftlight"
  echo "${2:-{\}}" >"$XDG_CONFIG_HOME/weftlight/settings.json"
  "$weftlight" "$1" --ui-map "$work/map.json" >"$work/window.log" 2>&1 &
  window=$!
  until [[ -s $work/map.json ]]; do sleep 0.1; done
  settle
}
settle() {  # until two pictures in a row are the same
  local before=none now
  while :; do
    sleep "${PAUSE:-0.8}"
    now=$(import -silent -window root rgb:- | md5sum)
    [[ $now == "$before" ]] && break
    before=$now
  done
}
place() {  # a control, or a cell as "threading 3 2": x y
  python3 - "$work/map.json" "$@" <<'P'
import json, sys
ui = json.load(open(sys.argv[1]))
name, *cell = sys.argv[2:]
if cell:
    g = next(g for g in ui["grids"] if g["name"] == name)
    a, b = float(cell[0]), float(cell[1])
    at = [g["origin"][i] + a * g["step_a"][i] + b * g["step_b"][i] for i in (0, 1)]
else:
    c = next(c for c in ui["controls"] if c["name"] == name)
    at = [c["x"] + c["w"] / 2, c["y"] + c["h"] / 2]
print(round(at[0]), round(at[1]))
P
}
move() { local at; at=$(place "$@"); xdotool mousemove $at; }
click() { move "$@"; sleep 0.1; xdotool mousedown 1; sleep 0.1; xdotool mouseup 1; settle; }
drag() {  # grid, then pairs of cells
  local grid=$1; shift
  move "$grid" "$1" "$2"; sleep 0.1; xdotool mousedown "${BUTTON:-1}"; shift 2
  while (($#)); do sleep 0.1; move "$grid" "$1" "$2"; shift 2; done
  sleep 0.1; xdotool mouseup "${BUTTON:-1}"; settle
}
key() { xdotool key "$@"; settle; }
words() { xdotool type --delay 60 "$1"; settle; }
away() { xdotool mousemove 2 2; settle; }  # no hint under the pointer
shot() {  # name [crop WxH+X+Y]
  import -silent -window root "$work/$1.png"
  convert "$work/$1.png" ${2:+-crop "$2" +repage} -strip -quality 84 "$out/$1.jpg"
}

# wants NAME: whether this picture is asked for.
wants() { [[ -z ${PAGES:-} || " $PAGES " == *" $1 "* ]]; }
quiet='{"toured":true,"cloth":false}'   # the draft alone
weave() { "$weftlight" weave "$1" -o "$work/$2.wif" --ends "$3" --picks "$3" "${@:4}"; }

open_display 1180 760
if wants window; then
  open_window "$root/presets/drafts/starter.wif" '{"toured":true}'
  away; shot window
fi
if wants threading; then
  weave straight scarf 24
  open_window "$work/scarf.wif" "$quiet"
  for i in 8 10 12 14; do drag threading "$i" $((10 - i & 3)); done  # ends 9, 11, 13 and 15 run down the shafts
  shot threading 1180x480+0+28
fi
if wants colours; then
  weave straight scarf 24
  open_window "$work/scarf.wif" "$quiet"
  click palette.add; click palette.color; key ctrl+a; words "#c8553d"; key Return
  drag warp_colors 8 0 15 0
  shot colours 1180x480+0+28
fi
if wants dyed; then
  open_window "$root/presets/drafts/ikat.wif" '{"toured":true}'
  click inspector:Yarns; click yarn.list; click yarn:3; click section.yarns; click section.dye
  away; shot dyed
fi
if wants weave; then
  weave straight scarf 48
  open_window "$work/scarf.wif" "$quiet"
  key w; click weave:undulating_twill
  away; shot weave; key Escape
fi
if wants floats; then
  weave overshot towel 48
  open_window "$work/towel.wif" "$quiet"
  key F5; click inspector:Analysis
  move floats.limit; xdotool mousemove_relative -- -40 0 mousedown 1; sleep 0.1; xdotool mouseup 1; settle  # to 3
  away; shot floats
fi
if wants sections; then
  weave straight towel 16
  open_window "$work/towel.wif" "$quiet"
  for i in 8 9 10 11; do drag threading "$i" $((11 - i)); done
  key shift+w
  click sections.last; key ctrl+a; words 8; click sections.take
  click sections.first; key ctrl+a; words 9; click sections.last; key ctrl+a; words 12; click sections.take
  click sections.order; words "A 2x, B 3x, A"
  away; shot sections; key Escape
fi
if wants print; then
  weave overshot towel 48
  open_window "$work/towel.wif" "$quiet"
  key ctrl+shift+p
  away; shot print; key Escape
fi
if wants loom; then
  open_window "$root/presets/drafts/overshot.wif" "$quiet"
  key F9; key space; key space; key space
  away; shot loom
fi
if wants recovery; then
  weave straight scarf 24
  open_window "$work/scarf.wif" "$quiet"
  drag threading 0 3; drag threading 1 3; drag threading 2 3
  sleep 1; kill -9 $window; wait $window 2>/dev/null || true; rm "$work/map.json"
  "$weftlight" --ui-map "$work/map.json" 2>/dev/null &
  window=$!
  until [[ -s $work/map.json ]]; do sleep 0.1; done
  settle; away; shot recovery
fi
if wants export; then
  cp "$root/presets/cloths/denim.wif" "$work"
  open_window "$work/denim.wif" "$quiet"
  key ctrl+e; sleep 2
  away; shot export; key Escape
fi
if wants methods; then
  open_window "$root/presets/drafts/starter.wif" '{"toured":true,"inspector":false}'
  move view; xdotool click --repeat 4 --delay 60 4; settle
  key F6; sleep "${TRACE:-10}"; away; shot methods 510x600+669+28; key F6
fi
if wants split; then
  open_window "$root/presets/cloths/denim.wif" '{"toured":true,"inspector":false}'
  key F7; sleep "${TRACE:-40}"; away; shot split 510x600+669+28
fi
if wants plan; then
  close_window; kill $server
  open_display 1180 1150
  weave herringbone towel 64
  printf '\n[PRIVATE WEFTLIGHT PLAN]\nWidth=500\nLength=700\nPieces=6\nReed=60\nSleying=2\n' >>"$work/towel.wif"
  open_window "$work/towel.wif" "$quiet"
  click inspector:Plan
  away; shot plan 440x830+740+34
fi
close_window

if wants cloths; then
  for name in denim flannel silk_satin organza; do
    "$weftlight" render "$root/presets/cloths/$name.wif" -o "$work/$name.png" --size 420x400 --samples "${SAMPLES:-16}" --quiet
  done
  convert "$work"/{denim,flannel}.png +append "$work/top.png"
  convert "$work"/{silk_satin,organza}.png +append "$work/bottom.png"
  convert "$work/top.png" "$work/bottom.png" -append -strip -quality 84 "$out/cloths.jpg"
fi
# washed PICTURE DRAFT VIEW LOOM WASHED (yarns a pixel): off the loom, where a yarn takes more room, and washed, at the same scale.
washed() {
  local draft=$root/presets/drafts/$2.wif
  sed 's/^PRIVATE WEFTLIGHT PLAN=true/&\nPRIVATE WEFTLIGHT FINISH=true/' "$draft" >"$work/loom.wif"
  printf '\n[PRIVATE WEFTLIGHT FINISH]\nWashed=0\n' >>"$work/loom.wif"
  near() { "$weftlight" render "$1" -o "$2" --size 420x360 --samples "${SAMPLES:-24}" --mesh plane --view "$3" --yarns-per-pixel "$4" --quiet; }
  near "$work/loom.wif" "$work/loom.png" "$3" "$4"
  near "$draft" "$work/washed.png" "$3" "$5"
  convert "$work/loom.png" "$work/washed.png" +append -strip -quality 84 "$out/$1.jpg"
}
if wants washed; then washed washed waffle 25,25 0.104 0.13; fi
if wants deflected; then washed deflected deflected_double_weave 15,20 0.085 0.1; fi
if wants near; then
  "$weftlight" render "$root/presets/cloths/tweed.wif" -o "$work/near.png" --size 840x420 --samples "${SAMPLES:-16}" --mesh plane \
    --view 15,25 --yarns-per-pixel 0.04 --quiet
  convert "$work/near.png" -strip -quality 84 "$out/near.jpg"
fi
