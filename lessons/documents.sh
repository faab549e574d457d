#!/usr/bin/env bash
# Writes what commands print, and what source files say, into the documents that show it.
#   bash lessons/documents.sh PROGRAMS SOURCE [DESTINATION]
# A document says so by a line "<!-- output of: COMMAND -->", or "<!-- output of: COMMAND (not compared) -->" where times
# are in it or the command is slow; what stands in the ``` block behind that line is replaced. DESTINATION: another root for what is written;
# blocks that are not compared are then left as they are.
set -eu
unset CDPATH
programs=$(cd "$1" && pwd)
source=$(cd "$2" && pwd)
destination=${3:-$source}
mkdir -p "$destination"
destination=$(cd "$destination" && pwd)
unset COLUMNS
export PATH=$programs:$PATH NO_COLOR=1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
# Where commands find scenes that have no name of their own, and what the benchmarks printed.
ln -s "$source/lessons" "$source/tests" .

fail() {
  printf '%s\n' "$1" >&2
  exit 1
}

# quoted FILE NAME: prints the region or the function, moved to the left margin; fails where there is neither.
quoted() {
  awk -v name="$2" '
    { line = $0; sub(/^ +/, "", line) }
    line == "// [/" name "]" { exit }
    is_region && line ~ /^\/\/ \[\/?[a-z_-]+\]$/ { next }  # of a region inside
    is_region { text = text substr($0, margin + 1) "\n" }
    line == "// [" name "]" { is_region = 1; margin = index($0, "/") - 1 }
    END { if (text == "") exit 1; printf "%s", text }' "$1" && return
  awk -v name="$2" '
    !is_inside && /^[A-Za-z]/ && !/;$/ && $0 ~ "[ :*&]" name "[(]" { is_inside = 1 }
    is_inside { print }
    is_inside && /^}/ { found = 1; exit }
    END { exit !found }' "$1"
}

# renewed DOCUMENT: prints it with its blocks made anew.
renewed() {
  local line command inside=0 replacing=0
  while IFS= read -r line || [[ -n $line ]]; do
    if [[ $replacing == 2 ]]; then
      if [[ $line == '```' ]]; then replacing=0; fi
      continue
    fi
    printf '%s\n' "$line"
    if [[ $line == '<!-- output of: '*' -->' && $inside == 0 ]]; then
      command=${line#<!-- output of: }
      command=${command% -->}
      if [[ $command == *' (not compared)' ]]; then
        command=${command% (not compared)}
        if [[ $destination != "$source" ]]; then continue; fi
      fi
      replacing=1
    elif [[ $line == '<!-- source: '*' '*' -->' && $inside == 0 ]]; then
      command=${line#<!-- source: }
      command="quoted ${command% -->}"
      replacing=1
    elif [[ $line == '```'* ]]; then
      if [[ $replacing == 1 ]]; then
        if [[ $command == 'quoted '* ]]; then
          quoted "$(dirname "$1")/$(cut -d ' ' -f 2 <<<"$command")" "${command##* }" || fail "$1: there is no ${command#quoted }"
        else
          bash -c "$command" </dev/null 2>&1 || true
        fi
        printf '```\n'
        replacing=2
      else
        inside=$((1 - inside))
      fi
    fi
  done <"$1"
}

grep -rlE '^<!-- (output of|source): ' --include='*.md' "$source/README.md" "$source/src" "$source/lessons" | sort | while IFS= read -r document; do
  target=$destination/${document#"$source"/}
  mkdir -p "$(dirname "$target")"
  renewed "$document" >"$target.new"
  mv "$target.new" "$target"
done
if [[ $destination == "$source" ]]; then
  cairn_price_film times "$source/lessons/sandbox/prices/times.json" "$source/lessons/sandbox/choosing"
fi
mkdir -p "$destination/src/validation"
cairn validate --page "$destination/src/validation/RESULTS.md" --quiet >/dev/null
