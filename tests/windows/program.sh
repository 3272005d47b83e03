#!/bin/bash
# Runs the program that was built for Windows under Wine, as if it were one of this system: tests of the window and of pictures
# take it by WEFTLIGHT_PROGRAM (tests/program.h). Names of files keep their form, since / is the drive that Wine calls Z:;
# folders that variables name need the drive to be absolute there. Some tests leave PATH empty.
export PATH=$PATH:/usr/bin:/bin
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export WINEPREFIX=${WINEPREFIX:-$root/build/windows/wine} WINEDEBUG=-all WINEDLLOVERRIDES=winemenubuilder.exe=d
export WEFTLIGHT_FILE_DIALOG=window
export MESA_SHADER_CACHE_DIR=$WINEPREFIX/mesa  # of the driver, which is one of this system
for name in HOME XDG_STATE_HOME XDG_CONFIG_HOME XDG_CACHE_HOME; do
  [[ ${!name:-} == /* ]] && export "$name=Z:${!name}"
done
exec wine "$root/build/windows/installed/weftlight.exe" "$@"
