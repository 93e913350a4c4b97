#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Sets up, builds and tests everything.
#
#   scripts/test.sh            what CI runs: every test but the soak ones, golden hashes at -O2 and at -O0
#   scripts/test.sh asan|tsan  the same tests under AddressSanitizer and UBSan, or ThreadSanitizer
#   scripts/test.sh -R name    further arguments go to ctest
set -euo pipefail
cd "$(dirname "$0")/.."
preset=test
groups=(build test)
case "${1:-}" in
  asan | tsan | clang) preset=$1; groups+=(clang); shift ;;
esac

scripts/setup.sh "${groups[@]}"
scripts/build.sh "$preset"

echo "== tests: build/$preset"
# threads of ours bring a stack for signals of their own
export ASAN_OPTIONS=${ASAN_OPTIONS:-use_sigaltstack=0}
# undefined behaviour ends the process, so that its test fails
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-halt_on_error=1:print_stacktrace=1}
# a crash of a plugin is for our own sentinel and for whoever waits for a child
export TSAN_OPTIONS=${TSAN_OPTIONS:-handle_segv=0:handle_abort=0:die_after_fork=0}
export LSAN_OPTIONS=${LSAN_OPTIONS:-suppressions=$PWD/scripts/leaks_of_others.txt:print_suppressions=0}
export QT_QPA_PLATFORM=${QT_QPA_PLATFORM:-offscreen} LIBGL_ALWAYS_SOFTWARE=1 LP_NUM_THREADS=1
# timing-sensitive tests are few and serial; the rest shares the cores, in thirds (PROCESSORS in SwageRooms.cmake)
ctest --test-dir "build/$preset" -LE soak -j "$((3 * $(nproc)))" --output-on-failure "$@"

if [ "$preset" = test ] && [ $# -eq 0 ]; then
  scripts/build.sh debug0 determinism_at_O0
  echo "== tests: golden hashes at -O0"
  ctest --test-dir build/debug0 -L determinism --output-on-failure
fi
