#!/usr/bin/env bash
# Builds the core for browsers in build/web. Sourced by lessons/run and tests/run, after lessons/setup.sh.

# cairn_build_web TARGET...: as cairn_build.
cairn_build_web() {
  # emscripten's own scripts look for Debian's packages there, whichever node runs them.
  export NODE_PATH="${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs:/usr/lib/nodejs"
  cairn_build web "$@"
}

# cairn_make_playground FILE: one page with everything in it.
cairn_make_playground() {
  cairn_build_web cairn_playground || return
  mkdir -p "$(dirname "$1")" || return
  node "$cairn_root/lessons/playground/page/bundle.mjs" "$cairn_root/build/web/bin" "$cairn_root/lessons/scenes" "$1"
}
