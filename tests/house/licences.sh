#!/usr/bin/env bash
# Every file has a licence, by the rules of REUSE (.reuse/dep5, LICENSES), and the one that packages bring is the same:
# licences.sh SOURCE
set -euo pipefail
cd "$1"
grep -q '^License: Expat$' editor/desktop/copyright || { echo "the packages' licence is not the MIT one (Expat)"; exit 1; }
words() { tr -s ' \n' '\n\n' | grep -v '^\.\?$'; }
diff <(sed -n '/^Permission/,$p' LICENSE | words) <(sed -n '/^ Permission/,$p' editor/desktop/copyright | words) >/dev/null ||
  { echo "editor/desktop/copyright has other words than LICENSE"; exit 1; }
command -v reuse >/dev/null || { echo "skipped: reuse is not installed (package reuse)"; exit 77; }
[[ -e .git ]] || { echo "skipped: no repository, whose files reuse would list"; exit 77; }
reuse lint || exit 1
