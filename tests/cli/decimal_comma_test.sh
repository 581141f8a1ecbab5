#!/bin/bash
# What talus-cli writes is the same, byte for byte, where numbers have a comma.
# Usage: decimal_comma_test.sh TALUS_CLI SAMPLES IN_GERMAN
set -eu
cli=$1 samples=$2 in_german=$3
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
cat > "$folder/work.sh" << 'WORK'
set -eu
cd "$1"
"$2" new wedge --friction 25.5 wedge.talus > new.txt
"$2" mesh wedge.talus --json > mesh.json
"$2" stereonet wedge.talus --face 65.5/140.25 --friction 25.5 --table joints.csv > net.txt
"$2" mesh "$3/step_slope/step_slope.talus" > table.txt
"$2" solve "$3/incline_slide/incline_slide.talus" --out slide.results > /dev/null || [ $? = 1 ]
"$2" export slide.results --as csv --out csv > /dev/null
"$2" export slide.results --as vtu --out vtu > /dev/null
"$2" render slide.results --field displacement --size 400x300 --out slide.png > /dev/null
rm slide.results/*.h5 slide.results/summary.json slide.results/steps.csv csv/steps.csv  # have seconds of the clock
WORK
mkdir "$folder/point" "$folder/comma"
LC_ALL=C.UTF-8 bash "$folder/work.sh" "$folder/point" "$cli" "$samples"
"$in_german" bash "$folder/work.sh" "$folder/comma" "$cli" "$samples"
diff --recursive --brief "$folder/point" "$folder/comma"
