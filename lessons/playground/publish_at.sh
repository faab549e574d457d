#!/usr/bin/env bash
# Says where the playground is published: into base_address.txt, which pages are built with, and to the film in README.md.
#   bash lessons/playground/publish_at.sh https://name.example/cairn/   or '' where it is published nowhere
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
readme=$here/../../README.md
if [[ $# != 1 || ! $1 =~ ^(https://[A-Za-z0-9./_~:-]+/)?$ ]]; then
  printf 'publish_at.sh: the address must be empty or https://.../, with a / at its end, got "%s"\n' "${1-}" >&2
  exit 2
fi
printf '%s' "$1" >"$here/base_address.txt.new"
sed "s|^<a href=\"[^\"]*\">\$|<a href=\"${1:-lessons/playground/README.md}\">|" "$readme" >"$readme.new"
mv "$here/base_address.txt.new" "$here/base_address.txt"
mv "$readme.new" "$readme"
