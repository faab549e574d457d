#!/usr/bin/env bash
# headers.sh BUILD CMAKE: every header compiles alone; a build that is a test.
log=$("$2" --build "$1" --target header_tests -- -k 0 2>&1)
code=$?
failed=$(grep -c '^FAILED: ' <<<"$log")
if [[ $code != 0 && $failed == 0 ]]; then failed=1; fi
if [[ $failed != 0 ]]; then printf '%s\n' "$log"; fi
printf '%d passed, %d failed\n' $(($(find "$1/tests/headers" -name '*.cpp' | wc -l) - failed)) "$failed"
exit "$code"
