#!/usr/bin/env bash
# Line coverage of core, folder by folder, of the tests that ran in a build folder of the preset `coverage`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(realpath "${1:?usage: tests/coverage.sh BUILD_FOLDER}")
if ! command -v gcovr >/dev/null; then
  echo "gcovr is not installed (Debian: gcovr)" >&2
  exit 1
fi
gcovr --root "$root" --filter "$root/core/" --csv - "$build" | awk -F, '
  # A header is known by the link that targets include it through: BUILD/include/ROOM/ROOM/x.h.
  NR > 1 { at = match($1, "/include/"); n = split(at ? substr($1, at + 8) : $1, path, "/")
           lines[path[2]] += $2; run[path[2]] += $3 }
  END {
    for (folder in lines) {
      printf "%-12s %5.1f %%  of %d lines\n", folder, 100 * run[folder] / lines[folder], lines[folder] | "sort"
      all += lines[folder]; all_run += run[folder]
    }
    close("sort")
    if (all > 0) printf "%-12s %5.1f %%  of %d lines\n", "core", 100 * all_run / all, all
  }'
