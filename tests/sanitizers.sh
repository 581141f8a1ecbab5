#!/usr/bin/env bash
# Builds core with sanitizers, in folders of its own, and runs its unit tests, cases with a known answer and samples.
# Usage: tests/sanitizers.sh address [TEST…]     address and undefined behaviour (preset sanitized): all unit tests of
#                                                core, and the samples, or the programs that are named (test_io)
#        tests/sanitizers.sh threads [TEST…]     data races (preset threads): what works on several threads
#        tests/sanitizers.sh quick               of both what continuous integration runs: all that cuts and meshes
#                                                nothing, and of contacts on several threads one model
# As many programs as there are cores run at a time (TALUS_JOBS). Exit code 1 where one of them finds something, or a
# test fails.
set -euo pipefail
kind=$1
shift
cd "$(dirname "${BASH_SOURCE[0]}")/.."
meshless=(base model orientation io mesh linear bodies contact effects results fields measures export solve run)
meshing=(templates removability geometry study verification)
threaded=(base linear contact effects solve run results)
export jobs=${TALUS_JOBS:-$(nproc)} OPENBLAS_NUM_THREADS=1
# Leaks are valgrind's part: gmsh and OpenCASCADE end without tidying up.
export ASAN_OPTIONS=detect_leaks=0:strict_string_checks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export TSAN_OPTIONS=halt_on_error=1:suppressions=$PWD/tests/support/threads.supp

# run_one PRESET TEST [FILTER]: says on one line how it ended, and what was found.
run_one() {
  local preset=$1 test=$2 filter=${3:-*} begin=$SECONDS log=build/$1/$2.log
  local program
  program=$(find "build/$preset/tests" -name "$test" -type f -perm -u+x | head -1)
  if "$program" --gtest_brief=1 --gtest_filter="$filter" >"$log" 2>&1; then
    echo "$preset, $test: clean, $((SECONDS - begin)) s"
  elif grep -q "ThreadSanitizer: unexpected memory mapping" "$log"; then
    echo "$preset, $test: not run, this kernel lays memory out as ThreadSanitizer does not know it (vm.mmap_rnd_bits)"
  else
    echo "$preset, $test: see $log, $((SECONDS - begin)) s"
    grep -m 5 -E "runtime error|ERROR: |WARNING: ThreadSanitizer|\[  FAILED" "$log"
    return 1
  fi
}
export -f run_one

# run_all PRESET TEST[ FILTER]…
run_all() {
  local preset=$1
  shift
  cmake --preset "$preset" >/dev/null
  cmake --build "build/$preset" --parallel "$jobs" --target "${@%% *}"
  printf '%s\n' "$@" | xargs -P "$jobs" -I{} bash -c 'set -f; run_one '"$preset"' {}'
}

addresses=("${meshless[@]/#/test_}")
threads=()
models=""  # of contacts all, each a parameter of the tests
[[ $kind != quick ]] || models=/0
for test in "${threaded[@]/#/test_}"; do
  case $test in
    test_base) threads+=("$test Parallel*") ;;
    test_linear | test_effects) threads+=("$test *Cores*") ;;
    test_contact) threads+=("$test *Threads*$models") ;;
    test_solve) threads+=("$test *TwoThreads*") ;;
    *) threads+=("$test") ;;
  esac
done
failed=0
case $kind in
  address)
    samples="test_validation *Sample*:*ladder*:*wedge*:-Long/*:Jiweishan.*:JointedBench.*"
    all=("${addresses[@]}" "${meshing[@]/#/test_}" "$samples")
    [[ $# -eq 0 ]] || all=("$@")
    run_all sanitized "${all[@]}" || failed=1
    ;;
  threads)
    [[ $# -eq 0 ]] || threads=("$@")
    run_all threads "${threads[@]}" || failed=1
    ;;
  quick)
    run_all sanitized "${addresses[@]}" || failed=1
    run_all threads "${threads[@]}" || failed=1
    ;;
  *) echo "address, threads or quick, not $kind" >&2 && exit 2 ;;
esac
exit $failed
