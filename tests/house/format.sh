#!/usr/bin/env bash
# Every C++ file as clang-format lays it out. 77: not checked here, and why.
set -euo pipefail
cd "$1"
tool=$(command -v clang-format-14 || command -v clang-format) || { echo "clang-format is not installed: not checked"; exit 77; }
"$tool" --version | grep -q 'version 14\.' || { echo "$("$tool" --version): the tree is laid out by 14: not checked"; exit 77; }
git rev-parse --git-dir >/dev/null 2>&1 || { echo "not a git checkout: not checked"; exit 77; }
git ls-files -z '*.cpp' '*.h' | xargs -0 "$tool" --dry-run -Werror
