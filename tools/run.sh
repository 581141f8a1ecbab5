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
picture=$results/picture.png film=$results/film.mp4 histories=$results/histories.png
source "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"

install_packages
configure
build talus talus-cli
cli=$build/app/talus-cli

# Exit code 1 says that the run did not converge or missed an expectation: what was computed is still worth a look.
outcome=0
report=$("$cli" solve "$project" --out "$results") || outcome=$?
[[ $outcome -le 1 ]] || exit "$outcome"
echo "$report"
"$cli" render "$results" --out "$picture"
"$cli" animate "$results" --out "$film"
if head -1 "$results/history.csv" | grep --quiet displacement; then
  published=$(dirname "$project")/paper_events.csv events=()
  [[ -f $published ]] && events=(--events "$published")
  "$cli" plot "$results" --out "$histories" "${events[@]}"
else
  histories='none: the project has no monitor'
fi

echo
echo "Outcome    $(sed -n '1 { N; s/\n/: /p }' <<<"$report")"
echo "Results    $results"
echo "Picture    $picture"
echo "Film       $film"
echo "Histories  $histories"
if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
  "$build/app/talus" "$results"
fi
exit "$outcome"
