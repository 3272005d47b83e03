#!/usr/bin/env bash
# The programs whose code runs on several threads, built by the preset tsan, one after another. $1: the build folder.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export TSAN_OPTIONS="suppressions=$here/tsan.supp halt_on_error=0 exitcode=66 die_after_fork=0 ${TSAN_OPTIONS:-}"
for program in base_test session_test render_data_test reference_test; do
  "$1/tests/$program" --gtest_brief=1 --gtest_filter="${2:-*}"
done
