// The same tower without the engine: plain loops, powers of a matrix, and the slowest mode.
#include "lesson.hpp"

#include <Eigen/Dense>

namespace cairn::warm {

namespace {

/// Masses of 1 kg on a line, from the ground up.
struct Line {
  List<double> height = {};    // [m] of each underside above where it began
  List<double> velocity = {};  // [m/s]
  List<double> impulse = {};   // [N s] between a mass and what is below

  double gap(int i) const { return height[i] - (i > 0 ? height[i - 1] : 0.0); }
  double closing(int i) const { return velocity[i] - (i > 0 ? velocity[i - 1] : 0.0); }
  void push(int i, double p) {
    velocity[i] += p;
    if (i > 0) velocity[i - 1] -= p;
  }
};

void sweep_line(Line& line, double dt) {
  for (int i = 0; i < line.impulse.size(); ++i) {
    const double gap = line.gap(i);
    const double bias = gap > 0 ? -gap / dt : 0;                           // room may be used up
    const double corrective = (bias - line.closing(i)) / (i > 0 ? 2 : 1);  // eq (22) times dt
    const double sum = std::max(line.impulse[i] + corrective, 0.0);
    line.push(i, sum - line.impulse[i]);
    line.impulse[i] = sum;
  }
}

/// b of (15) for masses that all fall equally fast is zero but for the ground's contact.
Eigen::MatrixXd tower_matrix(int boxes) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(boxes, boxes);
  for (int i = 0; i < boxes; ++i) {
    A(i, i) = i > 0 ? 2 : 1;
    if (i > 0) A(i, i - 1) = A(i - 1, i) = -1;
  }
  return A;
}

}  // namespace

List<List<double>> loads_by_hand(const StartSettings& settings) {
  const int n = settings.boxes;
  Line line{
      .height = List<double>(n, 0.0), .velocity = List<double>(n, 0.0), .impulse = List<double>(n, 0.0)};
  List<List<double>> loads(1, List<double>(n, 0.0));
  for (int k = 0; k < settings.steps; ++k) {
    for (double& v : line.velocity) v -= gravity * settings.dt;
    for (int i = 0; i < n; ++i) line.push(i, line.impulse[i]);  // the warm start
    for (int sweep = 0; sweep < settings.sweeps; ++sweep) sweep_line(line, settings.dt);
    for (int i = 0; i < n; ++i) line.height[i] += line.velocity[i] * settings.dt;
    List<double>& load = loads.emplace_back();
    for (const double impulse : line.impulse) load.push_back(impulse / settings.dt);
  }
  return loads;
}

/// Let d be what lambda lacks of the answer of its own step. The step leaves J v = A d dt, so the next one's
/// answer is lambda* - d, where lambda* are the weights; from 0 its sweeps leave d' = G^sweeps (d - lambda*).
ColdTheory cold_by_matrix(const StartSettings& settings) {
  const Eigen::Index n = settings.boxes;
  const Eigen::MatrixXd A = tower_matrix(settings.boxes);
  const Eigen::MatrixXd lower = A.triangularView<Eigen::Lower>();
  const Eigen::MatrixXd upper = A - lower;
  const Eigen::MatrixXd G = -lower.triangularView<Eigen::Lower>().solve(upper);
  Eigen::MatrixXd power = Eigen::MatrixXd::Identity(n, n);
  for (int sweep = 0; sweep < settings.sweeps; ++sweep) power = (G * power).eval();
  Eigen::VectorXd weight(n);
  for (Eigen::Index i = 0; i < n; ++i) weight(i) = double(n - i) * gravity;

  ColdTheory theory{.loads = {List<double>(n, 0.0)}, .top_velocity = {0}};
  Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
  for (int k = 0; k < settings.steps; ++k) {
    const Eigen::VectorXd next = power * (d - weight);
    const Eigen::VectorXd load = weight + next - d;
    theory.loads.emplace_back(load.begin(), load.end());
    theory.top_velocity.push_back(next(n - 1) * settings.dt);
    d = next;
  }
  return theory;
}

double share_left(int boxes, double sweeps) { return std::pow(std::cos(pi / (2 * boxes)), 2 * sweeps); }

double needed_by_formula(int boxes) {
  return std::log(8 / (pi * pi) / wanted_error) / -std::log(share_left(boxes, 1));
}

double unrest(const List<List<double>>& loads, double weight) {
  double largest = 0;
  for (int k = loads.size() * 3 / 4; k < loads.size(); ++k) {
    largest = std::max(largest, std::abs(loads[k][0] - weight));
  }
  return largest;
}

}  // namespace cairn::warm
