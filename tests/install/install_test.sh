#!/usr/bin/env bash
# Installs into an empty folder and runs the program from there: it must use the installed files, not those of the source
# tree. Usage: install_test.sh CMAKE BUILD SOURCE
set -euo pipefail
cmake=$1 build=$2 source=$3
unset WEFTLIGHT_PRESETS WEFTLIGHT_SHADERS WEFTLIGHT_LANGUAGES
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
fail() { echo "failed: $*" >&2; exit 1; }

DESTDIR=$root "$cmake" --install "$build" --prefix /usr >"$root/log" || { cat "$root/log"; fail "cmake --install"; }
share=$root/usr/share
for file in usr/bin/weftlight usr/share/weftlight/presets/lod_table.csv usr/share/weftlight/presets/drafts/starter.wif \
  usr/share/weftlight/shaders/cloth.frag usr/share/applications/weftlight.desktop \
  usr/share/mime/packages/weftlight.xml usr/share/icons/hicolor/scalable/apps/weftlight.svg; do
  [[ -s $root/$file ]] || fail "$file is not installed"
done
if command -v desktop-file-validate >/dev/null; then desktop-file-validate "$share/applications/weftlight.desktop"; fi
if command -v update-mime-database >/dev/null; then
  update-mime-database "$share/mime" || fail "the MIME type"
  grep -q 'x-wif:\*.wif' "$share/mime/globs2" || fail "*.wif is not of the MIME type"
fi

# From elsewhere, through a link, as a user would.
ln -s "$root/usr/bin/weftlight" "$root/weftlight"
cd /
draft=$share/weftlight/presets/drafts/starter.wif
"$root/weftlight" info "$draft" >/dev/null || fail "info"
render() { "$root/weftlight" render "$draft" -o "$root/picture.png" --size 64x48 --mesh plane --method flat; }
record=${WEFTLIGHT_NOT_DRAWN:+$WEFTLIGHT_NOT_DRAWN/install.runs_from_where_it_lies}  # read by tests/house/drawing.sh
if [[ -n $record ]]; then rm -f "$record"; fi
code=0
render 2>"$root/said" || code=$?
if ((code == 4)); then
  if [[ -n $record ]]; then mkdir -p "${record%/*}" && cp "$root/said" "$record"; fi
  echo "skipped: no graphics here: $(cat "$root/said")"
  exit 77
fi
((code == 0)) || fail "render: $(cat "$root/said")"
[[ -s $root/picture.png ]] || fail "there is no picture"

# Broken installed files must cause errors, which shows that they are used.
echo broken >"$share/weftlight/presets/lod_table.csv"
render 2>"$root/said" || fail "render with a broken LOD table"
grep -q "$share/weftlight/presets/lod_table.csv" "$root/said" || fail "the LOD table is not the installed one: $(cat "$root/said")"
echo "#error installed" >"$share/weftlight/shaders/cloth.frag"
! render 2>"$root/said" || fail "the shaders are not the installed ones"
