#!/usr/bin/env bash
# `./check windows`: builds the program for Windows with mingw-w64 and tests it under Wine (docs/other_systems.md): core by its
# unit tests, the verbs against this system's program, small pictures against the stored ones, and the window by real clicks.
# Usage: tests/windows/check.sh [options of ctest for the unit tests]
# Skipped (exit code 77) where mingw-w64 or Wine cannot be had.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
editor/desktop/windows/build.sh
command -v wine >/dev/null || { echo "skipped: wine is not installed (third_party/packages.txt, windows)"; exit 77; }
cmake --build build/windows --target windows_tests
[[ -f build/check/build.ninja ]] || cmake --preset check >/dev/null
cmake --build build/check --target weftlight golden_test gui_test
# Wine's own folder of settings and its Windows, so that a user's is left alone.
export WINEPREFIX=$root/build/windows/wine WINEDEBUG=-all WINEDLLOVERRIDES=winemenubuilder.exe=d
unset DISPLAY
[[ -d $WINEPREFIX ]] || wine wineboot --init >/dev/null 2>&1
trap 'wineserver -k 2>/dev/null || true' EXIT
result=0
failed() { echo "FAILED: $*"; result=1; }
ctest --test-dir build/windows --output-on-failure -j "$(nproc)" "$@" || failed "unit tests"

# Wine's server leaves with its last program, and one that starts just then fails. A shell of Windows that waits holds it.
hold_server() {
  local pipe
  pipe=$(mktemp -u)
  mkfifo "$pipe"
  exec 9<>"$pipe"
  rm "$pipe"
  wine cmd /c 'set /p waited=' <&9 >/dev/null 2>&1 9>&- &
}
end_server() {
  wineserver -k 2>/dev/null || true
  wineserver -w
}

program=$root/tests/windows/program.sh
end_server
hold_server
tests/windows/verbs.sh "$root/build/check/weftlight" "$program" "$root/build/windows/verbs" || failed "verbs"
end_server

export WEFTLIGHT_PROGRAM=$program
# Those without the ground, whose ambient shadow needs Embree.
xvfb-run -a bash -c "$(declare -f hold_server)"'; hold_server; exec "$@"' held \
  build/check/tests/golden/golden_test --gtest_brief=1 \
  --gtest_filter='*twill_vrst03:*satin_threads:*gauze_gaps:*satin_engine:*twill_irawan' || failed "pictures"

# Each case with a desktop of its own, which Wine keeps on the display of its first program. Left out are suites about what only
# POSIX has (lost displays, reports of crashes, hung disks), and cases about the ray-traced threads, a printer's queue, two
# displays, links, limits of a process, other programs, and a focus that a window manager gives. The time limit is far above
# the patience of one expectation (a minute), so that a case says itself what did not come; its display ends with it.
cd build/check/tests/gui
mapfile -t cases < <(./gui_test --gtest_list_tests | awk '/^[^ ]/ {suite = $1} /^  / {print suite $1}' |
  grep -E '^(WindowTest|KillTest|FilesTest|TabsTest|DeskTest|DrawingTest|ToolsTest|Ways/ClickTest|Ways/PressTest)\.' |
  grep -vE 'ComparesWithTheRayTraced|PrintsOnTheSystemsPrinter|TwoWindowsOnOneFile|CanBeReloadedOrReplaced|Kdialog|ThroughALink|AFailedSaveIs|WhileTheNameOfALoomIs|ARightClickOpens')
try() { timeout --kill-after=10 600 ./gui_test --gtest_brief=1 --gtest_filter="$1" >window.txt 2>&1; }
for case in "${cases[@]}"; do
  end_server
  status=0
  try "$case" || status=$?
  # Wine's own word: its server leaves with its last program, and one that starts just then loses it.
  if ((status)) && grep -q '^wine client error' window.txt; then
    echo "Wine lost its server, again: $case"
    status=0
    try "$case" || status=$?
  fi
  ((status == 0)) || { cat window.txt; failed "$case, exit code $status"; }
done
((${#cases[@]} > 0)) || failed "gui_test lists no case"
echo "${#cases[@]} cases of the window"
exit $result
