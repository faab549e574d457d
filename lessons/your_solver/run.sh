#!/usr/bin/env bash
# A solver of the reader's own, in ten stages: what `bash lessons/run solver` does. The reader's file is kept where the
# command runs, as lessons-progress.txt is.
#   run.sh            how far the file has come, and what is next
#   run.sh N          grades the stages 0 to N; exit code 0: passed, 1: not yet, 2: bad usage, 3: it cannot be graded here
#   run.sh N --film   draws what it does at stage N, beside the model: out/solver0N/; --theme dark follows if wanted
#   run.sh N --begin  writes the state before stage N; a file that is there is kept under another name
unset CDPATH
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
file=my_solver.cpp
last=9
memory_pattern='[Oo]ut of memory|memory exhausted|annot allocate memory'

refuse() {
  printf 'solver: %s\n' "$1" >&2
  exit 2
}

# The compiler of the lessons, where they were built.
cache=$here/../../build/release/CMakeCache.txt
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$cache" 2>/dev/null)
compiler=${compiler:-c++}

# cannot WORDS: what is wrong is not the reader's file.
cannot() {
  printf 'solver: %s\n' "$1" >&2
  exit 3
}

make_work_folder() {
  work=$(mktemp -d 2>/dev/null) || cannot "cannot make a folder in ${TMPDIR:-/tmp}${TMPDIR:+, which TMPDIR names}"
  trap 'rm -rf "$work"' EXIT
}

# find_error PATTERN: the first line with it of what the compiler has said.
find_error() { printf '%s\n' "$errors" | grep -E -m 1 "$1"; }

chief_error() { find_error 'No space left' || find_error '[Ee]rror:|annot ' || find_error .; }

# Whether the compiler has failed by what the reader has written.
is_of_the_file() {
  ! find_error 'No space left' >/dev/null && find_error "$file:|(stages|scenes)/0|undefined reference|$memory_pattern" >/dev/null
}

# What runs the compiler and the reader's program under limits. It is made once, and kept in the build folder where that
# can be written.
make_runner() {
  local folder=$here/../reader_code kept=$here/../../build/reader_code/run_reader
  runner=$kept
  if [[ -x $kept && ! $(find "$folder" "$here/../kit/output.hpp" "$here/../../src/math/list.hpp" -newer "$kept") ]]; then return; fi
  runner=$work/run_reader
  printf 'Compiling lessons/reader_code: some seconds, once.\n' >&2
  ln -sfn "$here/../../src" "$work/cairn"  # headers are found as <cairn/math/list.hpp>
  errors=$(LC_ALL=C "$compiler" -std=c++20 -O0 -pipe -I"$here/../.." -I"$work" -o "$runner" "$folder"/*.cpp 2>&1) ||
    cannot "$compiler cannot compile lessons/reader_code: $(chief_error)"
  if mkdir -p "${kept%/*}" 2>/dev/null && cp "$runner" "$kept.$$" 2>/dev/null; then mv "$kept.$$" "$kept"; fi
}

task() { cat "$here/stages/0$1.txt"; }

# compile CODE FILE PROGRAM: a program whose main() is this code behind the file. Exit code 0, 4 if the file does not
# compile, 5 if it does not within the limits of a compiler.
compile() {
  local -a flags=(-std=c++20 -O0 -pipe -D_GLIBCXX_ASSERTIONS -Werror=return-type -fdiagnostics-color=never)
  local code
  # A main() of the reader's is left alone: the linker starts the program elsewhere.
  printf '#include "lessons/reader_code/verdict.hpp"\n%s\n' "$1" 2>/dev/null >"$3.cpp" || cannot "cannot write $3.cpp"
  errors=$(LC_ALL=C "$runner" compiler "$file" "$compiler" "${flags[@]}" -I"$here" -I"$here/../.." -include "$2" \
    -Wl,--wrap=main -o "$3" "$3.cpp" 2>&1)
  code=$?
  if [[ $code == 124 ]]; then return 5; fi
  if [[ $code != 0 ]]; then
    is_of_the_file || cannot "$compiler does not work here: $(chief_error)"
    return 4
  fi
}

# compile_grader N
compile_grader() {
  compile "#include \"lessons/kit/grading.hpp\"
#include \"stages/0$1.cpp\"
extern \"C\" int __wrap_main() {
  return cairn::reader_code::graded([] {
    cairn::Grade grade({.width = 70, .digits = 7, .stage = $1, .only_first = true});
    stage_0$1(grade);
    return grade.passed() ? 0 : 1;
  });
}" "./$file" "$work/grader"
}

# compile_scene N FILE NAME: a program that notes what the file's solver moves in $work/NAME.motion.
compile_scene() {
  compile "#include \"scenes/motion.hpp\"
#include \"scenes/0$1.cpp\"
extern \"C\" int __wrap_main() {
  return cairn::reader_code::graded([] {
    cairn::Motion motion(\"$work/$3.motion\");
    cairn::filmed::film_0$1(motion);
    return motion.close() ? 0 : 1;
  });
}" "$2" "$work/$3"
}

# run_grader: exit code 0: passed, 1: not yet, 3: it cannot be run.
run_grader() { "$runner" grader "$file" "$work/grader"; }

# The first error in the reader's file with its line, or else what a stage could not call.
explain_errors() {
  local error line stage
  error=$(find_error "(^|[ /])$file:[0-9]+:([0-9]+:)? (fatal )?error: ")
  if [[ $error ]]; then
    line=$(sed -E "s/.*$file:([0-9]+):.*/\1/" <<<"${error%%error: *}")
    printf '%s does not compile. Line %s: %s\n  %s\n' "$file" "$line" "${error#*error: }" "$(sed -n "${line}p" "$file")"
    return
  fi
  if find_error "$memory_pattern" >/dev/null; then
    printf 'Compiling %s takes more memory than it may: does a template or a constexpr function go on without end?\n' "$file"
    return
  fi
  error=$(find_error 'undefined reference to ' | sed -E 's/.*undefined reference to .(.*).$/\1/')
  if [[ $error ]]; then
    printf '%s declares %s, and does not say what it does.\n' "$file" "$error"
    return
  fi
  error=$(find_error ': (fatal )?error: ')
  stage=$(find_error '(stages|scenes)/0[0-9]\.cpp' | sed -E 's,.*(stages|scenes)/0([0-9])\.cpp.*,\2,')
  line=$(find_error "$file:[0-9]+" | grep -oE "$file:[0-9]+" | head -n 1)
  printf 'Stage 0%s cannot use %s: %s\n' "${stage:-$1}" "${line:-$file}" "${error#*error: }"
  printf 'It needs:\n'
  task "${stage:-$1}" | grep '^    '
}

grade_aloud() {
  local code
  task "$1" | head -n 1
  compile_grader "$1" && run_grader
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
    4) explain_errors "$1" ;;
    5) printf '%s\n' "${errors##*$'\n'}" ;;
    *) exit "$code" ;;
  esac
  printf 'Not yet. The task: lessons/your_solver/stages/0%s.txt\n' "$1"
  return 1
}

