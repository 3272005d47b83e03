#!/usr/bin/env bash
# The list of pictures that were not tested: drawing_test.sh PROGRAM SOURCE TEST_PROGRAM, where TEST_PROGRAM has the suite
# Average, which draws.
set -euo pipefail
program=$1 source=$2 test=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export WEFTLIGHT_NOT_DRAWN=$work/not_drawn
fail() { echo "failed: $*" >&2; exit 1; }
average() { "$test" --gtest_filter='Average.*' >"$work/tested" 2>&1; }
list() { "$source/tests/house/drawing.sh" "$program" "$source" "$WEFTLIGHT_NOT_DRAWN" >"$work/said" 2>&1; }
code_of() { local code=0; "$@" || code=$?; echo $code; }
names_it() { grep -q 'Average: OfEqual' "$work/said" && grep -q 'when they last ran: 1$' "$work/said"; }

export WEFTLIGHT_OFFSCREEN=none
[[ $(code_of average) == 77 ]] || fail "a test that draws does not skip: $(cat "$work/tested")"
export CI=
[[ $(code_of list) == 77 ]] || fail "the list is not skipped: $(cat "$work/said")"
names_it && grep -q 'draws nothing here' "$work/said" || fail "the list lacks what was not drawn: $(cat "$work/said")"
export CI=true
[[ $(code_of list) == 1 ]] || fail "CI passes without pictures: $(cat "$work/said")"
names_it || fail "CI does not name what was not drawn: $(cat "$work/said")"

# Where drawing works but a test did not draw, CI fails too; once the test has drawn, it does not.
unset WEFTLIGHT_OFFSCREEN
"$program" render "$source/presets/drafts/starter.wif" -o "$work/picture.png" --size 16x16 --mesh plane \
  --method flat >/dev/null 2>&1 ||
  { echo "skipped: no graphics here"; exit 77; }
[[ $(code_of list) == 1 ]] && names_it || fail "CI passes with a test that did not draw: $(cat "$work/said")"
average || fail "$(cat "$work/tested")"
list || fail "a test that has drawn is still listed: $(cat "$work/said")"
