#!/usr/bin/env bash
# Draws the pictures of the documents: the cover of every lesson, small, in both themes, one larger picture, and a
# chart of work against error.
#   bash lessons/images.sh PROGRAMS SCRATCH IMAGES
set -eu
programs=$1
scratch=$2
images=$3

# cover PROGRAM SIZE THEME NAME: draws one cover and puts it into the folder of images.
cover() {
  local out=$scratch/$4 code=0
  mkdir -p "$out"
  "$1" --frames cover --size "$2" --theme "$3" -o "$out" -q -v >"$out/log" 2>&1 || code=$?
  if [[ $code == 77 ]]; then return 0; fi
  if [[ $code != 0 ]]; then
    cat "$out/log" >&2
    printf '%s failed with code %s\n' "$(basename "$1")" "$code" >&2
    return 1
  fi
  cp "$out"/l[0-9][0-9]_0001.png "$images/$4.png"
}

mkdir -p "$images"
for theme in light dark; do
  for program in "$programs"/lesson[0-9][0-9]_*; do
    [[ -x $program && -f $program ]] || continue
    name=$(basename "$program")
    cover "$program" small "$theme" "${name#lesson}_$theme"
    if [[ $name == lesson17_* ]]; then cover "$program" medium "$theme" "cairn_$theme"; fi
  done
  if [[ -x $programs/cairn ]]; then
    "$programs/cairn" tradeoff stack10 --quick --theme "$theme" --out "$scratch/tradeoff_$theme" --quiet >/dev/null
    cp "$scratch/tradeoff_$theme/stack10.png" "$images/tradeoff_$theme.png"
  fi
done
