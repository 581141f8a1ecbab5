#!/bin/sh
# Draws the pictures of the window in docs/manual.md, without a display: docs/pictures/page_*.png.
#
#     tools/draw_manual_pictures.sh [TALUS]
#
# TALUS is the program, build/release/app/talus where it is not said. A picture is rewritten whenever the window has
# changed; look at each before it is committed.
set -e
cd "$(dirname "$0")/.."
talus=$(realpath "${1:-build/release/app/talus}")
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
export QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1
export HOME=$folder XDG_CONFIG_HOME=$folder XDG_RUNTIME_DIR=$folder XDG_STATE_HOME=$folder  # nobody's own settings
cp -r samples "$folder/samples"

# A block on a bench that is loaded, held, watched and let go: what no sample has all of.
cat > "$folder/bench.talus" <<'PROJECT'
{
  "talus": 1, "name": "Loaded bench",
  "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
  "joints": {"J1": {"friction_angle": 35, "cohesion": 50e3}},
  "default_joint": "J1",
  "solids": [
    {"name": "bench", "box": {"min": [0, 0, 0], "max": [12, 10, 4]}, "material": "rock", "body": "fixed", "mesh_size": 2},
    {"name": "block", "box": {"min": [1, 2, 4], "max": [6, 8, 8]}, "material": "rock", "mesh_size": 1.5}],
  "loads": [
    {"block": "block", "at": [3.5, 5, 8], "table": [[0, 0, 0, 0], [1, 0, 0, -400e3], [3, 250e3, 0, -400e3], [4, 250e3, 100e3, -150e3]]},
    {"block": "block", "at": [6, 5, 6], "force": [-180e3, 0, -60e3]}],
  "constraints": [
    {"block": "block", "at": [1, 2, 4], "displacement": [0, 0, 0]},
    {"block": "block", "at": [1, 8, 4], "displacement": [null, 0, 0]}],
  "stages": [
    {"name": "settle", "type": "static", "time_step": 0.01, "duration": 2, "until_equilibrium": true},
    {"name": "load", "type": "dynamic", "time_step": 0.01, "duration": 4},
    {"name": "soften and let go", "type": "dynamic", "time_step": 0.005, "duration": 5,
     "joints": {"J1": {"friction_angle": 20, "cohesion": 0}}, "constraints": []}],
  "monitors": [{"name": "crest", "block": "block", "at": [6, 2, 8]}, {"name": "heel", "block": "block", "at": [1, 5, 8]}]
}
PROJECT

draw() {  # PICTURE PROJECT PAGE [OPTION...]
  picture=$1 project=$2 page=$3
  shift 3
  "$talus" --screenshot "docs/pictures/page_$picture.png" --language en --theme light --size 1024x660 \
    --page "$page" "$@" "$project"
}

sample() { echo "$folder/samples/$1/$1.talus"; }

draw geometry "$(sample step_slope)" geometry --select /solids/0
draw joints "$(sample wedge)" joints --select /joints/J1
draw blocks "$(sample step_slope)" blocks
draw mesh "$(sample arch)" mesh
draw materials "$folder/bench.talus" materials --select /materials/rock
draw loads "$folder/bench.talus" loads --select /loads/0
draw stages "$folder/bench.talus" stages --select /stages/2
