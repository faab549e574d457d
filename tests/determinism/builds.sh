#!/usr/bin/env bash
# Builds cairn_hashes with every compiler there is, with and without optimisation, and compares what they
# print. The last lines say which builds were compared, and "N passed, N failed"; a build is compared with
# tests/determinism/hashes.txt.
#   bash tests/determinism/builds.sh                      all of them
#   bash tests/determinism/builds.sh g++:-O3 clang++:-O2  these alone
unset CDPATH
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
out=$root/build/determinism
mkdir -p "$out"
passed=0
failed=0
expected=$out/expected.txt
compared=()
builds=("$@")
if [[ $# == 0 ]]; then builds=(g++:-O0 g++:-O2 g++:-O3 clang++:-O0 clang++:-O2); fi
grep -v '^#' "$root/tests/determinism/hashes.txt" >"$expected"
for build in "${builds[@]}"; do
  compiler=${build%%:*}
  level=${build##*:}
  if ! command -v "$compiler" >/dev/null; then printf '%-12s is not there\n' "$compiler"; continue; fi
  folder=$out/$compiler$level
  printed=$out/$compiler$level.txt
  if ! { cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Plain -DCMAKE_CXX_COMPILER="$compiler" \
           -DCMAKE_CXX_FLAGS="$level" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON &&
         cmake --build "$folder" --target cairn_hashes; } >"$folder.log" 2>&1; then
    printf '%-12s %s does not build: %s\n' "$compiler" "$level" "$folder.log"
    failed=$((failed + 1))
    continue
  fi
  "$folder/bin/cairn_hashes" >"$printed"
  compared+=("$compiler $level")
  if cmp -s "$printed" "$expected"; then
    printf '%-12s %s gives the same bits in %d runs\n' "$compiler" "$level" "$(wc -l <"$printed")"
    passed=$((passed + 1))
  else
    printf '%-12s %s gives other bits:\n' "$compiler" "$level"
    diff "$expected" "$printed" | grep '^>' | head -n 20
    failed=$((failed + 1))
  fi
done
printf 'compared with tests/determinism/hashes.txt:'
printf ' %s;' "${compared[@]}"
printf '\n%d passed, %d failed\n' "$passed" "$failed"
[[ $failed == 0 && $passed != 0 ]]
