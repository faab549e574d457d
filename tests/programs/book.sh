#!/usr/bin/env bash
# book.sh DRIVER FOLDER [screenshots]: the lesson book in a browser, which FOLDER has a driver for (tests/run book fetches
# it). Where it has none, or there is no browser, it is left out, and the exit code is 77.
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if ! command -v node >/dev/null || ! command -v chromium >/dev/null || [[ ! -d $2/node_modules/playwright-core ]]; then
  printf 'left out: there is no browser here\n'
  exit 77
fi
rm -rf "$2/pages" "$2/screenshots"
"$1" book "$2/pages" && cd "$2" && node "$tests/book/browser.mjs" pages "${@:3}"
