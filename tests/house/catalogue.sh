#!/usr/bin/env bash
# The catalogue of what users read: catalogue.sh SOURCE PROGRAM
# It is as new as the sources, translations keep the names in braces, and the program speaks what a catalogue says.
set -euo pipefail
source=$1 program=$2
for tool in xgettext msgfmt msgen msgcat; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed (package gettext)"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$*" >&2; exit 1; }

"$source/editor/languages/extract.sh" "$work/now.pot" 2>"$work/said" || fail "$(cat "$work/said")"
diff -u "$source/editor/languages/weftlight.pot" "$work/now.pot" >"$work/diff" ||
  fail "weftlight.pot is older than the sources; run editor/languages/extract.sh: $(head -40 "$work/diff")"

shopt -s nullglob
catalogues=("$source"/editor/languages/*.po)
for catalogue in "${catalogues[@]}"; do
  msgfmt --check -o /dev/null "$catalogue" || fail "$catalogue does not compile"
done
"$source/tests/house/translations.py" "${catalogues[@]}" || fail "translations lose what the program needs"

# A language that is English in brackets.
mkdir -p "$work/languages/xx/LC_MESSAGES"
msgen --lang=xx "$work/now.pot" 2>/dev/null | msgcat --no-wrap - |
  sed -E '/^msgid_plural|^msgid/!s/^(msgstr(\[[01]\])?) "(.+)"$/\1 "[\3]"/' >"$work/xx.po"
msgfmt -o "$work/languages/xx/LC_MESSAGES/weftlight.mo" "$work/xx.po"
said=$(WEFTLIGHT_LANGUAGES=$work/languages "$program" --language xx info "$work/none.wif" 2>&1 || true)
[[ $said == *'['*']'* ]] || fail "--language xx does not speak the catalogue: $said"
plain=$("$program" info "$work/none.wif" 2>&1 || true)
[[ $plain != *'['* ]] || fail "without a catalogue the program does not speak English: $plain"
echo "$(grep -c '^msgid ' "$work/now.pot") texts"
