#!/usr/bin/env bash
# Draws the pictures of the documents: the cover of every lesson, small, in both themes, one larger picture, a chart of
# work against error, one of sweeps, the map of settings, the failures of sandbox/FAILURES.md, and the films of the
# playground and of six scenes at three prices.
#   bash lessons/images.sh PROGRAMS SCRATCH IMAGES
set -eu
programs=$1
scratch=$2
images=$3
rm -rf "$scratch"  # what was begun by another build is not gone on with

# cover PROGRAM SIZE THEME NAME [FRAME]: draws one cover, or that frame, and puts it into the folder of images.
cover() {
  local out=$scratch/$4 code=0
  mkdir -p "$out"
  "$1" --frames "${5:-cover}" --size "$2" --theme "$3" -o "$out" -q -v >"$out/log" 2>&1 || code=$?
  if [[ $code == 77 ]]; then return 0; fi
  if [[ $code != 0 ]]; then
    cat "$out/log" >&2
    printf '%s failed with code %s\n' "$(basename "$1")" "$code" >&2
    return 1
  fi
  cp "$out"/l[0-9][0-9]_*.png "$images/$4.png"
}

# failure NAME FRAME WORDS...: one frame of the film that `cairn WORDS` writes.
failure() {
  local name=$1_$theme frame=$2 code=0
  shift 2
  "$programs/cairn" "$@" --size 640x360 --theme "$theme" --frames "$scratch/$name" --quiet >/dev/null || code=$?
  # 1 and 4 say that an expectation was missed, or that it diverged: that is what is shown.
  if [[ $code != 0 && $code != 1 && $code != 4 ]]; then return "$code"; fi
  cp "$scratch/$name/$frame.png" "$images/$name.png"
}

failures() {
  local scenes
  scenes=$(dirname "$0")/sandbox/failures
  failure failure_few_sweeps 0002 compare stack-ratio --solvers si:10,accelerated:50 --substeps 1 --stabilization baumgarte --fps 2 --seconds 1
  failure failure_stretch 0002 compare chain-bob --solvers si:10,si:300 --substeps 2 --stabilization baumgarte --fps 1 --seconds 2
  failure failure_pop 0001 run "$scenes/overlap.toml" --stabilization baumgarte --fps 20 --seconds 0.05
  failure failure_pop_cured 0001 run "$scenes/overlap.toml" --fps 5 --seconds 0.2
  failure failure_pin 0001 compare "$scenes/tiny-inertia.toml" --solvers si:10,block:10 --stabilization baumgarte --fps 2 --seconds 1 --show trails
  failure failure_far 0002 run "$scenes/far-away.toml" --scalar float --fps 1 --show velocities
  failure failure_jacobi 0001 compare weld-beam --solvers jacobi:30,si:30 --substeps 1 --stabilization baumgarte --fps 60 --seconds 0.1
  failure failure_cycle 0003 compare painleve --solvers si:20,block-contact:20 --substeps 1 --fps 10 --seconds 0.3 --show velocities
  failure failure_rods 0024 compare "$scenes/shaking-rods.toml" --solvers si:10,newton:10 --fps 10 --seconds 2.4
  failure failure_tower 0010 run "$scenes/tower-on-springs.toml" --fps 2
  failure failure_stiffness 0002 compare "$scenes/level-chain.toml" --solvers si:10,newton:20 --fps 1 --seconds 2
  failure failure_stiffness_cured 0002 compare "$scenes/level-chain.toml" --solvers si:10,newton:20 --stabilization relaxed --fps 1 --seconds 2
  failure failure_slot 0004 run "$scenes/slot.toml" --stabilization baumgarte --fps 1 --seconds 4 --show loads
}

mkdir -p "$images" "$scratch"
gzip -dc "$(dirname "${BASH_SOURCE[0]}")/sandbox/map.csv.gz" >"$scratch/level3.csv"
for theme in light dark; do
  for program in "$programs"/lesson[0-9][0-9]_*; do
    [[ -x $program && -f $program ]] || continue
    name=$(basename "$program")
    cover "$program" small "$theme" "${name#lesson}_$theme"
    if [[ $name == lesson17_* ]]; then cover "$program" medium "$theme" "cairn_$theme" 51; fi
  done
  if [[ -x $programs/cairn ]]; then
    "$programs/cairn" tradeoff stack10 --quick --theme "$theme" --out "$scratch/tradeoff_$theme" --quiet >/dev/null
    cp "$scratch/tradeoff_$theme/stack10.png" "$images/tradeoff_$theme.png"
    "$programs/cairn" tradeoff bridge chain pyramid "$(dirname "${BASH_SOURCE[0]}")/../tests/study/cases/net.toml" \
      --theme "$theme" --out "$scratch/sweeps_$theme" --quiet >/dev/null
    cp "$scratch/sweeps_$theme/sweeps.png" "$images/sweeps_$theme.png"
    "$programs/cairn" tradeoff --all --level 3 --table "$scratch/level3.csv" --theme "$theme" --out "$scratch/map_$theme" \
      --quiet >/dev/null
    cp "$scratch/map_$theme/map.png" "$images/map_$theme.png"
    failures
  fi
  if [[ -x $programs/cairn_price_film ]]; then
    sandbox=$(dirname "${BASH_SOURCE[0]}")/sandbox
    "$programs/cairn_price_film" "$theme" "$images/prices_$theme.png" "$sandbox/choosing" "$sandbox/prices/times.json"
  fi
  if [[ -x $programs/cairn_playground_film ]]; then
    "$programs/cairn_playground_film" "$theme" "$images/playground_$theme.png"
  fi
done
