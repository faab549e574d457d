#!/usr/bin/env bash
# Runs the stability atlas from its beginning, some minutes, and puts the maps that documents show into the folder
# of images.
#   bash lessons/atlas.sh PROGRAMS SCRATCH IMAGES
set -eu
programs=$1
scratch=$2
images=$3

"$programs/cairn" extremes --atlas "$scratch" --again --theme light
"$programs/cairn" extremes --atlas "$scratch" --theme dark --quiet >/dev/null  # drawn from the journal
for theme in light dark; do
  for map in mass-ratio chain springs; do cp "$scratch/atlas_${map}_$theme.png" "$images/"; done
done
