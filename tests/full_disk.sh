#!/usr/bin/env bash
# Lets the disk be full at 200 points of a run: the program must say so, what it had written must be readable, and once
# there is room the run must go on to the same numbers. As root: it mounts a small file system of its own.
# Usage: tests/full_disk.sh TALUS_CLI PROJECT
set -euo pipefail
[[ ${in_own_mounts:-} ]] || exec env in_own_mounts=1 unshare --mount "$0" "$@"
cli=$1 project=$2 failed=0
folder=$(mktemp -d)
trap 'umount "$folder/disk" && rm -rf "$folder"' EXIT
"$cli" solve "$project" --out "$folder/whole" >/dev/null 2>&1
mkdir "$folder/disk"
mount -t tmpfs -o size=1m tmpfs "$folder/disk"
# Kilobytes that the run takes, with its checkpoint twice.
room=$(($(du -sk "$folder/whole" | cut -f1) + 2 * $(du -k "$folder/whole/checkpoint.h5" | cut -f1)))
declare -A ended=()

fault() {
  echo "$1, with $size k: $(tail -1 "$folder/said")" >&2
  failed=$((failed + 1))
}

solve() {
  local code=0
  timeout -s KILL 60 "$cli" solve "$project" --out "$folder/disk/r" "$@" >"$folder/out" 2>"$folder/said" || code=$?
  echo "$code"
}

for ((point = 1; point <= 200; ++point)); do
  size=$((16 + room * point / 200))
  rm -rf "$folder"/disk/*
  mount -o "remount,size=${size}k" "$folder/disk"
  code=$(solve --checkpoint-every 0.005)
  ended[$code]=$((${ended[$code]:-0} + 1))
  ((code <= 2)) || fault "exit code $code"
  if ((code == 1)); then
    grep -q "cannot be written: No space left on device, at t = .* kept; make room and go on with --resume" \
      "$folder/out" || fault "does not say why"
    "$cli" info "$folder/disk/r" >/dev/null 2>"$folder/said" || fault "not readable"
  fi
  mount -o remount,size=1g "$folder/disk"
  ((code != 2)) || rm -rf "$folder"/disk/r  # nothing was computed yet
  code=$(solve --resume)
  ((code == 0)) || fault "not resumed, exit code $code"
  cmp -s "$folder/whole/history.csv" "$folder/disk/r/history.csv" || fault "other numbers"
done
for code in "${!ended[@]}"; do echo "${ended[$code]} runs ended with exit code $code"; done
echo "$failed faults"
((failed == 0))
