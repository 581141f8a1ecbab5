#!/usr/bin/env bash
# Builds core with sanitizers, in a folder of its own, and runs its unit tests, cases with a known answer and samples.
# Usage: tests/sanitizers.sh address [TEST…]     address and undefined behaviour (preset sanitized): all unit tests of
#                                                core, and the samples, or the programs that are named (test_io)
#        tests/sanitizers.sh quick               the same of what cuts and meshes nothing: for continuous integration
#        tests/sanitizers.sh threads [TEST…]     data races (preset threads): what works on several threads
# Exit code 1 where one of them finds something, or a test fails.
set -euo pipefail
kind=$1
shift
cd "$(dirname "${BASH_SOURCE[0]}")/.."
all=(base model orientation io templates mesh removability geometry linear bodies contact effects results fields
  measures export solve run study verification)
meshless=(base model orientation io mesh linear bodies contact effects results fields measures export solve run)
threaded=(base contact solve run results)
declare -A filter=([test_validation]="*Sample*:*ladder*:*wedge*:-Long/*:Jiweishan.*:JointedBench.*")
case $kind in
  address | quick)
    preset=sanitized
    tests=("${all[@]/#/test_}" test_validation)
    [[ $kind == address ]] || tests=("${meshless[@]/#/test_}")
    # Leaks are valgrind's part: gmsh and OpenCASCADE end without tidying up.
    export ASAN_OPTIONS=detect_leaks=0:strict_string_checks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
    ;;
  threads)
    preset=threads
    tests=("${threaded[@]/#/test_}")
    export TSAN_OPTIONS=halt_on_error=1:suppressions=$PWD/tests/support/threads.supp OMP_NUM_THREADS=1
    filter[test_base]="Parallel*" filter[test_contact]="*Threads*" filter[test_solve]="*TwoThreads*"
    ;;
  *) echo "address, quick or threads, not $kind" >&2 && exit 2 ;;
esac
[[ $# -eq 0 ]] || tests=("$@")
cmake --preset "$preset" >/dev/null
cmake --build "build/$preset" --target "${tests[@]}"
export OPENBLAS_NUM_THREADS=1
failed=0
for test in "${tests[@]}"; do
  program=$(find "build/$preset/tests" -name "$test" -type f -perm -u+x | head -1)
  begin=$SECONDS log=build/$preset/$test.log
  if "$program" --gtest_brief=1 --gtest_filter="${filter[$test]:-*}" >"$log" 2>&1; then
    echo "$test: clean, $((SECONDS - begin)) s"
  else
    echo "$test: see $log, $((SECONDS - begin)) s"
    grep -m 5 -E "runtime error|ERROR: |WARNING: ThreadSanitizer|\[  FAILED" "$log" || true
    failed=1
  fi
done
exit $failed
