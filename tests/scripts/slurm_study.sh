#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# usage: slurm_study.sh SWAGE SOURCE [KILLS]     a study as an array of three tasks on a cluster of one node, submitted twice: the same
# table and figure, byte for byte, as one program makes. KILLS: how often the workers of the array are killed (kill -9) at a random
# moment, and the array is submitted again. 77 where no Slurm starts.
set -euo pipefail
swage=${1:?program} source=${2:?source folder} kills=${3:-0}
# attempts per level: enough that the study is not done before the last kill
repeats=$((4 + 40 * kills))
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
export HOME=$here SWAGE=$swage
cat >"$here/drop.json" <<'JSON'
{ "format": "swage-lesson/1", "id": "org.example.drop", "title": "Drop", "scene_length": "1 mm",
  "requires": { "swage.object.solids": "^1", "swage.lesson.look": "^1", "swage.device.mouse": "^1" },
  "devices": [ { "name": "hand", "plugin": "swage.device.mouse" } ],
  "objects": [ { "name": "ball", "plugin": "swage.object.solids" } ],
  "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "0.01 s" } } }
JSON
cat >"$here/study.json" <<JSON
{ "format": "swage-study/1", "title": "How long", "lesson": "drop.json", "repeats": $repeats,
  "factors": [ { "name": "Duration", "levels": [ { "name": "short", "set": { "lesson.duration": "0.02 s" } },
                                                 { "name": "long", "set": { "lesson.duration": "0.04 s" } } ] } ],
  "hands": [ { "name": "nobody", "device": "mouse" } ],
  "figures": [ { "metric": "time.task", "title": "Time", "unit": "ms", "scale": 1000, "file": "time.svg" } ] }
JSON
"$swage" study "$here/study.json" --out "$here/alone" >"$here/alone.txt"
cat >"$here/submit.sh" <<'SH'
set -euo pipefail
cd "$HOME"
script=$1/resources/slurm/study_array.sh
# the programs of this array and no others: its folder is in their words
workers="study study.json --out $HOME/together --shard"
killed=0
for ((kill = 0; kill < $2; ++kill)); do
  sbatch --array=1-3 --output=killed-%a.txt "$script" study.json "$HOME/together" >/dev/null
  for _ in $(seq 600); do pgrep -f "$workers" >/dev/null && break; sleep 0.05; done
  sleep "0.$((RANDOM % 300 + 100))"
  if pkill -KILL -f "$workers"; then killed=$((killed + 1)); fi
  scancel --user "$(id -un)"
  for _ in $(seq 600); do [ -z "$(squeue -h)" ] && break; sleep 0.05; done
done
[ "$killed" = "$2" ] || { echo "$killed of $2 arrays were killed in the middle" >&2; exit 1; }
sbatch --wait --array=1-3 --output=task-%a.txt "$script" study.json "$HOME/together"
grep -q "shard 2 of 3 is done" task-2.txt
sbatch --wait --array=1-3 --output=again-%a.txt "$script" study.json "$HOME/together"
SH
"$(dirname "$0")/slurm_node.sh" "$here/node" bash "$here/submit.sh" "$source" "$kills"
"$swage" study "$here/study.json" --out "$here/together" --merge >"$here/together.txt"
cmp "$here/alone.txt" "$here/together.txt"
cmp "$here/alone/attempts.csv" "$here/together/attempts.csv"
cmp "$here/alone/time.svg" "$here/together/time.svg"
[ "$(wc -l <"$here/alone/attempts.csv")" = $((1 + 2 * repeats)) ] || { echo "$((2 * repeats)) attempts are expected" >&2; exit 1; }
