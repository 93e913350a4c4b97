#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
# usage: console/translations/update.sh [file.ts]     takes the console's strings into the files of the languages; new ones are
# "unfinished" there until somebody translates them (test console.language fails until then)
set -euo pipefail
cd "$(dirname "$0")/.."
lupdate=$(command -v lupdate || echo /usr/lib/qt6/bin/lupdate)
"$lupdate" -silent -no-obsolete -locations none -source-language en -target-language de -I .. \
  app cues link models pages report view3d widgets -ts "${1:-translations/swage_de.ts}"
