#!/usr/bin/env bash
# A file says by name what it uses of other rooms: using_directives.sh SOURCE
# No `using namespace` in the program and its tests, but for literals and for GLM in the formulas that C++ shares with GLSL.
set -euo pipefail
cd "$1"
if git --version >/dev/null 2>&1 && [[ -e .git ]]; then mapfile -t files < <(git ls-files 'core/*.h' 'core/*.cpp' 'editor/*.h' 'editor/*.cpp' 'tools/*.h' 'tools/*.cpp' 'tests/*.h' 'tests/*.cpp')
else mapfile -t files < <(find core editor tools tests -name '*.h' -o -name '*.cpp'); fi
((${#files[@]} > 100)) || { echo "only ${#files[@]} files found"; exit 1; }
found=$(grep -nHE '^[[:space:]]*using namespace' "${files[@]}" | grep -vE 'using namespace (std::[a-z_]*literals|glm);' || true)
if [[ -n $found ]]; then
  echo "Name what is used (using draft::Draft;) instead of a whole room:"
  echo "$found"
  exit 1
fi
echo "${#files[@]} files say by name what they use"
