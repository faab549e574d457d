// Floor 8. Keys of the whole scene: how it steps, what is recommended, what is expected.
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_field.hpp>
#include <cairn/scenes/scene_list.hpp>

namespace cairn {

List<SceneKey> scene_top_keys() {
  using enum SceneType;
  return {
      {"scene", "title", &SceneEntry::title, "", "", "a few words", "The name of the file"},
      {"scene", "look", &SceneEntry::look, "", "", "what to see, in a sentence"},
      {"scene", "seconds", &SceneEntry::seconds, "s", "from 1e-6 to 3600",
       "worth watching; the expectations hold for this long"},
      {"scene", "order", &SceneEntry::order, "", "", "place in lists: smaller numbers come first"},
      {"scene", "view", one_of({"side", "top"}), "", "",
       "`top`: seen from above, gravity points into the page", "side"},
      {"scene", "gravity", &SceneSettings::gravity, "m/s^2", "", "not with view = \"top\", which has none"},
      {"scene", "wind", nested(&SceneSettings::fields, &Fields::wind), "m/s", "",
       "velocity of the air, for bodies with drag"},
      {"scene", "gravitation", nested(&SceneSettings::fields, &Fields::gravitation), "m^3/(kg s^2)", ">= 0",
       "G: every two dynamic bodies attract each other with G m m / r^2"},
      {"scene", "numbers", table, "", "numbers", "numbers of your own"},
      {"scene", "ground", table, "", "ground", "a flat surface; without the table there is none"},
      {"scene", "camera", table, "", "camera", "what a picture shows"},
      {"scene", "step", table, "", "step", "how the scene steps"},
      {"scene", "recommended", table, "", "recommended", "a solver and settings that do well"},
      {"scene", "expect", table, "", "expect", "the limits that a good run keeps"},
      {"scene", "body", tables, "", "body", "one body"},
      {"scene", "joint", tables, "", "joint", "what joins bodies"},
      {"scene", "water", table, "", "water", "carries and slows what is in it"},
      {"scene", "attraction", tables, "", "attraction", "a point that pulls"},
      {"scene", "force", tables, "", "force", "a force or a torque, for a while or for ever"},
      {"scene", "path", tables, "", "path", "where a kinematic body goes"},
      {"scene", "event", tables, "", "event", "what happens while it runs"},
      {"scene", "link", tables, "", "link", "one body, from point to point"},
      {"scene", "stack", tables, "", "stack", "boxes or discs on top of each other"},
      {"scene", "pyramid", tables, "", "pyramid", "boxes in rows that grow shorter"},
      {"scene", "row", tables, "", "row", "bodies in a row, or in rows"},
      {"scene", "pile", tables, "", "pile", "discs or boxes of many sizes, to be poured"},
      {"scene", "arch", tables, "", "arch", "stones in a semicircle"},
      {"scene", "dominoes", tables, "", "dominoes", "dominoes, the first one leaning"},
      {"scene", "cards", tables, "", "cards", "a house of cards"},
      {"scene", "cradle", tables, "", "cradle", "balls that hang in a row"},
      {"scene", "chain", tables, "", "chain", "bodies joined in a row"},
      {"ground", "height", &GroundSpec::height, "m", "", "of its surface"},
      {"ground", "half_width", &GroundSpec::half_width, "m", "> 0", "how far it reaches to each side",
       "Where L is more than 1 m 50 L, else 50"},
      {"ground", "friction", nested(&GroundSpec::material, &Material::friction), "", "from 0 to 1e6",
       "coefficient mu"},
      {"ground", "restitution", nested(&GroundSpec::material, &Material::restitution), "", "from 0 to 1",
       "coefficient e"},
      {"ground", "surface_speed", nested(&GroundSpec::material, &Material::surface_speed), "m/s", "",
       "of a belt: to the right"},
      {"camera", "center", &SceneCamera::center, "m", "", "middle of the picture"},
      {"camera", "height", &SceneCamera::height, "m", "> 0", "of what the picture shows"},
  };
}

List<SceneKey> scene_step_keys() {
  using enum SceneType;
  return {
      {"step", "speculative_margin", &SceneSettings::speculative_margin, "m", ">= 0",
       "nearer shapes get contact rows", "A 50th of L"},
      {"step", "restitution_threshold", &SceneSettings::restitution_threshold, "m/s", ">= 0",
       "slower approaches do not rebound", "That of a fall through L / 80"},
      {"step", "friction_rows", &SceneSettings::friction_rows, "", "", "rows of friction"},
      {"step", "sleeping", table, "", "sleeping", "bodies at rest are left out; without it never"},
      {"sleeping", "speed", &Sleeping::speed, "m/s", "> 0", "of the centre of mass"},
      {"sleeping", "angular_speed", &Sleeping::angular_speed, "rad/s", "> 0", "of its turning"},
      {"sleeping", "time", &Sleeping::time, "s", "> 0", "how long it must be so slow, in one place"},
      {"pace", "dt", members(&SceneSettings::dt, &Setting::dt), "s", "from 1e-12 to 1e6", "one step",
       "1 / 60"},
      {"pace", "substeps", members(&SceneSettings::substeps, &Setting::substeps), "",
       "from 1 to " + std::to_string(SceneSettings::most_substeps), "solves in a step, each of dt / substeps",
       "In [step] 1, in [recommended] 4"},
      {"pace", "contact_search", members(&SceneSettings::contact_search, &Setting::contact_search), "", "",
       "how long manifolds last"},
      {"pace", "warm_start", members(&SceneSettings::warm_start, &Setting::warm_start), "", "",
       "begin from the last step's impulses"},
      {"pace", "stabilization", table, "", "stabilization", "how errors in positions are removed"},
      {"stabilization", "policy", &Stabilization::policy, "", "", "what happens to errors in positions"},
      {"stabilization", "baumgarte", &Stabilization::baumgarte, "", ">= 0",
       "share of an error that a step removes"},
      {"stabilization", "slop", &Stabilization::slop, "m", ">= 0",
       "overlap of contacts that is left alone, except under soft", "A 200th of L"},
      {"stabilization", "max_speed", &Stabilization::max_speed, "m/s", "> 0 or inf",
       "overlap of contacts is removed no faster", "That of a fall through 0.8 L"},
      {"stabilization", "frequency", nested(&Stabilization::soft, &SwingSoftness::frequency), "Hz",
       "from 1e-6 to 1e6", "of contacts under soft"},
      {"stabilization", "damping_ratio", nested(&Stabilization::soft, &SwingSoftness::damping_ratio), "",
       "from 0 to 1e30", "of contacts under soft"},
      {"stabilization", "joint_frequency", nested(&Stabilization::joint_soft, &SwingSoftness::frequency),
       "Hz", "from 1e-6 to 1e6", "of joints under soft"},
      {"stabilization", "joint_damping_ratio",
       nested(&Stabilization::joint_soft, &SwingSoftness::damping_ratio), "", "from 0 to 1e30",
       "of joints under soft"},
  };
}

List<SceneKey> scene_recommended_keys() {
  using enum SceneType;
  return {
      {"recommended", "solver", text, "", "", "a name of `cairn list`, or box2d",
       "newton up to 300 freedoms, else wide"},
      {"recommended", "iterations", &SolverSettings::iterations, "",
       "from 0 to " + std::to_string(Setting::most_sweeps), "sweeps, at most"},
      {"recommended", "tolerance", &SolverSettings::tolerance, "", ">= 0",
       "stop once the residual is this small; 0: never"},
      {"recommended", "time_budget", &SolverSettings::time_budget, "s", ">= 0",
       "no sweep begins after this time; 0: no limit"},
      {"recommended", "row_order", &SolverSettings::order, "", "", "of the rows in a sweep"},
      {"recommended", "seed", &SolverSettings::seed, "", "from 0 to 9007199254740992",
       "of the shuffled order"},
      {"recommended", "relaxation", &SolverSettings::relaxation, "", "from 0.001 to 1.999", "omega of SOR"},
      {"recommended", "patience", &SolverSettings::patience, "", "from 0 to 1000000000",
       "stop after so many sweeps at a standstill; 0: never"},
      {"recommended", "scalar", &Setting::scalar, "", "", "type of number"},
      {"recommended", "position_iterations", &Setting::position_iterations, "", "from 0 to 1000000000",
       "of box2d alone"},
      {"expect", "penetration", &Expectations::penetration, "m", "> 0", "no overlap is deeper"},
      {"expect", "drift", &Expectations::drift, "m or rad", "> 0", "no joint is further off"},
      {"expect", "energy_gain", &Expectations::energy_gain, "%", "> 0", "energy does not rise by more"},
      {"expect", "energy_loss", &Expectations::energy_loss, "%", "> 0",
       "at the end, energy is not lower by more than this"},
      {"expect", "stands", &Expectations::stands, "m", "> 0",
       "once the scene has settled, no body moves further"},
      {"expect", "body", tables, "", "expected place", "where a body is at the end"},
  };
}

}  // namespace cairn
