#!/usr/bin/env bash
# Which pictures were not tested because nothing could be drawn: drawing.sh PROGRAM SOURCE FOLDER
# FOLDER holds a file for each test that could not draw when it last ran; its name is that of the test, its text the
# reason. Exits with 77 if there is one, or if PROGRAM cannot draw now; with 1 in CI (CI=true), where all must be drawn.
set -euo pipefail
program=$1 source=$2 folder=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

code=0
"$program" render "$source/presets/drafts/starter.wif" -o "$work/picture.png" --size 16x16 --mesh plane --method flat \
  >/dev/null 2>"$work/said" || code=$?
((code == 0 || code == 4)) || { echo "render fails with exit code $code: $(cat "$work/said")"; exit 1; }
shopt -s nullglob
tests=("$folder"/*)
if ((code == 0 && ${#tests[@]} == 0)); then
  echo "every picture was drawn"
  exit 0
fi

line=$(printf '#%.0s' {1..100})
printf '%s\n# NOT TESTED: PICTURES\n%s\n' "$line" "$line"
if ((code == 4)); then
  echo "This program draws nothing here: $(cat "$work/said")"
fi
if ((${#tests[@]})); then
  printf '\nTests that could not draw when they last ran: %d\n' "${#tests[@]}"
  # One paragraph a suite, its name first.
  printf '%s\n' "${tests[@]##*/}" | LC_ALL=C sort |
    awk -F. '{ name = $NF; sub(/\.[^.]*$/, ""); if ($0 != suite) printf "%s%s:", (NR > 1 ? "\n" : ""), $0; suite = $0
               printf " %s", name } END { print "" }' | fold -s -w 98 | sed 's/^/  /'
  printf '\n%s\n' "Because of:"
  cat "${tests[@]}" | LC_ALL=C sort -u | sed 's/^/  /'
fi
echo "$line"
if [[ ${CI:-} =~ ^(1|true|yes)$ ]]; then
  echo "In CI every picture must be drawn: give this machine EGL (Debian: libegl1 and libgl1-mesa-dri) and Xvfb."
  exit 1
fi
exit 77
