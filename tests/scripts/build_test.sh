#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# usage: build_test.sh <folder of the scripts>     build.sh configures when it must and only then; cmake and dpkg-query stand in
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tree" "$work/bin"
cp -r "$1" "$work/tree/scripts"

cat >"$work/bin/cmake" <<'STAND_IN'
#!/usr/bin/env bash
if [ "$1" = --preset ]; then
  mkdir -p "build/$2"
  touch "build/$2/build.ninja"
  echo configured >>"$LOG"
fi
STAND_IN
cat >"$work/bin/dpkg-query" <<'STAND_IN'
#!/usr/bin/env bash
for package in $INSTALLED; do echo "$package install ok installed"; done
echo "dpkg-query: no packages found matching libode-dev" >&2
exit 1  # as the real one does on a machine that has never heard of one of them
STAND_IN
chmod +x "$work/bin/cmake" "$work/bin/dpkg-query"
export LOG=$work/log PATH=$work/bin:$PATH
touch "$LOG"

configured() {  # <how often until now> <packages that are installed>
  INSTALLED=$2 "$work/tree/scripts/build.sh" dev >/dev/null
  [ "$(wc -l <"$LOG")" = "$1" ] || { echo "configured $(wc -l <"$LOG") times, not $1, with: $2" >&2; exit 1; }
}
configured 1 "cmake"
configured 1 "cmake"
configured 2 "cmake libode-dev"
configured 2 "cmake libode-dev"
SWAGE_CMAKE_OPTIONS=-DX=1 configured 3 "cmake libode-dev"
