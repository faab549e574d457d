#!/usr/bin/env bash
# Runs the map of settings, some minutes for each part at once, and keeps its table for the documents.
#   bash lessons/map.sh PROGRAMS SCRATCH TABLE [PARTS]
set -eu
program=$1/cairn
scratch=$2
table=$3
parts=${4:-$(nproc)}
words=(tradeoff --all --level 3 --progress never --quiet)

mkdir -p "$scratch"
waiting=()
for ((k = 1; k <= parts; ++k)); do
  "$program" "${words[@]}" --shard "$k/$parts" --out "$scratch" &
  waiting+=($!)
done
for part in "${waiting[@]}"; do wait "$part"; done
if [[ $parts != 1 ]]; then
  journals=$(find "$scratch" -name "level3.*-of-$parts.journal" | sort | paste -sd,)
  "$program" "${words[@]}" --merge "$journals" --out "$scratch"
fi
gzip -n9 <"$scratch/level3.csv" >"$table.new"
mv "$table.new" "$table"
