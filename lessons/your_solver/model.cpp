// The solver of all stages. A line "//@ 3" says that what follows belongs to the stages from 03 on; "//@ 3-3"
// that stage 04 has replaced it. `state.sh` takes the file of one stage out of it.
//@ 0
// My solver: rigid bodies in the plane, and the constraints between them. Units are m, kg, s and rad.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using Vec3 = std::array<double, 3>;  // x, y and turn

struct Body {
  Vec3 position = {};      // of its centre, and its angle
  Vec3 velocity = {};      // v (1)
  Vec3 inverse_mass = {};  // M⁻¹ (2): 1/m, 1/m, 1/I; zeros for what cannot move
  double width = 0, height = 0;
};

// A box with its centre at (x, y). One of mass 0 cannot move.
Body make_box(double width, double height, double mass, double x, double y) {
  Body box;
  box.position = {x, y, 0};
  box.width = width;
  box.height = height;
  if (mass > 0) {
    const double inertia = mass * (width * width + height * height) / 12;
    box.inverse_mass = {1 / mass, 1 / mass, 1 / inertia};
  }
  return box;
}

// (12), its left half: what gravity does to the velocities in one step.
void add_gravity(std::vector<Body>& bodies, double gravity, double dt) {
  for (Body& body : bodies)
    if (body.inverse_mass[1] > 0) body.velocity[1] -= gravity * dt;
}

// The second half of semi-implicit Euler: positions follow the new velocities.
void move_bodies(std::vector<Body>& bodies, double dt) {
  for (Body& body : bodies)
    for (int k = 0; k < 3; ++k) body.position[k] += body.velocity[k] * dt;
}
//@ 1

struct Vec2 {
  double x = 0, y = 0;
};

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// A vector of the body's own frame, turned as the body is.
Vec2 turned(const Body& body, Vec2 a) {
  const double cosine = std::cos(body.position[2]), sine = std::sin(body.position[2]);
  return {cosine * a.x - sine * a.y, sine * a.x + cosine * a.y};
}
//@ 3

const double infinity = std::numeric_limits<double>::infinity();
//@ 1

struct Row {
  int body_a = 0, body_b = 0;                  // places in the list of bodies
  Vec3 j_a = {}, j_b = {};                     // j (5): three numbers for each body
  double c = 0;                                // the constraint error (3)
                                               //@ 2
  double bias = 0;                             // ζ, the j·v that the row wants
                                               //@ 3
  double lower = -infinity, upper = infinity;  // bounds of the impulse
  double impulse = 0;                          // λΔt, in total
                                               //@ 8
  std::array<int, 3> key = {};                 // what the row is called from step to step
  //@ 1
};

// The row of two points that part along the unit vector u; the arms r lead there from the centres of the
// bodies.
Row row_along(int body_a, Vec2 r_a, int body_b, Vec2 r_b, Vec2 u, double c) {
  Row row;
  row.body_a = body_a;
  row.body_b = body_b;
  row.j_a = {-u.x, -u.y, -cross(r_a, u)};
  row.j_b = {u.x, u.y, cross(r_b, u)};
  row.c = c;
  return row;
}

// A rod between a point of body a and a point of body b, each in its body's own frame.
Row rod(const std::vector<Body>& bodies, int body_a, Vec2 point_a, int body_b, Vec2 point_b, double length) {
  const Vec2 r_a = turned(bodies[body_a], point_a), r_b = turned(bodies[body_b], point_b);
  const Vec3 &x_a = bodies[body_a].position, &x_b = bodies[body_b].position;
  const Vec2 d = {x_b[0] + r_b.x - x_a[0] - r_a.x, x_b[1] + r_b.y - x_a[1] - r_a.y};
  const double distance = std::hypot(d.x, d.y);
  return row_along(body_a, r_a, body_b, r_b, {d.x / distance, d.y / distance}, distance - length);
}
//@ 3

