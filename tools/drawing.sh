# What tools that draw pictures begin with; they source it, with their own arguments, where tools/ lies.
# `build`: the folder with the programs, that of the first argument or build/release. `folder`: one that goes away.
build=$(realpath "${1:-build/release}")
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
export QT_QPA_PLATFORM=offscreen OPENBLAS_NUM_THREADS=1
export HOME=$folder XDG_CONFIG_HOME=$folder XDG_RUNTIME_DIR=$folder XDG_STATE_HOME=$folder  # nobody's own settings
