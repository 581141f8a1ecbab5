#!/bin/sh
# Makes the pictures that are drawn now the baselines of those that differ from theirs (tests/images/baselines):
#
#     tools/update_baselines.sh [BUILD [FILTER]]
#
# BUILD is the folder with the programs, build/release where it is not said; FILTER takes some of the tests, in
# GoogleTest's way: "*Field*". Without one, baselines that no picture has asked for are named. Look at what git shows as
# changed before it is committed.
set -e
cd "$(dirname "$0")/.."
. tools/drawing.sh
filter=${2:-*Image*:*Picture*}
start=$folder/start && touch "$start"
root=$PWD
cd "$folder"
for program in images/test_images gui/test_gui; do
  TALUS_UPDATE_BASELINES=1 "$build/tests/$program" --gtest_brief=1 --gtest_filter="$filter"
done
cd "$root"
git status --short tests/images/baselines
[ -n "$2" ] || find tests/images/baselines -name '*.png' ! -newer "$start" -exec echo 'asked for by no test: {}' \;
