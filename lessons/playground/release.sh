#!/usr/bin/env bash
# What the project publishes: the playground and the book, as they were tested. Sourced by lessons/run, after setup.sh.

# cairn_pack FILE: keeps FILE compressed instead, where that is smaller. The same bytes on every run.
cairn_pack() {
  gzip -9 -n -c "$1" >"$1.gz" || return
  if [[ $(stat -c %s "$1.gz") -lt $(stat -c %s "$1") ]]; then rm "$1"; else rm "$1.gz"; fi
}

# cairn_check_pages FOLDER: the book there in a browser, with the driver that the test of the playground has fetched.
cairn_check_pages() {
  local pages said
  pages=$(cd "$1" && pwd) || return
  said=$(cd "$cairn_root/build/web_tests" && node "$cairn_root/tests/book/browser.mjs" "$pages") && return
  printf '%s\n' "$said" >&2
  return 1
}

# cairn_fill_release FOLDER BOOK-COMMAND...: a site to serve, and files to hand out; the command writes the book into the
# folder that is named behind it, and takes the playground from out/playground/.
cairn_fill_release() {
  local folder=$1 tested=$cairn_root/build/web_tests page=out/playground/index.html
  shift
  (cd "$tested" && sha256sum --check --status tested) || {
    printf 'lessons/run: %s is not the page that bash tests/run web has tested\n' "$tested/index.html" >&2
    return 1
  }
  mkdir -p "$(dirname "$page")" "$folder/site" && cp "$tested/index.html" "$page.new" && mv "$page.new" "$page" &&
    "$@" "$folder/site/book" && cp "$tested/index.html" "$folder/site/index.html" || return
  if ! cmp "$folder/site/index.html" "$folder/site/book/playground.html" >&2; then return 1; fi
  cairn_check_pages "$folder/site/book" &&
    cp "$folder/site/index.html" "$folder/playground.html" && cairn_pack "$folder/playground.html" &&
    tar --create --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
      --directory "$folder/site" --file "$folder/book.tar" book && cairn_pack "$folder/book.tar" || return
  (cd "$folder" && sha256sum playground.html* book.tar* >SHA256SUMS)
}

# cairn_make_release FOLDER BOOK-COMMAND...: tests the playground, and puts the new folder into the place of an earlier one.
cairn_make_release() {
  local folder=$1
  shift
  bash "$cairn_root/tests/run" web || return
  rm -rf "$folder.new"
  if ! cairn_fill_release "$folder.new" "$@"; then
    rm -rf "$folder.new"
    return 1
  fi
  rm -rf "$folder" && mv "$folder.new" "$folder"
}
