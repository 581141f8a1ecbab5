#!/usr/bin/env bash
# Builds the targets of libFuzzer (preset fuzz: clang) and lets each run on its corpus, one after the other.
# Usage: tests/fuzz/run.sh SECONDS [TARGET…]      TARGET: project, results, tables, dxf, terrain or stl; default: all
# What is new stays in build/fuzz/corpus, what fails in build/fuzz/failures: exit code 1. A failure is replayed by
# build/fuzz/tests/fuzz/fuzz_TARGET FILE; mended, it becomes a unit test of what it broke.
set -euo pipefail
seconds=$1
shift
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
targets=("${@:-project}")
[[ $# -gt 0 ]] || targets=(project results tables dxf terrain stl)
command -v clang++ >/dev/null || { echo "clang++ is missing: apt install clang" >&2 && exit 77; }
cmake --preset fuzz >/dev/null
cmake --build build/fuzz --target "${targets[@]/#/fuzz_}" >/dev/null
# HDF5 loses some memory of files that are damaged.
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 ASAN_OPTIONS=detect_leaks=0
[[ ! -d /dev/shm ]] || export TMPDIR=/dev/shm
failed=0
for target in "${targets[@]}"; do
  mkdir -p "build/fuzz/corpus/$target" "build/fuzz/failures/$target"
  echo "$target: $seconds s"
  log=build/fuzz/$target.log
  build/fuzz/tests/fuzz/fuzz_"$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=3000 -max_len=200000 \
    -artifact_prefix="build/fuzz/failures/$target/" "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target" \
    >"$log" 2>&1 || { failed=1 && grep -m 3 -E "^SUMMARY|ERROR|runtime error" "$log"; }
  tail -2 "$log"
done
exit $failed
