#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# in_shards.sh starts each process once with a number of its own, prints what each prints, and fails if one fails.
set -euo pipefail
in_shards=${1:?tests/in_shards.sh}
fail() { echo "shards_test: $1" >&2; exit 1; }
numbers=$("$in_shards" 3 bash -c 'echo "$GTEST_SHARD_INDEX of $GTEST_TOTAL_SHARDS $0"' argument)
[ "$numbers" = $'0 of 3 argument\n1 of 3 argument\n2 of 3 argument' ] || fail "printed: $numbers"
for broken in 0 1 2; do
  if "$in_shards" 3 bash -c "[ \$GTEST_SHARD_INDEX != $broken ]" 2>/dev/null; then fail "process $broken failed unnoticed"; fi
done
