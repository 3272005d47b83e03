# shellcheck shell=bash
# Sourced by make_*.sh with the name of their folder and the path of weftlight, where it is not the release build.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$root/docs/$1
weftlight=${2:-$root/build/release/weftlight}
drafts=$root/presets/drafts
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
