# shellcheck shell=bash
# Sourced by make_*.sh with the name of the output folder and, unless it is the release build, the path of weftlight.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$root/docs/$1
weftlight=${2:-$root/build/release/weftlight}
drafts=$root/presets/drafts
work=$(mktemp -d /tmp/weaver.XXX)  # pictures of the window show it
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
