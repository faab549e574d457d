#!/usr/bin/env bash
# A solver of the reader's own, in ten stages: what `bash lessons/run solver` does. The reader's file is kept where the
# command runs, as lessons-progress.txt is.
#   run.sh            how far the file has come, and what is next
#   run.sh N          grades the stages 0 to N; exit code 0: passed, 1: not yet, 2: bad usage
#   run.sh N --begin  writes the state before stage N; a file that is there is kept under another name
unset CDPATH
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
file=my_solver.cpp
last=9

refuse() {
  printf 'solver: %s\n' "$1" >&2
  exit 2
}

# The compiler of the lessons, where they were built.
cache=$here/../../build/release/CMakeCache.txt
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$cache" 2>/dev/null)
compiler=${compiler:-c++}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

task() { cat "$here/stages/0$1.txt"; }

# grade N: exit code 0: passed, 1: not yet, 3: it does not compile; others: as the program ended.
grade() {
  local -a flags=(-std=c++20 -O0 -D_GLIBCXX_ASSERTIONS -Werror=return-type -fdiagnostics-color=never)
  printf '#include "report.hpp"\n#include "stages/0%s.cpp"\nint main() {\n  grading::Report report(%s);\n' "$1" "$1" >"$work/main.cpp"
  printf '  stage_0%s(report);\n  return report.passed() ? 0 : 1;\n}\n' "$1" >>"$work/main.cpp"
  LC_ALL=C "$compiler" "${flags[@]}" -I"$here" -include "./$file" -o "$work/grader" "$work/main.cpp" 2>"$work/errors" || return 3
  timeout 10 "$work/grader" 2>"$work/errors"
}

# The first error in the reader's file with its line, or else what a stage could not call.
explain_errors() {
  local error line stage
  error=$(grep -E "(^|[ /])$file:[0-9]+:([0-9]+:)? (fatal )?error: " "$work/errors" | head -n 1)
  if [[ $error ]]; then
    line=$(sed -E "s/.*$file:([0-9]+):.*/\1/" <<<"${error%%error: *}")
    printf '%s does not compile. Line %s: %s\n  %s\n' "$file" "$line" "${error#*error: }" "$(sed -n "${line}p" "$file")"
    return
  fi
  error=$(grep -E ': (fatal )?error: ' "$work/errors" | head -n 1)
  stage=$(sed -nE 's,.*stages/0([0-9])\.cpp.*,\1,p' "$work/errors" | head -n 1)
  line=$(grep -oE "$file:[0-9]+" "$work/errors" | head -n 1)
  printf 'Stage 0%s cannot use %s: %s\n' "${stage:-$1}" "${line:-$file}" "${error#*error: }"
  printf 'It needs:\n'
  task "${stage:-$1}" | grep '^    '
}

# explain_end CODE: why the reader's program ended early.
explain_end() {
  if [[ $1 == 124 ]]; then
    printf '%s did not end within 10 s: does one of its loops never stop?\n' "$file"
  elif grep -q "Assertion '__n < " "$work/errors"; then
    printf '%s used an index outside of a list, and was stopped after the last line above.\n' "$file"
  else
    printf '%s was stopped after the last line above (exit code %s).\n' "$file" "$1"
  fi
}

grade_aloud() {
  local code
  task "$1" | head -n 1
  grade "$1"
  code=$?
  case $code in
    0)
      if [[ $1 == "$last" ]]; then
        printf 'Passed. Your solver is complete: %s lines, and its tower carries what the three of lesson 17 carry.\n' "$(wc -l <"$file")"
      else
        printf 'Passed. Next: bash lessons/run solver %s\n' $(($1 + 1))
      fi
      return 0 ;;
    1) ;;
    3) explain_errors "$1" ;;
    *) explain_end "$code" ;;
  esac
  printf 'Not yet. The task: lessons/your_solver/stages/0%s.txt\n' "$1"
  return 1
}

# The state before stage N: the model of the stage before, and the task as a comment.
start_state() {
  bash "$here/state.sh" $(($1 - 1))
  if [[ $1 -gt 0 ]]; then printf '\n'; fi
  task "$1" | sed -e 's,^,// ,' -e 's, *$,,'
}

begin() {
  local number=1
  if [[ -e $file ]]; then
    while [[ -e my_solver.$number.cpp ]]; do number=$((number + 1)); done
    mv "$file" "my_solver.$number.cpp" || exit 2
    printf 'Your file is kept as my_solver.%s.cpp.\n' "$number"
  fi
  start_state "$1" >"$file" || refuse "cannot write $PWD/$file"
  printf '%s is now the state before stage 0%s. Its last lines say what to write; then: bash lessons/run solver %s\n' \
    "$PWD/$file" "$1" "$1"
}

# Whoever passes a stage passes those before it: half as many stages are left after each try.
say_where() {
  local low=-1 high=$((last + 1)) middle
  if [[ ! -f $file ]]; then
    printf 'There is no %s in %s yet: bash lessons/run solver 0 --begin\n\n' "$file" "$PWD"
    task 0
    return
  fi
  while [[ $((high - low)) -gt 1 ]]; do
    middle=$(((low + high) / 2))
    if grade "$middle" >/dev/null; then low=$middle; else high=$middle; fi
  done
  printf '%s: %s of %s stages pass.\n' "$PWD/$file" "$high" $((last + 1))
  if [[ $high -gt $last ]]; then return; fi
  printf '\n'
  task "$high"
  printf '\nThen: bash lessons/run solver %s\n' "$high"
}

if [[ $# == 0 ]]; then say_where; exit; fi
if ! [[ $1 =~ ^0?[0-9]$ ]]; then refuse "the stage must be a number from 0 to $last, got \"$1\""; fi
stage=$((10#$1))
if [[ ${2:-} == --begin && $# == 2 ]]; then begin "$stage"; exit; fi
if [[ $# -gt 1 ]]; then refuse "after the stage there may be --begin, got \"${*:2}\""; fi
if [[ ! -f $file ]]; then
  refuse "there is no $file in $PWD; bash lessons/run solver $stage --begin writes the state before stage $stage"
fi
grade_aloud "$stage"
