#!/usr/bin/env bash
# Holds what the program for Windows says and writes of drafts against this system's, byte by byte: all shipped drafts and
# cloths, all weaves, and input that is refused; and a set of textures, whose pictures two encoders write, pixel by pixel.
# Usage: verbs.sh PROGRAM OTHER FOLDER
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
programs=("$1" "$2") made=$3
rm -rf "$made" && mkdir -p "$made"/{0,1}/"ä ж 布"
cp -r "$root"/presets/{drafts,cloths} "$made"
wrong=0

# same CODE NAME VERB ARGUMENT...: both programs print the same and end with this code. Relative names are in a folder of each.
same() {
  local expected=$1 name=$2 k code
  shift 2
  for k in 0 1; do
    code=0
    (cd "$made/$k" && LC_ALL=C.UTF-8 "${programs[k]}" "$@" >"$name.txt" 2>&1) || code=$?
    [[ $code == "$expected" ]] || { echo "$name: exit code $code instead of $expected from ${programs[k]}"; wrong=1; }
  done
}

for draft in "$made"/*/*.wif; do
  name=$(basename "$(dirname "$draft")").$(basename "$draft" .wif)
  same 0 "$name.info" info "$draft"
  same 0 "$name.analyse" analyse "$draft"
  same 0 "$name.drawdown" drawdown "$draft"
  same 0 "$name.convert" convert "$draft" "$name.wif" --liftplan --tidy
done
same 0 print print "$made/drafts/starter.wif" -o starter.pdf
same 0 drawing drawdown "$made/drafts/starter.wif" -o starter.svg
mapfile -t weaves < <("$1" weave --list --language C | grep -oE '^[a-z_0-9]+')
for weave in "${weaves[@]}"; do same 0 "weave.$weave" weave "$weave" -o "weave.$weave.wif"; done
same 0 letters convert "$made/drafts/plain.wif" "ä ж 布/плетение.wif"
same 3 missing info "$made/nowhere.wif"
same 2 verb unravel "$made/drafts/plain.wif"
same 2 option render "$made/drafts/plain.wif" --ouput x.png
same 5 no_folder weave twill -o nowhere/at/all.wif
echo "$((2 * ${#weaves[@]} + 6 * $(find "$made"/{drafts,cloths} -name '*.wif' | wc -l))) files of weaves and drafts compared"

same 0 export export "$made/cloths/linen.wif" -o set --target gltf --size 256
textures=0
while IFS= read -r picture; do
  off=$(compare -metric RMSE "$made/0/$picture" "$made/1/$picture" null: 2>&1 | sed 's/.*(\(.*\))/\1/') || true
  # The words of a sheet are drawn by two libraries.
  [[ $picture == *contact_sheet.png ]] && most=0.03 || most=0.002
  awk -v off="$off" -v most=$most 'BEGIN {exit !(off < most)}' || { echo "$picture is $off off"; wrong=1; }
  textures=$((textures + 1))
done < <(cd "$made/0" && find set -name '*.png')
echo "$textures textures compared"
# Cairo rounds halves as the C library does, and PDF holds fonts of the system.
for k in 0 1; do
  [[ $(head -c4 "$made/$k/starter.pdf") == %PDF && $(grep -c '<path' "$made/$k/starter.svg") -gt 1000 ]] ||
    { echo "the sheets of ${programs[k]} are not whole"; wrong=1; }
  rm "$made/$k/starter.pdf" "$made/$k/starter.svg"
done
# What holds the bytes of the pictures, names them by a hash, or holds numbers whose last digits differ.
find "$made"/[01]/set \( -name '*.png' -o -name '*.gl*' -o -name texture_set.json \) -delete
sed -i 's|\\|/|g' "$made/1/export.txt"
diff -r "$made/0" "$made/1" | head -20
diff -rq "$made/0" "$made/1" >/dev/null || wrong=1
exit $wrong
