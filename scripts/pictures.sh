#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Pictures of every page of the console, to be looked at: filled with a synthetic school and empty, 1280x800 and 1920x1080, English and
# German; and a knot of the thread, tied and cut off. Needs a build of the preset and Debian's package xvfb.
#
#   scripts/pictures.sh <folder> [preset] [all or readme]
#
# "readme": those of the first page alone, under the names that they have in resources/pictures, to be copied there once they were looked at.
set -euo pipefail
folder=${1:?folder for the pictures}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$(dirname "$0")/.."
bin=build/${2:-release}/bin
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb

# settings of its own for each picture, as the console remembers its layout
picture() {
  local name=$1
  shift
  XDG_CONFIG_HOME=$(mktemp -d) XDG_DATA_HOME=$folder/data xvfb-run -a -s "-screen 0 1920x1080x24" \
    timeout 120 "$bin/swage-console" "$@" --at "${at:-1}" --screenshot "$folder/$name.png" 2>"$folder/$name.log" ||
    echo "$name: see $folder/$name.log"
}

# a lesson's expert, by the moment of the attempt in s; then options of the console
live() {
  local lesson=$1
  shift
  picture "$lesson" "lessons/series/$lesson.json" --store :none: --start --device expert --person Guest --mode demo --seed 3 --language en "$@"
}

# The knot is replayed from a headless attempt: its steps are slower than real time on most machines.
first_page() {
  at=9.6 live 110_insertion --size 1440x900
  mv "$folder/110_insertion.png" "$folder/console_insertion.png"
  at=8.9 live 110_insertion --trainee side --size 1440x900
  mv "$folder/110_insertion.png" "$folder/trainee_stereo.png"
  at=4.5 live 050_suture_grasp --size 1280x800
  mv "$folder/050_suture_grasp.png" "$folder/console_suture.png"
  local knots=$folder/knots.db
  [ -f "$knots" ] || "$bin/swage" run lessons/series/132_square_knot.json --headless --as-fast-as-possible --device expert --store "$knots" >"$folder/knots.log"
  at=53.5 picture square_knot --review latest --store "$knots" --size 1600x1000 --language en --view near --zoom 6
}

if [ "${3:-all}" = readme ]; then
  first_page
  exit
fi

school=$folder/school.db empty=$folder/empty.db
[ -f "$school" ] || "$bin/swage" people synthetic --store "$school" --attempts 1200

for language in en de; do
  for size in 1280x800 1920x1080; do
    for page in run lessons courses people review setup stations; do
      review=()
      [ "$page" != review ] || review=(--review latest)
      picture "${page}_filled_${size}_$language" --page "$page" --store "$school" --size "$size" --language "$language" "${review[@]}"
      picture "${page}_empty_${size}_$language" --page "$page" --store "$empty" --size "$size" --language "$language"
    done
  done
done

thread=$folder/thread.db
[ -f "$thread" ] || "$bin/swage" run resources/pictures/thread_cut.json --headless --as-fast-as-possible --store "$thread" >"$folder/thread.log"
for moment in tied:0.4 between_blades:1.12 cut:3.9; do
  at=${moment#*:} picture "thread_${moment%:*}" --review latest --store "$thread" --size 1600x1000 --language en --view near
done
