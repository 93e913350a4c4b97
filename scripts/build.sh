#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# usage: scripts/build.sh <preset> [target...]     configures when needed and builds; quick the second time
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:?preset: dev test release debug0 clang asan tsan}
shift
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
options=()
[ -n "${SWAGE_CMAKE_OPTIONS:-}" ] && read -ra options <<<"$SWAGE_CMAKE_OPTIONS"
# what setup.sh installed since then may be what an optional part was waiting for (the peers of the bench, for one);
# dpkg-query fails where one of them was never installed
packages=$({ dpkg-query -W -f='${Package} ${Status}\n' $(awk '!/^#/ { print $2 }' scripts/packages.txt) 2>/dev/null || true; } |
  awk '/install ok installed/ { print $1 }' | sort)
known=build/$preset/packages_configured_with.txt
if [ ! -f "build/$preset/build.ninja" ] || [ ${#options[@]} -gt 0 ] || [ "$packages" != "$(cat "$known" 2>/dev/null)" ]; then
  echo "== configure: build/$preset"
  log=$(mktemp)
  trap 'rm -f "$log"' EXIT
  cmake --preset "$preset" "${options[@]}" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
  echo "$packages" >"$known"
fi
echo "== build: build/$preset ${*:-everything} (the first time takes minutes, later seconds)"
if [ -t 1 ]; then status='[%f/%t %es] '; else status='[%f/%t] '; fi
NINJA_STATUS=$status cmake --build "build/$preset" ${1:+--target "$@"} |
  awk -v tty="$([ -t 1 ] && echo 1 || echo 0)" '
    # every line on a terminal; elsewhere one line in forty, and everything that is no progress
    tty || !/^\[[0-9]+\/[0-9]+\]/ || (++n % 40 == 1) { print; fflush() }'
