#!/usr/bin/env bash
# Runs the advice of CHOOSING.md: both scenes of each row of its table, with the row's flags and without any.
#   bash lessons/sandbox/advice.sh         what is left, and the counted work beside the default's
#   bash lessons/sandbox/advice.sh times   the processor time of a step [ms] where the advice is not the default
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# numbers SCENE FLAGS...: row updates, ms a step, deepest overlap and widest gap [mm], and whether it does what it should.
numbers() {
  local verdict=holds json
  json=$(cairn run "$@" --json --quiet 2>/dev/null) || verdict=misses
  awk -v verdict="$verdict" '
    { gsub(/[",]/, "") }
    $1 == "row_updates:" { updates = $2 }
    $1 == "step_ms:" { ms = $2 }
    $1 == "penetration_m:" { overlap = $2 }
    $1 == "drift_m_or_rad:" { gap = $2 }
    END { printf "%d %.3g %.2g %.2g %s\n", updates, ms, 1000 * overlap, 1000 * gap, verdict }' <<<"$json"
}

# The rows: kind, scenes as (PATH) behind their names, flags between ` or "by default".
rows() { grep -E '^\| .*\.toml\).*\|$' "$here/CHOOSING.md"; }

small() { awk -v n="$1" 'BEGIN { printf "%s", n < 0.01 ? "0" : n }'; }

if [[ ${1:-} == times ]]; then
  printf '%-24s %-46s %8s %8s\n' 'ms a step' '' default advice
else
  printf '%-22s %-44s %6s %24s   %s\n' '' '' 'work' 'it leaves [mm]:' 'the default leaves [mm]:'
  printf '%-22s %-44s %6s %8s %8s %-7s %8s %8s\n' scene flags '/ def.' overlap gap '' overlap gap
fi
rows | while IFS='|' read -r _ _ scenes flags _; do
  flags=$(sed -n 's/^ *`\(.*\)` *$/\1/p' <<<"$flags")
  for scene in $(grep -oE '\([^)]*\.toml\)' <<<"$scenes" | tr -d '()'); do
    read -r usual usual_ms usual_overlap usual_gap usual_verdict < <(numbers "$here/$scene")
    # shellcheck disable=SC2086
    read -r updates ms overlap gap verdict < <(numbers "$here/$scene" $flags)
    name=$(basename "$scene" .toml)
    if [[ ${1:-} == times ]]; then
      if [[ -n $flags ]]; then printf '%-24s %-46s %8s %8s\n' "$name" "$flags" "$usual_ms" "$ms"; fi
    elif [[ -z $flags ]]; then
      printf '%-22s %-44s %6s %8s %8s %s\n' "$name" 'by default' 1 "$(small "$overlap")" "$(small "$gap")" "$verdict"
    else
      printf '%-22s %-44s %6s %8s %8s %-7s %8s %8s %s\n' "$name" "${flags//--/}" \
        "$(awk -v a="$updates" -v b="$usual" 'BEGIN { printf "%.2g", a / b }')" "$(small "$overlap")" "$(small "$gap")" \
        "$verdict" "$(small "$usual_overlap")" "$(small "$usual_gap")" "$usual_verdict"
    fi
  done
done
