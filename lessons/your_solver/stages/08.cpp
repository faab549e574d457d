// Stage 08, graded: guesses by key, the step, and the loads of the tower of ten boxes by plain loops on a
// line.
#include "07.cpp"

static Row keyed_row(std::array<int, 3> key, double impulse) {
  Row row = upright_row(0, 1);
  row.key = key;
  row.impulse = impulse;
  return row;
}

static void grade_keys(cairn::Grade& grade) {
  const std::vector<Body> tower = falling_tower({2, 0.5}, 0);
  const std::vector<Row> rows = contacts(tower);
  grade.number({"two boxes on the ground: contacts", 4}, count_of(rows));
  if (rows.size() != 4) return;
  grade.number({"keys of the left and the right point that are equal",
                0,
                {{1, "Two points of one pair need two keys."}}},
               rows[0].key == rows[1].key);
  grade.number({"keys of two pairs that are equal", 0, {{1, "Two pairs need two keys."}}},
               rows[0].key == rows[2].key);
  std::vector<Body> lifted = tower;
  lifted[1].position[1] += 0.01;
  lifted[2].position[1] += 0.01;
  const std::vector<Row> fewer = contacts(lifted);
  if (fewer.size() != 2) return;
  grade.number({"a row keeps its key when rows before it vanish (1: yes)",
                1,
                {{0, "A key names the bodies and the point, not the place among the rows."}}},
               fewer[0].key == rows[2].key);
}

/// One box on two, and another beside them: pairs of which some share the lower body, some the upper one, and
/// some the sum of both numbers.
static void grade_pairs(cairn::Grade& grade) {
  std::vector<Body> bodies = {make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 2, -1, 0.5),
                              make_box(1, 1, 2, 1, 0.5), make_box(3, 1, 2, 0, 1.5),
                              make_box(1, 1, 2, 4, 0.5)};
  const std::vector<Row> rows = contacts(bodies);
  grade.number({"a box on two boxes, and one beside them: contacts", 10}, count_of(rows));
  double equal = 0;
  for (const Row& row : rows)
    for (const Row& other : rows)
      if (&row != &other && row.key == other.key) equal = 1;
  grade.number({"two of them with one key (1: yes)",
                0,
                {{1, "Both bodies are in the key, each in its place, and the point is."}}},
               equal);
  if (rows.empty()) return;
  for (Body& body : bodies) body.position[0] += 0.003;
  const std::vector<Row> moved = contacts(bodies);
  if (moved.size() == rows.size())
    grade.number({"a row keeps its key when all boxes move by 3 mm (1: yes)",
                  1,
                  {{0, "A key names the bodies and the point, not where they are."}}},
                 moved[0].key == rows[0].key);
}

static void grade_warm_start(cairn::Grade& grade) {
  std::vector<Body> bodies = falling_tower({2}, 1);
  const std::vector<Row> last = {keyed_row({8, 8, 0}, 5), keyed_row({0, 1, 1}, 0.75),
                                 keyed_row({0, 1, 0}, 0.25)};
  std::vector<Row> rows = {keyed_row({0, 1, 0}, 0), keyed_row({0, 1, 1}, 0), keyed_row({0, 2, 0}, 0)};
  warm_start(rows, last, bodies);
  grade.number({"warm_start: impulse of a row that stood third in the last step (N s)",
                0.25,
                {{5, "A row finds its impulse by its key, not by its place."},
                 {0, "The rows of the list begin with last step's impulses."},
                 {0.25 * 0.02, "λΔt is kept: the step has the same Δt."}}},
               rows[0].impulse);
  grade.number({"of the second row (N s)", 0.75, {{0, "All rows begin with last step's impulses."}}},
               rows[1].impulse);
  grade.number(
      {"of a row that was not there (N s)",
       0,
       {{0.25, "A row that was not there begins with 0."}, {5, "A row that was not there begins with 0."}}},
      rows[2].impulse);
  grade.number({"2 kg that fell at 1 m/s: velocity after the guess (m/s)",
                -0.5,
                {{-1, "The guess has to act before the first sweep: apply it."},
                 {0, "The guess acts once."},
                 {-1.5, "The sign: apply the impulse as the row does."}}},
               bodies[1].velocity[1]);
}

/// Plain loops on a line: the loads [N] on the lowest box after each step, and with one of three mistakes.
struct LineWorld {
  double gravity = 10, dt = 0.02;
  int sweeps = 10;
  bool is_warm = true, guess_acts = true, sweeps_first = false;

