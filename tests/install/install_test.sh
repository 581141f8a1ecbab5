#!/bin/bash
# What `cmake --install` puts into a folder works wherever that folder is moved to: it takes its own mesher, samples and
# schema, and needs no display.
# Usage: install_test.sh CMAKE BUILD_FOLDER
set -eu
cmake=$1 build=$2
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; exit 1; }

"$cmake" --install "$build" --prefix "$folder/first" > "$folder/log" || fail "it cannot be installed"
mkdir "$folder/elsewhere"
mv "$folder/first" "$folder/elsewhere/the program"
place="$folder/elsewhere/the program" samples="$folder/elsewhere/the program/share/talus/samples"
cd "$folder"
cli() { env -i HOME="$folder" PATH=/usr/bin:/bin OPENBLAS_NUM_THREADS=1 "$place/bin/talus-cli" "$@"; }
window() { env -i HOME="$folder" XDG_RUNTIME_DIR="$folder" PATH=/usr/bin:/bin "$@"; }

cli --version | grep -q '^talus-cli [0-9]' || fail "talus-cli --version"
window "$place/bin/talus" --version | grep -q '^talus [0-9]' || fail "talus --version without a display"

# The mesher that was installed leaves a mark; the one of the build folder would not.
mv "$place/libexec/talus/talus-mesher" "$place/libexec/talus/the_real_one"
printf '#!/bin/sh\necho called >> "%s"\nexec "%s" "$@"\n' "$folder/mark" "$place/libexec/talus/the_real_one" \
  > "$place/libexec/talus/talus-mesher"
chmod +x "$place/libexec/talus/talus-mesher"

cli info "$samples/free_fall/free_fall.talus" | grep -q 'Free fall' || fail "info of a sample"
[ -s "$folder/mark" ] || fail "not the mesher that was installed"
cli solve "$samples/free_fall/free_fall.talus" --out fall.results > /dev/null || fail "a sample cannot be solved"
cli render fall.results --out fall.png --size 320x240 > /dev/null || fail "no picture"
[ -s fall.png ] || fail "an empty picture"
cp -r "$samples/free_fall" "$samples/of_this_place"
mv "$samples/of_this_place/free_fall.talus" "$samples/of_this_place/of_this_place.talus"
cli verify --list | grep -q of_this_place || fail "not the samples that were installed"
window QT_QPA_PLATFORM=offscreen "$place/bin/talus" --screenshot start.png || fail "the window does not open"

# A grid of heights is read by the module beside the mesher.
cat > grid.talus << 'PROJECT'
{ "talus": 1, "name": "grid", "materials": {"rock": {"density": 2600, "young": 1e10, "poisson": 0.2}},
  "solids": [ {"name": "ground", "material": "rock", "terrain": {"file": "grid.asc", "base": -5}} ] }
PROJECT
printf 'ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n1 2\n' > grid.asc
cli inspect grid.talus | grep -q ground || fail "no grid of heights is read"

find "$place" -name '*.results' | grep -q . && fail "results beside samples were installed"
python3 -m json.tool "$place/share/talus/schema/project.schema.json" > /dev/null || fail "the schema"
for page in talus talus-cli; do
  [ ! -e "$build/man/$page.1.gz" ] || zgrep -q "^.SH SYNOPSIS" "$place/share/man/man1/$page.1.gz" || fail "man page of $page"
done
grep -q 'threads' "$place/share/bash-completion/completions/talus-cli" || fail "completion for bash"
if command -v desktop-file-validate > /dev/null; then
  desktop-file-validate "$place/share/applications/talus.desktop" || fail "menu entry"
fi
