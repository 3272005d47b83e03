#!/usr/bin/env bash
# Runs clang-tidy (.clang-tidy) on the C++ files that differ from a base: $WEFTLIGHT_TIDY_BASE, else the point where the branch
# left main, else the previous commit. $1: source folder; $2: build folder with compile_commands.json. A changed header is
# checked through the .cpp beside it. Exits with 77, and says why, if it cannot check.
set -euo pipefail
cd "$1"
tool=$(command -v clang-tidy-14 || command -v clang-tidy) || { echo "clang-tidy is not installed: not checked"; exit 77; }
git rev-parse --git-dir >/dev/null 2>&1 || { echo "not a git checkout: not checked"; exit 77; }
base=${WEFTLIGHT_TIDY_BASE:-}
if [[ -z $base ]]; then
  for main in origin/main main; do
    if git rev-parse -q --verify "$main" >/dev/null; then base=$(git merge-base HEAD "$main"); break; fi
  done
  [[ -n $base && $base != $(git rev-parse HEAD) ]] || base=$(git rev-parse -q --verify HEAD~1) ||
    { echo "no commit to compare with: not checked"; exit 77; }
fi
mapfile -t files < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.h' | sed 's/\.h$/.cpp/' | sort -u)
known=()
for file in "${files[@]}"; do
  if [[ -f $file ]] && grep -qF "$file\"" "$2/compile_commands.json"; then known+=("$file"); fi
done
((${#known[@]})) || { echo "no C++ file differs from ${base:0:9}"; exit 0; }
echo "${#known[@]} files differ from ${base:0:9}"
# Without GCC's precompiled headers, which it cannot read, and the warnings that are off for their sake: so it also sees what a
# file forgot to include.
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
sed -E 's# -Winvalid-pch -include [^ "]*/cmake_pch\.hxx##; s# -Wno-(array-bounds|stringop-over(flow|read)|restrict)##g' \
  "$2/compile_commands.json" >"$commands/compile_commands.json"
printf '%s\0' "${known[@]}" | xargs -0 -n 1 -P "$(nproc)" "$tool" -p "$commands" --quiet --warnings-as-errors='*' 2>/dev/null