# The program that draws films, which is built when somebody asks for one; tests name theirs.
find_drawer() {
  drawer=${CAIRN_SOLVER_FILM:-}
  if [[ $drawer ]]; then return; fi
  . "$here/../setup.sh"
  cairn_set_up && cairn_build release solver_film || exit 3
  drawer=$cairn_root/build/release/bin/solver_film
  export MESA_SHADER_CACHE_DIR="${MESA_SHADER_CACHE_DIR:-$cairn_root/build/release/mesa}"
}

# film N THEME: what the reader's solver does beside what the model does.
film() {
  local code folder=out/solver0$1
  compile_scene "$1" "./$file" yours && "$runner" grader "$file" "$work/yours"
  code=$?
  case $code in
    0) ;;
    1) exit 1 ;;
    4) explain_errors "$1"; exit 1 ;;
    5) printf '%s\n' "${errors##*$'\n'}"; exit 1 ;;
    *) exit "$code" ;;
  esac
  bash "$here/state.sh" "$1" >"$work/model.hpp" 2>/dev/null || cannot "cannot write $work/model.hpp"
  compile_scene "$1" "$work/model.hpp" model && "$runner" grader "the model" "$work/model" ||
    cannot "the model of stage 0$1 cannot be filmed: $errors"
  find_drawer
  "$drawer" "$2" "$(task "$1" | head -n 1)" "$folder/solver0$1" "$work/yours.motion" "$work/model.motion"
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
    compile_grader "$middle" && run_grader >/dev/null 2>&1
    case $? in
      0) low=$middle ;;
      1 | 4) high=$middle ;;
      5) printf '%s\n' "${errors##*$'\n'}"; exit 1 ;;
      *) cannot "$work/grader cannot be run" ;;
    esac
  done
  printf '%s: %s of %s stages pass.\n' "$PWD/$file" "$high" $((last + 1))
  if [[ $high -gt $last ]]; then return; fi
  printf '\n'
  task "$high"
  printf '\nThen: bash lessons/run solver %s\n' "$high"
}

if [[ $# == 0 ]]; then
  make_work_folder
  make_runner
  say_where
  exit
fi
if ! [[ $1 =~ ^0?[0-9]$ ]]; then refuse "the stage must be a number from 0 to $last, got \"$1\""; fi
stage=$((10#$1))
if [[ ${2:-} == --begin && $# == 2 ]]; then begin "$stage"; exit; fi
theme=
case ${*:2} in
  "") ;;
  --film | "--film --theme light") theme=light ;;
  "--film --theme dark") theme=dark ;;
  *) refuse "after the stage there may be --begin, --film or --film --theme light|dark, got \"${*:2}\"" ;;
esac
if [[ ! -f $file ]]; then
  refuse "there is no $file in $PWD; bash lessons/run solver $stage --begin writes the state before stage $stage"
fi
make_work_folder
make_runner
if [[ $theme ]]; then film "$stage" "$theme"; exit; fi
grade_aloud "$stage"
