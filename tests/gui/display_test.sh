#!/bin/sh
# `talus` on an X server, where the driver draws the view and not OSMesa: it opens, draws and ends in peace.
talus=$1 samples=$2 xvfb=$3 tests=$4
folder=$(mktemp -d) && trap 'kill "$server" 2> /dev/null; rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; exit 1; }
export HOME=$folder XDG_CONFIG_HOME=$folder XDG_RUNTIME_DIR=$folder
cp -r "$samples/free_fall" "$folder"

"$xvfb" -displayfd 3 -screen 0 1600x1000x24 3> "$folder/display" 2> /dev/null &
server=$!
for _ in $(seq 100); do [ -s "$folder/display" ] && break; sleep 0.1; done
[ -s "$folder/display" ] || fail "the X server did not start"
DISPLAY=:$(cat "$folder/display"); export DISPLAY

"$talus" --screenshot "$folder/blocks.png" --size 1280x720 --page blocks "$folder/free_fall/free_fall.talus" ||
  fail "no picture, or it did not end in peace: exit code $?"
[ -s "$folder/blocks.png" ] || fail "no picture was written"
"$tests" --gtest_brief=1 --gtest_filter='OnADisplay.*' || fail "the view is not seen as it is drawn"
