// Floor 8. The page on scene files: five minutes first, then every table and every key.
#include <fmt/format.h>

#include "scenes/scene_schema.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

const char* const scene_page_beginning = R"(# Scenes

Every `.toml` file of this folder is a scene. Copy one, change it, and run it:

    bash lessons/run cairn run lessons/scenes/stack.toml

The program is `build/release/bin/cairn` once it is built; below it is `cairn` for short.

Or write one of your own, in five minutes.

## Your first scene

A scene file is text in [TOML](https://toml.io): `key = value` in tables with a `[name]`. Everything is in
metres, kilograms, seconds and radians; x points to the right, y upwards. Make a file `tower-and-ball.toml`.
The keys before the first table are about the whole scene:

```toml
title = "a ball swings into a tower"
look = "The ball meets the tower near its foot, and goes on swinging."
seconds = 3
```

Now something to stand on. The ground is at a height of 0, unless you say otherwise:

```toml
[ground]
half_width = 8
```

A tower: one table stands for five boxes, named tower.1 (the lowest) to tower.5. A table in two brackets can
come as often as you like:

```toml
[[stack]]
name = "tower"
n = 5
box = [0.8, 0.8]
```

A ball, 3 m to the left of the point that it will hang from:

```toml
[[body]]
name = "ball"
circle = 0.4
position = [-4, 4]
density = 4
```

A rod from that point, which belongs to the ground, to the middle of the ball. Its length follows from where
you placed them:

```toml
[[joint]]
type = "rod"
a = "ground"
b = "ball"
anchor_a = [-1, 4]
```

That is a scene. One more table says which limits a good run keeps. `cairn run` then says whether it kept them:

```toml
[expect]
penetration = 0.02
drift = 0.01
energy_gain = 1
```

The whole of it is [tower-and-ball.toml](tower-and-ball.toml). Things to try: `n = 8`; `mass = 20` for the
ball; `type = "rope"`; `--solver si:2` behind the command.

A mistake is reported with its place in the file, and nothing is run:

    tower-and-ball.toml:20:1: body[1].densty must be a known key, but [[body]] has none of that name (density?)

## Numbers

Where a number is wanted, a sum in quotes will do: `angle = "30 deg"`, `dt = "1 / 240"`. It may have + - *
/, brackets, `pi`, `sqrt`, `abs`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, the unit `deg`, and numbers
of your own:

```toml
[numbers]
mu = 0.05
```

## Lengths

Some keys have a default that follows from L, the unit of length of the scene: the median of the square roots
of the areas of its bodies, to the nearest power of two, or what falls in 24 substeps where that is more. So a
scene of marbles and one of mountains behave as one of metres does. `cairn explain` says what they come to.

## Words

Where one of a few words is wanted, a blank, `-` and `_` are the same: `"split impulse"` is
`"split-impulse"`. The flags of `cairn` read words likewise.

## Names

Bodies without a name are called body.1, body.2 and so on, counting every `[[body]]`. The bodies of a table
that stands for many are named after it: `[[chain]]` makes chain.1 to chain.n, and chain.bob. Joints can use
all of these, and `ground`. With `b = "row.*"` a joint is made for every body of a row. Bodies and joints
come in the order of the file, and that is the order in which a solver goes through them.

Joints have names for events: joint.1, joint.2 and so on, or their own. A joint with `b = "row.*"` makes
joint.1.1, joint.1.2 and so on. A table that stands for many makes chain.joint.1, row.joint.1, cradle.joint.1
and so on. No body and no joint shares its name with another.

## Events

A scene can change while it runs: a body or a joint is removed, a body gets an impulse, or a motor is
switched.

```toml
[[event]]
time = 1
remove = "pin"

[[event]]
time = 1.5
push = "ball"
impulse = [2, 0]
```

Every program that runs the scene carries its events out, and so does Box2D if none of them switches a motor.
What an event does to the energy counts neither as gain nor as loss; what a motor does later counts, as it
always does. [drawbridge.toml](drawbridge.toml) has two of them.

A scene that begins with a fall does not stand, so `stands` in `[expect]` would be missed. Say where bodies
should be at the end instead:

```toml
[[expect.body]]
name = "ball"
position = [4.6, 0.3]
within = 0.02
```

## Ground

`[ground]` is flat. Ground of any other form is a `chain` of points, a shape of a static or kinematic body:

```toml
[[body]]
name = "valley"
type = "static"
chain = [[6, 3], [2, 0], [-2, 0], [-6, 3]]
```

Only one side of it is solid: the side on your left when you walk from point to point. So ground runs from
right to left, and a room, with `closed = true`, runs clockwise. Pictures mark the solid side by short
strokes. Its corners are smooth: what slides or rolls over one meets no edge of the next link. Its `ghosts`,
one point before it and one after it, say how it would go on, and are not part of it. Without them it goes on
straight. Static boxes, polygons and segments that lie level side by side are just as smooth, as long as they
collide with the same bodies. Dynamic ones, and pieces of a kinematic body, keep their edges, and so do
rounded boxes whose rounding leaves a groove.

## Limits

A file may have up to 1 MB, and a scene up to 20000 bodies, 50000 joints and 1000 events. A text is one line
of at most 1000 bytes, without control characters.

)";

