#!/bin/sh
# `talus --screenshot`: a picture of the window with no display, and exit code 2 for what the user can mend.
talus=$1 samples=$2
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; exit 1; }
export HOME=$folder XDG_CONFIG_HOME=$folder XDG_RUNTIME_DIR=$folder  # Qt warns without the last one
cp -r "$samples/free_fall" "$folder"

"$talus" --screenshot "$folder/dark.png" --size 1280x720 --theme dark --page mesh "$folder/free_fall/free_fall.talus" ||
  fail "no picture of the sample"
# Bytes 16 to 24 of a PNG are its width and height.
[ "$(od -An -tu1 -j16 -N8 "$folder/dark.png" | tr -s ' ')" = " 0 0 5 0 0 0 2 208" ] || fail "the picture is not 1280 x 720"
"$talus" --screenshot "$folder/start.png" || fail "no picture of the start page"
"$talus" --screenshot "$folder/new.png" --new column || fail "no picture of a new project"

words() { env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM "$talus" "$1" > "$folder/words" && grep -q "$2" "$folder/words"; }
words --version '^talus [0-9]' || fail "no version without a display"
words --help '^Usage: ' || fail "no help without a display"

env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM "$talus" 2> "$folder/words" && fail "a window without a display"
[ $? = 2 ] && grep -q '^talus: there is no display' "$folder/words" || fail "that there is no display is not told"

expect_2() { "$talus" "$@" 2> "$folder/words"; [ $? = 2 ] || fail "not exit code 2: $*"; [ "$(wc -l < "$folder/words")" = 1 ] || fail "not one line: $*"; }
expect_2 --screenshot "$folder/x.png" "$folder/not_there.talus"
expect_2 --screenshot "$folder/x.png" --size 12 "$folder/free_fall/free_fall.talus"
expect_2 --screenshot "$folder/x.png" --theme blue "$folder/free_fall/free_fall.talus"
expect_2 --screenshot "$folder/x.png" --new dance
expect_2 --screenshot "$folder/x.png" --page dance "$folder/free_fall/free_fall.talus"
expect_2 --screenshot "$folder/x.png" --step dance "$folder/free_fall/free_fall.talus"  # what --page was called before
expect_2 --screenshot "$folder/none/x.png" "$folder/free_fall/free_fall.talus"
[ ! -e "$folder/x.png" ] || fail "a picture was left behind"
