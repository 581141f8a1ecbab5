#!/usr/bin/env bash
# Makes an installed tree run where none of its libraries are installed: copies what its programs, the mesher, Qt's
# plug-ins and OSMesa load into TREE/lib/talus, and has them look there first. Left to the machine is what belongs to its
# kernel, C library (at least the one of this machine) and graphics card. Needs patchelf and binutils.
# Usage: tools/bundle_libraries.sh TREE
set -euo pipefail
tree=$1 libraries=$1/lib/talus multiarch=/usr/lib/x86_64-linux-gnu
plugins=(platforms/libqxcb platforms/libqoffscreen xcbglintegrations/libqxcb-glx-integration
  xcbglintegrations/libqxcb-egl-integration imageformats/libqsvg imageformats/libqjpeg iconengines/libqsvgicon
  platforminputcontexts/libcomposeplatforminputcontextplugin)
left='^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|nsl|anl|stdc\+\+|gcc_s|nss_.*))\.so'
mkdir -p "$libraries"

# own_rpath FILE…  They look in lib/talus first, whatever loads them: the older tag holds for what they load, too.
own_rpath() {
  local file
  for file in "$@"; do
    patchelf --force-rpath --set-rpath "\$ORIGIN/$(realpath --relative-to="$(dirname "$file")" "$libraries")" "$file"
  done
}

if [[ -x $tree/bin/talus ]]; then
  for plugin in "${plugins[@]}"; do
    [[ -f $multiarch/qt6/plugins/$plugin.so ]] || continue
    install -D "$multiarch/qt6/plugins/$plugin.so" "$libraries/plugins/$plugin.so"
  done
  printf '[Paths]\nPrefix = ..\nPlugins = lib/talus/plugins\n' >"$tree/bin/qt.conf"
fi
cp --dereference "$multiarch/libOSMesa.so.8" "$libraries"
mapfile -t programs < <(find "$tree/bin" "$tree/libexec" "$libraries" -type f -exec sh -c 'file -b "$1" | grep -q ^ELF' _ {} \; -print)
ldd "${programs[@]}" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u | while read -r library; do
  name=$(basename "$library")
  [[ $name =~ $left || -e $libraries/$name ]] || cp --dereference "$library" "$libraries/$name"
done
chmod u+w,a+r "$libraries"/*.so*
strip --strip-unneeded "$libraries"/*.so* 2>/dev/null || true
own_rpath "${programs[@]}" "$libraries"/*.so*
du -sh "$libraries"
