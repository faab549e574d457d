// Floor 8. Keys of the whole scene: how it steps, what is recommended, what is expected.
#include "scenes/scene_schema.hpp"
#include "scenes/setting.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

/// As SceneKey::range has them.
std::string listed_words(const List<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

List<SceneKey> scene_top_keys() {
  using enum SceneType;
  return {
      {"scene", "title", text, "", "The name of the file", "", "a few words"},
      {"scene", "look", text, "", "", "", "what to see, in a sentence"},
      {"scene", "seconds", number, "s", "2", "from 1e-6 to 3600",
       "worth watching; the expectations hold for this long"},
      {"scene", "order", number, "", "1000", "", "place in lists: smaller numbers come first"},
      {"scene", "view", word, "", "side", "side, top",
       "`top`: seen from above, gravity points into the page"},
      {"scene", "gravity", point, "m/s^2", "[0, -10]", "", "not with view = \"top\", which has none"},
      {"scene", "numbers", table, "", "", "numbers", "numbers of your own"},
      {"scene", "ground", table, "", "", "ground", "a flat surface; without the table there is none"},
      {"scene", "camera", table, "", "", "camera", "what a picture shows"},
      {"scene", "step", table, "", "", "step", "how the scene steps"},
      {"scene", "recommended", table, "", "", "recommended", "a solver and settings that do well"},
      {"scene", "expect", table, "", "", "expect", "the limits that a good run keeps"},
      {"scene", "body", tables, "", "", "body", "one body"},
      {"scene", "joint", tables, "", "", "joint", "what joins bodies"},
      {"scene", "event", tables, "", "", "event", "what happens while it runs"},
      {"scene", "link", tables, "", "", "link", "one body, from point to point"},
      {"scene", "stack", tables, "", "", "stack", "boxes or discs on top of each other"},
      {"scene", "pyramid", tables, "", "", "pyramid", "boxes in rows that grow shorter"},
      {"scene", "row", tables, "", "", "row", "bodies in a row, or in rows"},
      {"scene", "pile", tables, "", "", "pile", "discs or boxes of many sizes, to be poured"},
      {"scene", "arch", tables, "", "", "arch", "stones in a semicircle"},
      {"scene", "dominoes", tables, "", "", "dominoes", "dominoes, the first one leaning"},
      {"scene", "cards", tables, "", "", "cards", "a house of cards"},
      {"scene", "cradle", tables, "", "", "cradle", "balls that hang in a row"},
      {"scene", "chain", tables, "", "", "chain", "bodies joined in a row"},
      {"ground", "height", number, "m", "0", "", "of its surface"},
      {"ground", "half_width", number, "m", "Where L is more than 1 m 50 L, else 50", "> 0",
       "how far it reaches to each side"},
      {"ground", "friction", number, "", "0.6", "from 0 to 1e6", "coefficient mu"},
      {"ground", "restitution", number, "", "0", "from 0 to 1", "coefficient e"},
      {"camera", "center", point, "m", "[0, 0]", "", "middle of the picture"},
      {"camera", "height", number, "m", "10", "> 0", "of what the picture shows"},
  };
}

List<SceneKey> scene_step_keys() {
  using enum SceneType;
  return {
      {"step", "speculative_margin", number, "m", "A 50th of L", ">= 0", "nearer shapes get contact rows"},
      {"step", "restitution_threshold", number, "m/s", "That of a fall through L / 80", ">= 0",
       "slower approaches do not rebound"},
      {"step", "friction_rows", word, "", "per-point", "per-point, per-manifold", "rows of friction"},
      {"step", "sleeping", table, "", "", "sleeping", "bodies at rest are left out; without it never"},
      {"sleeping", "speed", number, "m/s", "0.05", "> 0", "of the centre of mass"},
      {"sleeping", "angular_speed", number, "rad/s", "0.05", "> 0", "of its turning"},
      {"sleeping", "time", number, "s", "0.5", "> 0", "how long it must be so slow, in one place"},
      {"pace", "dt", number, "s", "1 / 60", "from 1e-12 to 1e6", "one step"},
      {"pace", "substeps", integer, "", "Where there are joints 4, else 1",
       "from 1 to " + std::to_string(SceneSettings::most_substeps),
       "solves in a step, each of dt / substeps"},
      {"pace", "contact_search", word, "", "every-substep", listed_words(contact_search_words()),
       "how long manifolds last"},
      {"pace", "warm_start", flag, "", "true", "", "begin from the last step's impulses"},
      {"pace", "stabilization", table, "", "", "stabilization", "how errors in positions are removed"},
      {"stabilization", "policy", word, "", "relaxed", listed_words(stabilization_words()),
       "what happens to errors in positions"},
      {"stabilization", "baumgarte", number, "", "0.2", ">= 0", "share of an error that a step removes"},
      {"stabilization", "slop", number, "m", "A 200th of L", ">= 0",
       "overlap of contacts that is left alone, except under soft"},
      {"stabilization", "max_speed", number, "m/s", "That of a fall through 0.8 L", "> 0 or inf",
       "overlap of contacts is removed no faster"},
      {"stabilization", "frequency", number, "Hz", "30", "from 1e-6 to 1e6", "of contacts under soft"},
      {"stabilization", "damping_ratio", number, "", "10", "from 0 to 1e30", "of contacts under soft"},
      {"stabilization", "joint_frequency", number, "Hz", "60", "from 1e-6 to 1e6", "of joints under soft"},
      {"stabilization", "joint_damping_ratio", number, "", "5", "from 0 to 1e30", "of joints under soft"},
  };
}

List<SceneKey> scene_recommended_keys() {
  using enum SceneType;
  return {
      {"recommended", "solver", text, "", "newton up to 300 freedoms, else wide", "",
       "a name of `cairn list`, or box2d"},
      {"recommended", "iterations", integer, "", "10", "from 0 to " + std::to_string(Setting::most_sweeps),
       "sweeps, at most"},
      {"recommended", "tolerance", number, "", "0", ">= 0", "stop once the residual is this small; 0: never"},
      {"recommended", "time_budget", number, "s", "0", ">= 0",
       "no sweep begins after this time; 0: no limit"},
      {"recommended", "row_order", word, "", "as-written",
       "as-written, reverse, alternating, shuffled, coloured", "of the rows in a sweep"},
      {"recommended", "seed", integer, "", "1", "from 0 to 9007199254740992", "of the shuffled order"},
      {"recommended", "relaxation", number, "", "1", "from 0.001 to 1.999", "omega of SOR"},
      {"recommended", "patience", integer, "", "0", "from 0 to 1000000000",
       "stop after so many sweeps at a standstill; 0: never"},
      {"recommended", "scalar", word, "", "double", listed_words(precision_words()), "type of number"},
      {"recommended", "position_iterations", integer, "", "3", "from 0 to 1000000000", "of box2d alone"},
      {"expect", "penetration", number, "m", "", "> 0", "no overlap is deeper"},
      {"expect", "drift", number, "m or rad", "", "> 0", "no joint is further off"},
      {"expect", "energy_gain", number, "%", "", "> 0", "energy does not rise by more"},
      {"expect", "energy_loss", number, "%", "", "> 0", "at the end, energy is not lower by more than this"},
      {"expect", "stands", number, "m", "", "> 0", "once the scene has settled, no body moves further"},
      {"expect", "body", tables, "", "", "expected place", "where a body is at the end"},
  };
}

}  // namespace

List<SceneKey> scene_setting_keys() {
  List<SceneKey> all;
  for (const auto& part : {scene_top_keys, scene_step_keys, scene_recommended_keys}) {
    for (SceneKey& key : part()) all.push_back(std::move(key));
  }
  return all;
}

}  // namespace cairn