// A point where body b touches body a: it may push the two apart along the normal, which leads from a to b.
Row contact(const std::vector<Body>& bodies, int body_a, int body_b, Vec2 point, Vec2 normal, double gap) {
  const Vec3 &x_a = bodies[body_a].position, &x_b = bodies[body_b].position;
  const Vec2 r_a = {point.x - x_a[0], point.y - x_a[1]}, r_b = {point.x - x_b[0], point.y - x_b[1]};
  Row row = row_along(body_a, r_a, body_b, r_b, normal, gap);
  row.lower = 0;
  return row;
}
//@ 1

// j·v: how fast c grows.
double rate(const Row& row, const std::vector<Body>& bodies) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    sum += row.j_a[k] * bodies[row.body_a].velocity[k];
    sum += row.j_b[k] * bodies[row.body_b].velocity[k];
  }
  return sum;
}
//@ 2

// 1 / (j M⁻¹ jᵀ); 0 where neither body can move.
double effective_mass(const Row& row, const std::vector<Body>& bodies) {
  double inverse = 0;
  for (int k = 0; k < 3; ++k) {
    inverse += row.j_a[k] * row.j_a[k] * bodies[row.body_a].inverse_mass[k];
    inverse += row.j_b[k] * row.j_b[k] * bodies[row.body_b].inverse_mass[k];
  }
  return inverse > 0 ? 1 / inverse : 0;
}

// (22) times Δt: the impulse after which j·v is what the row wants.
double correction(const Row& row, const std::vector<Body>& bodies) {
  return (row.bias - rate(row, bodies)) * effective_mass(row, bodies);
}

// (21) and (19): v ← v + M⁻¹ jᵀ λΔt, for both bodies.
void apply_impulse(const Row& row, double impulse, std::vector<Body>& bodies) {
  for (int k = 0; k < 3; ++k) {
    bodies[row.body_a].velocity[k] += bodies[row.body_a].inverse_mass[k] * row.j_a[k] * impulse;
    bodies[row.body_b].velocity[k] += bodies[row.body_b].inverse_mass[k] * row.j_b[k] * impulse;
  }
}
//@ 9

// (7): the share β of each error is to be gone after one step.
void set_bias(std::vector<Row>& rows, double beta, double dt) {
  for (Row& row : rows) row.bias = -beta * row.c / dt;
}
//@ 5

// A λ = b (15), with λ in newton.
struct System {
  std::vector<std::vector<double>> A;
  std::vector<double> b;
  //@ 6
  std::vector<double> lower, upper;  // bounds of λ
  //@ 5
};

// A row's three numbers for a body; zeros for a body that it does not touch.
Vec3 numbers_for(const Row& row, int body) {
  if (body == row.body_a) return row.j_a;
  if (body == row.body_b) return row.j_b;
  return {};
}

System build(const std::vector<Row>& rows, const std::vector<Body>& bodies, double dt) {
  System system;
  for (const Row& row : rows) {
    std::vector<double>& entries = system.A.emplace_back();
    for (const Row& other : rows) {
      double& entry = entries.emplace_back(0);
      for (const int body : {row.body_a, row.body_b})
        for (int k = 0; k < 3; ++k)
          entry += numbers_for(row, body)[k] * bodies[body].inverse_mass[k] * numbers_for(other, body)[k];
    }
    system.b.push_back((row.bias - rate(row, bodies)) / dt);
    //@ 6
    system.lower.push_back(row.lower / dt);
    system.upper.push_back(row.upper / dt);
    //@ 5
  }
  return system;
}
//@ 6

// One sweep of projected Gauss-Seidel: (28) and a clamp, row by row.
void sweep_matrix(const System& system, std::vector<double>& lambda) {
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    double rest = system.b[i];
    for (std::size_t k = 0; k < lambda.size(); ++k)
      if (k != i) rest -= system.A[i][k] * lambda[k];
    lambda[i] = std::clamp(rest / system.A[i][i], system.lower[i], system.upper[i]);
  }
}
//@ 3

