#!/bin/sh
# Draws every page, form, dialog and menu of the window, light and dark, in three sizes, and sheets of them, without a
# display: to be looked at before a release.
#
#     tools/draw_every_place.sh FOLDER [TEST_GUI]
#
# TEST_GUI is the program of the window's tests, build/release/tests/gui/test_gui where it is not said.
set -e
folder=$(realpath -m "$1")
cd "$(dirname "$0")/.."
test_gui=$(realpath "${2:-build/release/tests/gui/test_gui}")
mkdir -p "$folder"
# Menus and dialogs keep to the screen, which is 800 x 800 pixels where nothing is said.
echo '{"screens": [{"name": "screen", "x": 0, "y": 0, "width": 2560, "height": 1440, "logicalDpi": 96,
  "logicalBaseDpi": 96, "dpr": 1}]}' > "$folder/screen.json"
export QT_QPA_PLATFORM="offscreen:configfile=$folder/screen.json" OPENBLAS_NUM_THREADS=1

draw() {  # NAME SIZE SCALE THEME
  mkdir -p "$folder/$1"
  TALUS_PICTURES="$folder/$1" TALUS_SIZE=$2 QT_SCALE_FACTOR=$3 TALUS_THEME=$4 "$test_gui" \
    --gtest_also_run_disabled_tests --gtest_filter=EveryPlace.DISABLED_DrawsPictures
}

for theme in light dark; do
  draw "1280x720-$theme" 1280x720 1 $theme
  draw "1600x1000-$theme" 1600x1000 1 $theme
  draw "2560x1440-$theme" 1280x720 2 $theme
done