std::string scene_default_text(const SceneKey& key) {
  if (key.fallback.empty()) return "";
  if (key.fallback == "required") return "**required**";
  if (!has_default(key)) {
    std::string words = key.fallback;
    words[0] = static_cast<char>(words[0] - 'A' + 'a');
    return words;
  }
  const bool is_text = key.type == SceneType::word || key.type == SceneType::text;
  const bool is_sum = key.fallback.find('/') != std::string::npos;
  return is_text || is_sum ? "`\"" + key.fallback + "\"`" : "`" + key.fallback + "`";
}

std::string scene_type_text(const SceneKey& key) {
  switch (key.type) {
    case SceneType::word: {
      std::string text;
      for (const std::string& word : scene_words(key)) text += (text.empty() ? "`" : ", `") + word + "`";
      return text;
    }
    case SceneType::text:
      return "text";
    case SceneType::flag:
      return "`true`, `false`";
    case SceneType::integer:
      return "whole number " + key.range;
    case SceneType::number:
      return key.range.empty() ? "number" : "number " + key.range;
    case SceneType::point:
      return key.range.empty() ? "[x, y]" : "[x, y] " + key.range;
    case SceneType::points:
      return "[[x, y], ...]";
    case SceneType::table:
      return "table";
    case SceneType::tables:
      break;
  }
  return "tables";
}

/// The keys of some groups as a table.
std::string scene_key_rows(const List<std::string>& groups) {
  std::string text = "| key | value | unit | default | meaning |\n|---|---|---|---|---|\n";
  for (const std::string& group : groups) {
    for (const SceneKey& key : scene_keys()) {
      if (key.group != group) continue;
      text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.key, scene_type_text(key), key.unit,
                          scene_default_text(key), key.meaning);
    }
  }
  return text + "\n";
}

/// Groups that many tables share are listed once, under a heading of their own.
struct SharedGroup {
  std::string name = {};
  std::string title = {};
};

const List<SharedGroup>& shared_scene_groups() {
  static const List<SharedGroup> groups = {
      {"repeat", "Name"}, {"shape", "Shape"}, {"matter", "Matter"}, {"motion", "Motion"},
      {"joint", "Joint"}, {"pair", "Pair"},   {"anchor", "Anchor"}, {"distance", "Distance"},
      {"slack", "Slack"}, {"soft", "Soft"},   {"give", "Give"},     {"pace", "Pace"}};
  return groups;
}

/// The heading of a group as GitHub links to it.
std::string scene_link(const std::string& title) {
  std::string anchor = title;
  anchor[0] = static_cast<char>(anchor[0] - 'A' + 'a');
  return fmt::format("[{}](#{})", title, anchor);
}

std::string scene_kind_text(const SceneTableKind& kind) {
  std::string text = fmt::format(
      "### {}\n\n{}\n", kind.name == "scene" ? "The file itself" : "`" + kind.heading + "`", kind.meaning);
  std::string shared;
  List<std::string> own;
  for (const std::string& group : kind.groups) {
    std::string title;
    for (const SharedGroup& each : shared_scene_groups()) {
      if (each.name == group) title = each.title;
    }
    if (title.empty()) {
      own.push_back(group);
    } else {
      shared += (shared.empty() ? "" : ", ") + scene_link(title);
    }
  }
  if (!shared.empty()) text += fmt::format("It has the keys of {}{}\n", shared, own.empty() ? "." : ", and:");
  text += "\n";
  return own.empty() ? text : text + scene_key_rows(own);
}

}  // namespace

std::string scene_schema_page() {
  std::string text = scene_page_beginning;
  text += "## Every table\n\n";
  for (const SceneTableKind& kind : scene_table_kinds()) {
    if (kind.name != "joint") text += scene_kind_text(kind);
  }
  text += "## Keys that many tables have\n\n";
  for (const SharedGroup& group : shared_scene_groups()) {
    text += "### " + group.title + "\n\n" + scene_key_rows({group.name});
  }
  while (text.size() > 1 && text[text.size() - 2] == '\n') text.pop_back();
  return text;
}

}  // namespace cairn
