#!/usr/bin/env bash
# Builds the core for browsers in build/web. Sourced by lessons/run and tests/run, after lessons/setup.sh.

# cairn_build_web TARGET...: the whole log is in build/web/build.log.
cairn_build_web() {
  local build=$cairn_root/build/web
  # emscripten's own scripts look for Debian's packages there, whichever node runs them.
  export NODE_PATH="${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs:/usr/lib/nodejs"
  mkdir -p "$build"
  if [[ ! -f $build/build.ninja ]]; then
    if ! (cd "$cairn_root" && cmake --preset web) >"$build/configure.log" 2>&1; then
      cat "$build/configure.log" >&2
      return 1
    fi
  fi
  NINJA_STATUS='[%f/%t] ' cmake --build "$build" --target "$@" 2>&1 |
    cairn_watch 'Building for browsers' "$build/build.log" '^\[([0-9]+)/([0-9]+)\]'
  if [[ ${PIPESTATUS[0]} != 0 ]]; then
    sed -n '/^FAILED: /,$p' "$build/build.log" | head -n 60 >&2
    printf 'The build failed. The whole log: build/web/build.log\n' >&2
    return 1
  fi
}

# cairn_make_playground FILE: one page with everything in it.
cairn_make_playground() {
  cairn_build_web cairn_playground || return
  mkdir -p "$(dirname "$1")" || return
  node "$cairn_root/lessons/playground/page/bundle.mjs" "$cairn_root/build/web/bin" "$cairn_root/lessons/scenes" "$1"
}
