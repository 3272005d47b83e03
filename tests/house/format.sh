#!/usr/bin/env bash
# Checks that every C++ file is formatted by clang-format. Exits with 77, and says why, if it cannot check.
set -euo pipefail
cd "$1"
tool=$(command -v clang-format-14 || command -v clang-format) || { echo "clang-format is not installed: not checked"; exit 77; }
"$tool" --version | grep -q 'version 14\.' || { echo "$("$tool" --version): the source is formatted by version 14: not checked"; exit 77; }
git rev-parse --git-dir >/dev/null 2>&1 || { echo "not a git checkout: not checked"; exit 77; }
git ls-files -z '*.cpp' '*.h' | xargs -0 "$tool" --dry-run -Werror
