// Floor 4. Elimination, body by body.
#include <cairn/solvers/exact/block_factors.hpp>

#include <Eigen/LU>

namespace cairn {

void BlockFactors::begin(int bodies, const List<std::pair<int, int>>& pairs) {
  is_factorized_ = false;
  if (!elimination_.begin(bodies, pairs)) return;
  upper_.resize(elimination_.pairs());
  lower_.resize(elimination_.pairs());
  diagonal_.resize(bodies);
  pair_at_.resize(bodies);
}

void BlockFactors::set_identity(bool is_symmetric) {
  is_symmetric_ = is_symmetric;
  is_factorized_ = false;
  for (Block& block : upper_) block.setZero();
  for (Block& block : lower_) block.setZero();
  for (Block& block : diagonal_) block.setIdentity();
}

void BlockFactors::add(int row_body, int column_body, const Block& more) {
  const int row = elimination_.place(row_body), column = elimination_.place(column_body);
  if (row == column) {
    diagonal_[row] += more;
  } else if (row > column) {
    lower_[elimination_.pair_of(column, row)] += more;
  } else if (!is_symmetric_) {
    upper_[elimination_.pair_of(row, column)] += more;
  }
}

void BlockFactors::factorize() {
  for (int place = 0; place < elimination_.bodies(); ++place) {
    take_out(place);
    scale(place);
  }
  is_factorized_ = true;
}

/// Subtracts from the blocks of a place what those that were eliminated before it have left in them.
void BlockFactors::take_out(int place) {
  for (int pair = elimination_.first(place); pair < elimination_.first(place + 1); ++pair) {
    pair_at_[elimination_.later(pair)] = pair;
  }
  Block& diagonal = diagonal_[place];
  for (const auto& [earlier, joint] : elimination_.earlier(place)) {
    const Block left = lower_[joint], right = upper_[joint];
    diagonal.noalias() -= left * right;
    for (int pair = joint + 1; pair < elimination_.first(earlier + 1); ++pair) {
      const int target = pair_at_[elimination_.later(pair)];
      lower_[target].noalias() -= lower_[pair] * right;
      if (!is_symmetric_) upper_[target].noalias() -= left * upper_[pair];
    }
  }
}

/// What is left of a place's blocks becomes factors.
void BlockFactors::scale(int place) {
  const Block inverse = diagonal_[place].inverse();
  diagonal_[place] = inverse;
  for (int pair = elimination_.first(place); pair < elimination_.first(place + 1); ++pair) {
    const Block unscaled = lower_[pair];
    if (is_symmetric_) upper_[pair] = unscaled.transpose();
    lower_[pair].noalias() = unscaled * inverse;
  }
}

void BlockFactors::solve(Vector<double>& x) const {
  const auto part = [this, &x](int place) { return x.segment<3>(3 * elimination_.body(place)); };
  const int count = elimination_.bodies();
  for (int place = 0; place < count; ++place) {
    const Vec3<double> known = part(place);
    for (int pair = elimination_.first(place); pair < elimination_.first(place + 1); ++pair)
      part(elimination_.later(pair)).noalias() -= lower_[pair] * known;
  }
  // Back through memory as well. L^T of a symmetric matrix has been read just now.
  for (int place = count; place-- > 0;) {
    Vec3<double> rest = part(place);
    if (is_symmetric_) rest = (diagonal_[place] * rest).eval();
    for (int pair = elimination_.first(place + 1); pair-- > elimination_.first(place);) {
      const Vec3<double> later = part(elimination_.later(pair));
      if (is_symmetric_) {
        rest.noalias() -= lower_[pair].transpose() * later;
      } else {
        rest.noalias() -= upper_[pair] * later;
      }
    }
    if (!is_symmetric_) rest = (diagonal_[place] * rest).eval();
    part(place) = rest;
  }
}

std::size_t BlockFactors::memory() const {
  return elimination_.memory() + upper_.bytes() + lower_.bytes() + diagonal_.bytes() + pair_at_.bytes();
}

}  // namespace cairn
