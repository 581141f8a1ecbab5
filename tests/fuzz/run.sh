#!/usr/bin/env bash
# Builds the targets of libFuzzer (preset fuzz: clang) and lets each run on its corpus, one after the other.
# Usage: tests/fuzz/run.sh SECONDS|inputs=N [TARGET…]     TARGET: project, results, tables, dxf, terrain or stl;
#                                                         default: all, each for so long or with so many inputs
# What is new stays in build/fuzz/corpus, what fails in build/fuzz/failures: exit code 1. A failure is replayed by
# build/fuzz/tests/fuzz/fuzz_TARGET FILE; mended, it becomes a unit test of what it broke. A target ends with its first
# crash, exception that is a fault of the program (exit code 3), finding of a sanitizer, input of over 10 s or over 3 GB.
set -euo pipefail
case $1 in
  inputs=*) amount=-runs=${1#inputs=} ;;
  *) amount=-max_total_time=$1 ;;
esac
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

# figure LOG NAME: what libFuzzer counted.
figure() { sed -n "s/^stat::$2: *//p" "$1"; }

for target in "${targets[@]}"; do
  mkdir -p "build/fuzz/corpus/$target" "build/fuzz/failures/$target"
  log=build/fuzz/$target.log found=0
  build/fuzz/tests/fuzz/fuzz_"$target" "$amount" -timeout=10 -rss_limit_mb=3000 -max_len=200000 -print_final_stats=1 \
    -artifact_prefix="build/fuzz/failures/$target/" "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target" \
    >"$log" 2>&1 || found=1
  ((!found)) || { failed=1 && grep -a -m 3 -E "^SUMMARY|ERROR|runtime error" "$log"; }
  echo "$target: $(figure "$log" number_of_executed_units) inputs, $found faults," \
    "$(figure "$log" average_exec_per_sec) a second, the slowest $(figure "$log" slowest_unit_time_sec) s;" \
    "$(grep -a "times refused" "$log")"
done
exit $failed
