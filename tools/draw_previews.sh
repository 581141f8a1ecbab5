#!/bin/sh
# Draws the pictures of templates and samples that the start page shows, light and dark, without a display:
# resources/templates/*.png and samples/*/preview.png, preview-dark.png.
#
#     tools/draw_previews.sh [BUILD]
#
# BUILD is the folder with the programs, build/release where it is not said. Each sample is solved first, the rockslide
# too: it takes some minutes. Look at each picture before it is committed.
set -e
cd "$(dirname "$0")/.."
. tools/drawing.sh

TALUS_PICTURES=$PWD/resources/templates "$build/tests/gui/test_gui" --gtest_also_run_disabled_tests \
  --gtest_filter='*DrawsTheTemplates'

draw() {  # SAMPLE, then what to show of its results
  sample=$1 && shift
  cp -r "samples/$sample" "$folder"
  "$build/app/talus-cli" solve "$folder/$sample/$sample.talus" --out "$folder/$sample.results" > "$folder/$sample.txt"
  for theme in light dark; do
    [ $theme = dark ] && ending=-dark || ending=
    "$build/app/talus-cli" render "$folder/$sample.results" --size 1200x750 --theme $theme "$@" \
      --out "samples/$sample/preview$ending.png"
  done
  tools/few_colours.py "samples/$sample/preview.png" "samples/$sample/preview-dark.png"
}
draw arch --time 30 --view 195,12
draw block_ladder --time 0.6
draw cantilever --time 30 --field stress.xx --scale 150 --view 195,12
draw free_fall --time 0.5 --edges mesh
draw incline_slide --time 0.6 --field velocity
draw incline_stay --time 10.1 --field stress.zz --edges mesh
draw jiweishan --time 59
draw jointed_bench --time 3.6
draw spinning_block --time 0.1 --field velocity --edges mesh
draw step_slope --time 6
draw wedge --time 0.14 --view 60,40
