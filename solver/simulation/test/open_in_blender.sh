#!/bin/sh
# Opens a run's surface.glb in Blender: open_in_blender.sh FOLDER. Exit 77: Blender, or the NumPy that its glTF importer wants, is not installed.
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd) || exit 1
command -v blender >/dev/null || { echo "skipped: no blender (Debian package blender)"; exit 77; }
said=$(blender -b --factory-startup -noaudio -P "$here/open_in_blender.py" -- "$1" 2>&1)
case $said in
  *"No module named 'numpy'"*) echo "skipped: Blender finds no NumPy (Debian package python3-numpy)"; exit 77 ;;
  *"Blender reads"*) echo "$said" | grep "Blender reads"; exit 0 ;;
  *) echo "$said" | tail -n 20; exit 1 ;;
esac
