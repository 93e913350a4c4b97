#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Builds Swage and opens the console with the sample lesson. Without a display the same lesson runs headless with the
# scripted expert, and the result is printed.
#
#   scripts/run.sh [lesson.json] [options of swage-console or swage run]
set -euo pipefail
cd "$(dirname "$0")/.."
lesson=lessons/series/020_grasp_basic.json
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  lesson=$1
  shift
fi

scripts/setup.sh build
export SWAGE_CMAKE_OPTIONS=
[ -f build/release/build.ninja ] || SWAGE_CMAKE_OPTIONS="-DSWAGE_TESTS=OFF -DSWAGE_BENCH=OFF"
scripts/build.sh release

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  echo "== console: $lesson (F5 starts, F1 shows the keys)"
  exec build/release/bin/swage-console "$lesson" "$@"
fi
echo "== no display: the scripted expert runs $lesson at 1 kHz"
exec build/release/bin/swage run "$lesson" --headless --device expert "$@"
