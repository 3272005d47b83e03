#!/usr/bin/env bash
# Installs the packages of packages.txt that are missing (Debian/Ubuntu, apt).
# Usage: third_party/install.sh build|test|web|windows|coverage    (test includes build, the others include both)
# Asks nothing when all is there; elsewhere than on apt it prints the names.
set -euo pipefail
want=${1:-build}
list=$(dirname "$0")/packages.txt
kinds=" build $want "
[[ $want == web || $want == windows || $want == coverage ]] && kinds+="test "
mapfile -t names < <(awk -v kinds="$kinds" '!/^#/ && NF && index(kinds, " " $2 " ") {print $1}' "$list")
if ! command -v dpkg-query >/dev/null 2>&1; then
  # Not Debian: CMake names whatever is missing.
  if ! command -v cmake >/dev/null 2>&1; then
    printf 'Weftlight needs these packages (Debian names):\n  %s\n' "${names[*]}" >&2
    exit 1
  fi
  exit 0
fi
missing=()
have=$(dpkg-query -W -f '${db:Status-Abbrev} ${Package} ${Provides}\n' 2>/dev/null | grep '^ii' || true)
for name in "${names[@]}"; do
  # One of the names of a line that has several.
  grep -qE "^ii +(${name//+/\\+})( |,|$)" <<<"$have" && continue
  # nodejs may bring npm itself (NodeSource); any command of that name will do.
  case $name in nodejs) command -v node >/dev/null 2>&1 && continue ;; npm) command -v npm >/dev/null 2>&1 && continue ;; esac
  missing+=("$name")
done
((${#missing[@]})) || exit 0
sudo=
if ((EUID != 0)); then
  command -v sudo >/dev/null 2>&1 || { echo "Weftlight needs: ${missing[*]}. Install them as root (apt-get install)." >&2; exit 1; }
  sudo=sudo
fi
echo "Installing ${#missing[@]} packages: ${missing[*]}"
$sudo apt-get update -qq
for i in "${!missing[@]}"; do
  for one in ${missing[i]//|/ }; do
    if apt-cache show "$one" >/dev/null 2>&1; then missing[i]=$one; break; fi
  done
done
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
