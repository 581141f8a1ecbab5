#!/usr/bin/env bash
# Kills runs at random moments and resumes them: each must come to the same bits as a run that nobody disturbed.
# Usage: tests/kill_and_resume.sh TALUS_CLI KILLS PROJECT...
# For every project, on one and on two threads, KILLS times: solves it, kills it with SIGKILL, sees that the frames it
# had announced are readable, kills the resumed run as well every other time, resumes it to its end, and compares
# history.csv and all frames. Exit code 1 and the seed where something differs. SEED=N begins elsewhere.
set -euo pipefail
cli=$1 kills=$2
shift 2
RANDOM=${SEED:-1}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
total=0 resumed=0 begun=0 failed=0

milliseconds() { date +%s%3N; }

# Solves into $folder/run, and kills it after a random part of the time that a whole run takes.
killed_run() {
  local after=$((RANDOM * whole_time / 32767))
  "$cli" solve "$project" --out "$folder/run" --threads "$threads" --checkpoint-every 0.02 --resume \
    >/dev/null 2>&1 &
  local process=$!
  sleep "$((after / 1000)).$(printf %03d $((after % 1000)))"
  kill -KILL $process 2>/dev/null || true
  wait $process 2>/dev/null || true
}

# What was announced must be readable: nothing is before log.txt is there.
readable() {
  [[ ! -f $folder/run/log.txt ]] || "$cli" info "$folder/run" >"$folder/info" 2>&1
}

same_as_whole() {
  cmp -s "$folder/whole/history.csv" "$folder/run/history.csv" || return 1
  rm -rf "$folder/run_frames"
  "$cli" export "$folder/run" --as vtu --out "$folder/run_frames" >/dev/null 2>&1
  diff -rq "$folder/whole_frames" "$folder/run_frames" >/dev/null
}

fault() {
  echo "$1: $project on $threads threads, kill $kill of seed ${SEED:-1}" >&2
  failed=$((failed + 1))
}

for project in "$@"; do
  for threads in 1 2; do
    rm -rf "$folder"/*
    start=$(milliseconds)
    "$cli" solve "$project" --out "$folder/whole" --threads "$threads" >/dev/null 2>&1
    whole_time=$(($(milliseconds) - start))
    "$cli" export "$folder/whole" --as vtu --out "$folder/whole_frames" >/dev/null 2>&1
    for ((kill = 1; kill <= kills; ++kill)); do
      rm -rf "$folder/run"
      total=$((total + 1))
      killed_run
      readable || fault "not readable"
      ((kill % 2)) || killed_run
      if [[ -f $folder/run/checkpoint.h5 ]]; then resumed=$((resumed + 1)); else begun=$((begun + 1)); fi
      # Killed while its folder was being made, it has left files that are no results.
      [[ -f $folder/run/results.h5 ]] || rm -rf "$folder/run"
      "$cli" solve "$project" --out "$folder/run" --threads "$threads" --resume >"$folder/out" 2>&1 ||
        fault "not resumed ($(tail -1 "$folder/out"))"
      same_as_whole || fault "other bits"
    done
  done
done
echo "$total runs killed: $resumed resumed from a checkpoint, $begun begun anew, $failed with a fault"
[[ $failed == 0 ]]
