#!/usr/bin/env bash
# lessons.sh DRIVER FOLDER: runs all lessons; every check that holds ends with "ok". The driver notes what was passed in
# the folder where it is started: not in a student's.
mkdir -p "$2" && cd "$2" || exit 1
"$1" check --all 2>&1 </dev/null | tee log.txt
code=${PIPESTATUS[0]}
passed=$(grep -cE '^ *CHECK .*[ .]ok *$' log.txt)
failed=$(($(grep -cE '^ *CHECK ' log.txt) - passed))
if [[ $failed == 0 && ($code != 0 || $passed == 0) ]]; then failed=1; fi
printf '%d passed, %d failed\n' "$passed" "$failed"
[[ $failed == 0 ]]
