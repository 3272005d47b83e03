#!/usr/bin/env bash
# Makes the packages, and installs, runs and removes them in folders of their own.
# Usage: package_test.sh CPACK BUILD SOURCE
set -euo pipefail
cpack=$1 build=$2 source=$3
unset WEFTLIGHT_PRESETS WEFTLIGHT_SHADERS WEFTLIGHT_LANGUAGES
for tool in dpkg dpkg-deb dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is missing (package dpkg-dev)"; exit 77; }
done
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
fail() { echo "failed: $*" >&2; exit 1; }

"$cpack" --config "$build/CPackConfig.cmake" -G "DEB;TGZ" -B "$root/packages" >"$root/log" 2>&1 || { cat "$root/log"; fail cpack; }
deb=$(ls "$root"/packages/weftlight_*.deb) archive=$(ls "$root"/packages/weftlight-*.tar.gz)

# What it depends on is computed from the program, and what it opens while it runs is named.
depends=$(dpkg-deb -f "$deb" Depends)
for package in libc6 libegl1 fonts-inter libopenimageio; do
  [[ $depends == *$package* ]] || fail "it does not depend on $package: $depends"
done
# What a package manager shows of each: a line, and then more, in lines that fit a terminal.
for package in "$root"/packages/*.deb; do
  (($(dpkg-deb -f "$package" Description | wc -l) > 2)) || fail "$(basename "$package") has no description"
  dpkg-deb -f "$package" Description | grep -E '^.{81}' && fail "a line of its description is too long"
done
[[ $(dpkg-deb -f "$deb" Version) == "$("$build/weftlight" --version | cut -d' ' -f2)" ]] || fail "the version"

# Installed into an empty system, and removed without a trace.
system=$root/system
mkdir -p "$system/var/lib/dpkg/updates" "$system/var/lib/dpkg/info"
touch "$system/var/lib/dpkg/status" "$system/var/lib/dpkg/available"
dpkg_there() { dpkg --root="$system" --log=/dev/null --force-depends --force-not-root --force-bad-path "$@" >"$root/log" 2>&1 || { cat "$root/log"; fail "dpkg $*"; }; }
dpkg_there -i "$deb"
for file in bin/weftlight share/applications/weftlight.desktop share/mime/packages/weftlight.xml \
  share/metainfo/org.weftlight.Weftlight.metainfo.xml share/man/man1/weftlight.1 share/doc/weftlight/copyright \
  share/bash-completion/completions/weftlight share/zsh/vendor-completions/_weftlight \
  share/fish/vendor_completions.d/weftlight.fish share/weftlight/presets/drafts/starter.wif; do
  [[ -s $system/usr/$file || -s $system/usr/$file.gz ]] || fail "$file is not installed"
done
grep -qaF "$source" "$system/usr/bin/weftlight" && fail "the program names the folder of its source"
share=$system/usr/share
(cd / && "$system/usr/bin/weftlight" info "$share/weftlight/presets/drafts/starter.wif" >/dev/null) || fail "info"

# The handbook, where it could be built: its first page, and what that needs.
if [[ -s $build/handbook/index.html ]]; then
  for file in index.html weavers.html style.css pictures_window.jpg; do
    [[ -s $system/usr/share/doc/weftlight/handbook/$file ]] || fail "the handbook's $file is not installed"
  done
fi

# The shells understand their completions.
completed() { bash -c 'source "$1"; COMP_WORDS=("${@:2}"); COMP_CWORD=$(($# - 2)); _weftlight; echo "${COMPREPLY[*]}"' - \
  "$share/bash-completion/completions/weftlight" "$@"; }
(cd "$root" && [[ $(completed weftlight rend) == render ]]) || fail "bash completes the verb"
[[ $(completed weftlight render --method ya) == yarn ]] || fail "bash completes a value"
[[ $(completed weftlight render --turn) == --turntable ]] || fail "bash completes an option"
if command -v zsh >/dev/null; then zsh -n "$share/zsh/vendor-completions/_weftlight" || fail "zsh"; fi
if command -v fish >/dev/null; then fish -n "$share/fish/vendor_completions.d/weftlight.fish" || fail "fish"; fi
page=$(ls "$share"/man/man1/weftlight.1*)
if command -v man >/dev/null; then
  MANROFFSEQ='' man --warnings -E UTF-8 -l -Tutf8 -Z "$page" >/dev/null 2>"$root/log"
  [[ ! -s $root/log ]] || { cat "$root/log"; fail "the manual page"; }
fi
for verb in info render export; do grep -q "weftlight $verb" <(zcat -f "$page") || fail "$verb is not in the manual page"; done
if command -v appstreamcli >/dev/null; then
  # AppStream 1.0 fails where there is no home page to name, which 0.16 does not know.
  appstreamcli validate --no-net "$share"/metainfo/*.xml >"$root/log" ||
    { grep -q '^W:.* url-homepage-missing' "$root/log" && ! grep '^[EW]:' "$root/log" | grep -v url-homepage-missing; } ||
    { cat "$root/log"; fail "the AppStream data"; }
fi
# The module for Python: a package of its own, which finds the program's files.
grep -q dist-packages <(dpkg-deb -c "$deb"; tar -tzf "$archive") && fail "the program's packages hold the Python module"
module=$(find "$root/packages" -maxdepth 1 -name 'python3-weftlight_*.deb')
if [[ -n $module ]]; then
  depends=$(dpkg-deb -f "$module" Depends)  # OpenImageIO comes with the program
  for package in "weftlight (= $(dpkg-deb -f "$deb" Version))" python3-numpy 'python3 (>= 3.' libembree; do
    [[ $depends == *$package* ]] || fail "the Python module does not depend on $package: $depends"
  done
  dpkg_there --force-script-chrootless -i "$module"
  python=$system/usr/lib/python3/dist-packages
  for file in __init__.py __init__.pyi py.typed; do [[ -e $python/weftlight/$file ]] || fail "$file is not installed"; done
  grep -qaF "$source" "$python"/weftlight/*.so && fail "the Python module names the folder of its source"
  if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
    (cd / && PYTHONPATH=$python PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "
import sys, weftlight
design = weftlight.read('$share/weftlight/presets/drafts/starter.wif').design
weftlight.reference(design, 8, 8, spp=1)  # the drape and the lights are found") || fail "the Python module"
  fi
  dpkg_there --force-script-chrootless -P python3-weftlight
fi
dpkg_there -P weftlight
left=$(find "$system" -path "$system/var/lib/dpkg" -prune -o -type f -print)
[[ -z $left ]] || fail "left behind: $left"

# The archive runs from wherever it is unpacked.
mkdir "$root/elsewhere"
tar -xzf "$archive" -C "$root/elsewhere"
(cd / && "$root"/elsewhere/weftlight-*/bin/weftlight info "$root"/elsewhere/weftlight-*/share/weftlight/presets/drafts/starter.wif >/dev/null) ||
  fail "the unpacked archive"
