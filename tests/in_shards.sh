#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Runs the tests of a GoogleTest program in several processes at once: for tests that mostly wait.
#
# usage: tests/in_shards.sh <processes> <program> [argument...]     fails if one of them fails; prints what each printed
set -euo pipefail
export GTEST_TOTAL_SHARDS=${1:?processes} GTEST_SHARD_INDEX
program=${2:?program}
shift 2
logs=$(mktemp -d)
trap 'rm -rf "$logs"; kill $(jobs -p) 2>/dev/null || true' EXIT
shards=()
for ((GTEST_SHARD_INDEX = 0; GTEST_SHARD_INDEX < GTEST_TOTAL_SHARDS; ++GTEST_SHARD_INDEX)); do
  "$program" "$@" >"$logs/$GTEST_SHARD_INDEX" 2>&1 &
  shards+=($!)
done
failed=0
for i in "${!shards[@]}"; do
  wait "${shards[$i]}" || { failed=1; echo "process $i of $GTEST_TOTAL_SHARDS failed" >&2; }
  cat "$logs/$i"
done
exit $failed
