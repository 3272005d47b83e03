#!/usr/bin/env bash
# The program as it is shipped is hardened: hardened.sh PROGRAM
set -euo pipefail
program=$1
command -v readelf >/dev/null || { echo "skipped: readelf is not installed (package binutils)"; exit 77; }
lacks=0
has() {  # WHAT, a pattern, and the table of readelf in which it stands
  local table
  table=$(readelf --wide "$3" "$program")
  grep -qE "$2" <<<"$table" || { echo "$program has no $1"; lacks=1; }
}
has "code that can lie anywhere (PIE)" 'Type: +DYN' --file-header
has "read-only tables after the start (RELRO)" 'GNU_RELRO' --program-headers
has "functions that are all found at the start (BIND_NOW)" 'BIND_NOW|FLAGS.* NOW' --dynamic
has "stack that cannot be run" 'GNU_STACK .* RW +0x' --program-headers
has "check of the stack (-fstack-protector-strong)" '__stack_chk_fail' --dyn-syms
has "check of copies (_FORTIFY_SOURCE)" '__(read|memcpy|memmove|snprintf|fprintf|readlink|vsnprintf|realpath)_chk' --dyn-syms
exit $lacks
