#!/bin/sh
# Draws the pictures of the window in README.md and docs/manual.md, without a display: docs/pictures/window.png and
# page_*.png.
#
#     tools/draw_manual_pictures.sh [BUILD]
#
# BUILD is the folder with the programs, build/release where it is not said. A picture is rewritten whenever the window
# has changed; look at each before it is committed. It takes some minutes: the rockslide of README.md is solved first.
set -e
cd "$(dirname "$0")/.."
. tools/drawing.sh

TALUS_PICTURES=$folder TALUS_SIZE=1280x720 "$build/tests/gui/test_gui" --gtest_also_run_disabled_tests \
  --gtest_filter=EveryPlace.DISABLED_DrawsPictures

take() {  # PICTURE PLACE: of those that tests/gui/every_place.cpp leads to
  cp "$folder/$2.png" "docs/pictures/page_$1.png"
}
take new new-wedge
take geometry geometry-section
take import import-terrain
take joints joints-cut
take stereonet stereonet-mode-1
take blocks blocks-several
take mesh mesh-settings
take materials materials
take loads loads-curve
take stages stages
take solve solve-paused
take results results

cp -r samples/jiweishan "$folder"
pictures=$PWD/docs/pictures
(
  cd "$folder"  # the window says where results were opened from
  "$build/app/talus-cli" solve jiweishan/jiweishan.talus > run.txt
  "$build/app/talus" --screenshot "$pictures/window.png" --language en --theme light --size 1440x900 --page results \
    --field velocity --time 62 jiweishan/jiweishan.results
)
tools/few_colours.py docs/pictures/window.png docs/pictures/page_*.png
