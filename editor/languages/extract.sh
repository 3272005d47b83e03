#!/usr/bin/env bash
# Collects the texts that the user reads from the sources: extract.sh [OUT.pot], without OUT into weftlight.pot here.
# Keys are tr, tr_n, tr_in and mark (core/base/translated.h, mark.h).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=${1:-$here/weftlight.pot}
cd "$here/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
find core editor tools -name '*.cpp' -o -name '*.h' | LC_ALL=C sort |
  xgettext --files-from=- --language=C++ --from-code=UTF-8 --keyword --keyword=tr --keyword=tr_n:1,2 \
           --keyword=tr_in:1c,2 --keyword=mark --add-location=file --package-name=Weftlight --output="$work/all.pot"
# Without the date, so that the same sources give the same file. English is a catalogue too, with its plural. xgettext takes
# "5% of" for a format; those of the sliders begin with it.
sed -e '/^"POT-Creation-Date/d; s/charset=CHARSET/charset=UTF-8/' \
    -e 's/nplurals=INTEGER; plural=EXPRESSION/nplurals=2; plural=(n != 1)/' \
    -e '/^#, c-format$/{N;/\nmsgid "%\./!s/^#, c-format\n//}' "$work/all.pot" >"$out"