  std::vector<double> loads(const std::vector<double>& masses, int steps) const {
    LineTower line(masses, 0);
    std::vector<double> found;
    for (int k = 0; k < steps; ++k) {
      for (std::size_t i = 1; !sweeps_first && i < line.v.size(); ++i) line.v[i] -= gravity * dt;
      for (std::size_t i = 1; i < line.v.size(); ++i) {
        if (!is_warm) line.impulse[i] = 0;
        if (guess_acts) line.push(i, line.impulse[i]);
      }
      for (int s = 0; s < sweeps; ++s) line.sweep_by_hand();
      for (std::size_t i = 1; sweeps_first && i < line.v.size(); ++i) line.v[i] -= gravity * dt;
      found.push_back(line.impulse[1] / dt);
    }
    return found;
  }
};

/// The same tower in the reader's world. Its boxes cannot turn, so that both points of a contact ask for the
/// same.
static World tower_world(const std::vector<double>& masses, const LineWorld& settings) {
  World world;
  world.bodies = falling_tower(masses, 0);
  for (Body& body : world.bodies) body.inverse_mass[2] = 0;
  world.gravity = settings.gravity;
  world.dt = settings.dt;
  world.sweeps = settings.sweeps;
  return world;
}

static double load_on_the_lowest(const World& world) {
  double sum = 0;
  for (const Row& row : world.rows)
    if (row.body_a == 0) sum += row.impulse;
  return sum / world.dt;
}

static void grade_loads(cairn::Grade& grade, const std::string& name, const std::vector<double>& masses,
                        const LineWorld& settings, const std::vector<int>& frames) {
  LineWorld cold = settings, silent = settings, late = settings, one_sweep = settings;
  cold.is_warm = silent.guess_acts = false;
  late.sweeps_first = true;
  one_sweep.sweeps = 1;
  World world = tower_world(masses, settings);
  LineWorld ten = settings;
  ten.sweeps = 10;
  const auto load_at = [&masses](const LineWorld& loops, int frame) {
    return loops.loads(masses, frame).back();
  };
  int frame = 0;
  for (const int wanted : frames) {
    for (; frame < wanted; ++frame) step(world);
    grade.number({name + "load after frame " + std::to_string(wanted) + " (N)",
                  load_at(settings, wanted),
                  {{load_at(ten, wanted), "world.sweeps says how many sweeps there are."},
                   {load_at(late, wanted), world.rows.empty()
                                               ? "A step leaves its rows in world.rows."
                                               : "Gravity comes before the sweeps, or they do not see it."},
                   {load_at(one_sweep, wanted), "world.sweeps sweeps in each step, not one."},
                   {load_at(cold, wanted),
                    "Every step begins cold: world.rows has to keep the rows of the last step."},
                   {load_at(silent, wanted), "The guess has to act before the first sweep: apply it."}}},
                 load_on_the_lowest(world));
  }
}

static void grade_falling_step(cairn::Grade& grade) {
  World world;
  world.bodies = {make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 0.5, 0, 1)};
  world.gravity = 8;
  world.dt = 0.04;
  world.sweeps = 4;
  step(world);
  grade.number({"0.5 kg in the air, one step: height (m)",
                1 - 8 * 0.04 * 0.04,
                {{1, "Positions move with the new velocities: first the velocity, then the position."},
                 {1 - 10 * 0.04 * 0.04, "Use world.gravity."},
                 {1 - 8 * 0.04 * 0.02, "Use world.dt, for velocities and for positions."},
                 {1 - 8 * 0.02 * 0.02, "Use world.dt."}}},
               world.bodies[1].position[1]);
}

static void grade_08(cairn::Grade& grade) {
  grade_keys(grade);
  grade_pairs(grade);
  grade_warm_start(grade);
  grade_falling_step(grade);
  grade_loads(grade, "2 and 0.5 kg, Δt = 0.05 s: ", {2, 0.5}, {.gravity = 8, .dt = 0.05, .sweeps = 2},
              {1, 2, 4});
  grade_loads(grade, "ten boxes: ", std::vector<double>(10, 1.0), {}, {1, 2, 3, 5, 10});
}

/// With those before it.
static void stage_08(cairn::Grade& grade) {
  stage_07(grade);
  grade.begin(8);
  grade_08(grade);
}
