#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#SBATCH --job-name=swage-study
# A study on many machines that share a folder, one task of an array per shard (Slurm, Debian's slurm-wlm):
#
#   job=$(sbatch --parsable --array=1-8 study_array.sh STUDY.json OUT [more options of "swage study"])
#   sbatch --dependency=afterok:$job --wrap "swage study STUDY.json --out OUT --merge [the same options]"
#
# A task that was killed goes on where it was when it is submitted again. SWAGE: the program, "swage" unless set.
set -euo pipefail
study=${1:?study file} out=${2:?folder}
shift 2
: "${SLURM_ARRAY_TASK_ID:?this is a task of an array: sbatch --array=1-8 ...}"
index=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))
exec "${SWAGE:-swage}" study "$study" --out "$out" --shard "$index/$SLURM_ARRAY_TASK_COUNT" "$@"