// One sweep of sequential impulses: each row pushes immediately.
void sweep(std::vector<Row>& rows, std::vector<Body>& bodies) {
  for (Row& row : rows) {
    //@ 3-3
    const double push = std::clamp(correction(row, bodies), row.lower, row.upper);
    row.impulse += push;
    //@ 4
    const double before = row.impulse;
    row.impulse = std::clamp(before + correction(row, bodies), row.lower, row.upper);
    const double push = row.impulse - before;
    //@ 3
    apply_impulse(row, push, bodies);
  }
}
//@ 4

// The contacts of a box that stands on another: at both ends of the width that they share. The boxes are
// upright, or turned so little that their faces are lines of slope `angle`.
void add_contacts(const std::vector<Body>& bodies, int below, int above, std::vector<Row>& rows) {
  const Body &b = bodies[below], &a = bodies[above];
  const double left = std::max(b.position[0] - b.width / 2, a.position[0] - a.width / 2);
  const double right = std::min(b.position[0] + b.width / 2, a.position[0] + a.width / 2);
  if (left >= right) return;
  for (const double x : {left, right}) {
    const double top = b.position[1] + b.height / 2 + b.position[2] * (x - b.position[0]);
    const double bottom = a.position[1] - a.height / 2 + a.position[2] * (x - a.position[0]);
    if (bottom - top > 0.001) continue;  // more than a millimetre apart: no contact
    rows.push_back(contact(bodies, below, above, {x, top}, {0, 1}, bottom - top));
    //@ 8
    rows.back().key = {below, above, x == left ? 0 : 1};
    //@ 4
  }
}

// The contacts of all boxes, pair by pair; two bodies that cannot move have none.
std::vector<Row> contacts(const std::vector<Body>& bodies) {
  std::vector<Row> rows;
  const int count = static_cast<int>(bodies.size());
  for (int i = 0; i < count; ++i) {
    for (int k = i + 1; k < count; ++k) {
      const bool can_move = bodies[i].inverse_mass[1] + bodies[k].inverse_mass[1] > 0;
      const bool in_order = bodies[i].position[1] < bodies[k].position[1];
      if (can_move) add_contacts(bodies, in_order ? i : k, in_order ? k : i, rows);
    }
  }
  return rows;
}
//@ 7

// λ [N] of all rows after each sweep: with the matrix, and with impulses.
struct Record {
  std::vector<std::vector<double>> matrix, impulses;
};

Record compare(std::vector<Row> rows, std::vector<Body> bodies, double dt, int sweeps) {
  Record record;
  const System system = build(rows, bodies, dt);
  std::vector<double> lambda(rows.size(), 0.0);
  for (Row& row : rows) row.impulse = 0;
  for (int k = 0; k < sweeps; ++k) {
    sweep_matrix(system, lambda);
    record.matrix.push_back(lambda);
    sweep(rows, bodies);
    std::vector<double>& given = record.impulses.emplace_back();
    for (const Row& row : rows) given.push_back(row.impulse / dt);
  }
  return record;
}
//@ 8

// Lines 2 to 6 of Algorithm 1: every row begins with what the row of its name had in the last step.
void warm_start(std::vector<Row>& rows, const std::vector<Row>& last, std::vector<Body>& bodies) {
  for (Row& row : rows) {
    for (const Row& old : last)
      if (old.key == row.key) row.impulse = old.impulse;
    apply_impulse(row, row.impulse, bodies);
  }
}

struct World {
  std::vector<Body> bodies;
  std::vector<Row> rows;  // of the last step
  double gravity = 10, dt = 0.02;
  int sweeps = 10;
  //@ 9
  double beta = 0;  // the share of each error that a step removes
  //@ 8
};

void step(World& world) {
  add_gravity(world.bodies, world.gravity, world.dt);
  std::vector<Row> rows = contacts(world.bodies);
  //@ 9
  set_bias(rows, world.beta, world.dt);
  //@ 8
  warm_start(rows, world.rows, world.bodies);
  for (int k = 0; k < world.sweeps; ++k) sweep(rows, world.bodies);
  move_bodies(world.bodies, world.dt);
  world.rows = rows;
}
