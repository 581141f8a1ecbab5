#!/bin/bash
# The window shows and reads the same numbers where the system writes them with a comma, as Qt would have it.
# Usage: decimal_comma_test.sh TALUS TALUS_CLI SAMPLES IN_GERMAN TEST_GUI
set -eu
talus=$1 cli=$2 samples=$3 in_german=$4 tests=$5
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; exit 1; }
export HOME=$folder XDG_CONFIG_HOME=$folder XDG_RUNTIME_DIR=$folder

"$cli" solve "$samples/free_fall/free_fall.talus" --out "$folder/fall.results" > /dev/null
draw() { "$@" "$talus" --language en --page results --field displacement --screenshot "$folder/$1.png" "$folder/fall.results"; }
draw env
"$in_german" true  # or it is skipped
in_german() { "$in_german" "$@"; }
draw in_german
cmp "$folder/env.png" "$folder/in_german.png" || fail "pictures differ"
"$in_german" "$tests" --gtest_brief=1 --gtest_filter='AccuracyPanelTest.ChoosesTheCheapest*' || fail "a study is read otherwise"
