#!/usr/bin/env bash
# The volumes of damaged input that a release is held to, and how they ended: no crash, nothing over 10 s, no exit
# code 3, each refusal one line of less than 500 characters.
# Usage: tests/fuzz/volumes.sh TALUS_CLI [PART [SEED]]     PART: of so many one; 1, as for a release, by default
# By libFuzzer 1 000 000 projects, 100 000 results and checkpoints, and 10 000 each of tables, DXF, terrain and STL; by
# the program itself, with its mesher, 10 000 files of solids and terrain (mostly STEP), projects and results.
set -euo pipefail
cli=$(realpath "$1") part=${2:-1} seed=${3:-1}
cd "$(dirname "${BASH_SOURCE[0]}")"
failed=0
./run.sh "inputs=$((1000000 / part))" project || failed=1
./run.sh "inputs=$((100000 / part))" results || failed=1
./run.sh "inputs=$((10000 / part))" tables dxf terrain stl || failed=1
for what in solids projects results; do
  echo "$what, by the program:"
  ./mutate.py "$cli" "$what" --count "$((10000 / part))" --seed "$seed" || failed=1
done
exit $failed
