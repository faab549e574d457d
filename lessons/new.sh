# A new lesson from lessons/template. Sourced by lessons/run.

# cairn_new_lesson NAME [FOLDER]: makes lessons/NN_NAME, or the same in another folder of lessons, with the next free
# number, and says what to do with it. 2 where the name is refused.
cairn_new_lesson() {
  local name=$1 lessons=${2:-$cairn_root/lessons} number title folder file
  if [[ ! $name =~ ^[a-z][a-z0-9]*(_[a-z0-9]+)*$ ]]; then
    printf 'lessons/run: new: the name must be small letters, digits and single _, such as ball_on_ice, got "%s"\n' "$name" >&2
    return 2
  fi
  for folder in "$lessons"/[0-9][0-9]_"$name"; do
    if [[ -e $folder ]]; then
      printf 'lessons/run: new: there is a lesson of that name: %s\n' "$folder" >&2
      return 2
    fi
  done
  number=$(for folder in "$lessons"/[0-9][0-9]_*; do basename "$folder"; done | sort | tail -n 1)
  number=$(printf '%02d' $((10#${number%%_*} + 1)))
  if [[ $number == 100 ]]; then
    printf 'lessons/run: new: there are 100 lessons, and no number is left\n' >&2
    return 2
  fi
  title=${name//_/ }
  title=${title^}
  folder=$lessons/${number}_$name
  mkdir "$folder.new" || return 3
  for file in "$cairn_root"/lessons/template/*.in; do
    sed -e "s/NN_DECIMAL/$((10#$number))/g; s/\.number = NN/.number = $((10#$number))/" \
        -e "s/NUMBER/$((10#$number))/g; s/FOLDER/${number}_$name/g; s/NN/$number/g; s/NAME/$name/g; s/TITLE/$title/g" \
        "$file" >"$folder.new/$(basename "$file" .in)" || return 3
  done
  mv "$folder.new" "$folder" || return 3
  cat <<EOF
lessons/${number}_$name is a small lesson that works. Next:
  bash lessons/run $((10#$number))          builds and runs it
  cmake --build build/release --target images    draws its cover, which its page shows
  bash tests/run              holds it to what all lessons keep to
Add it to the list in README.md when it is ready. lessons/WRITING.md says what makes a good one.
EOF
}
