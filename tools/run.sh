#!/usr/bin/env bash
# Sets the machine up, builds Talus, solves a project, pictures and films it, and opens it where there is a display.
# Usage: tools/run.sh [PROJECT]        PROJECT: a .talus file; the Jiweishan rockslide when absent
set -euo pipefail
project=$(realpath --canonicalize-missing "${1:-$(dirname "${BASH_SOURCE[0]}")/../samples/jiweishan/jiweishan.talus}")
if [[ ! -f $project ]]; then
  echo "$project: there is no such file; name a .talus project file" >&2
  exit 2
fi
results=${project%.talus}.results
source "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"

install_packages
configure
build talus talus-cli
cli=$build/app/talus-cli

# 1 means that the run ended without converging, or a check failed: what was computed is still worth a picture.
outcome=0
"$cli" solve "$project" --out "$results" || outcome=$?
[[ $outcome -le 1 ]] || exit "$outcome"
"$cli" render "$results" --out "$results/picture.png"
"$cli" animate "$results" --out "$results/film.mp4"
"$cli" plot "$results" --out "$results/histories.png"

echo "Results    $results"
echo "Picture    $results/picture.png"
echo "Film       $results/film.mp4"
echo "Histories  $results/histories.png"
echo "Outcome    $(sed -n 's/.*"status": *"\([a-z-]*\)".*/\1/p' "$results/summary.json" | head -1)"
if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
  "$build/app/talus" "$results"
fi
exit "$outcome"
