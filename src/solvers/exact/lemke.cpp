// Floor 4. Lemke's method on a dictionary of w and z.
#include <cairn/solvers/exact/lemke.hpp>

#include <cmath>
#include <limits>

#include <cairn/math/check.hpp>
#include <cairn/solvers/exact/dictionary.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

// Of numbers about 1. A pivot that is a rounding error ends in a ray where there is none: after some hundred
// pivots roundings have grown to 1e-12 or so. Heavy boxes on light ones make honest pivots of 1 / ratio.
constexpr long double lemke_zero = 1e-9L;
constexpr long double lemke_tie = 1e-12L;

/// Variables are numbered w_0 ..., z_0 ..., and the artificial one last.
class LemkeTable {
 public:
  LemkeTable(const Matrix<long double>& M, const Vector<long double>& q, const Vector<long double>& cover)
      : n_(static_cast<int>(q.size())), table_(n_, n_ + 1) {
    const long double size = q.cwiseAbs().maxCoeff();
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j) table_.row(i)[j] = M(i, j);
      table_.row(i)[n_] = cover(i);
      table_.set_constant(i, q(i) / size);
      basic_.push_back(i);
    }
    for (int j = 0; j <= n_; ++j) nonbasic_.push_back(n_ + j);
    for (int i = 0; i < n_; ++i) place_.push_back(i);
    for (int j = 0; j <= n_; ++j) place_.push_back(j);
    size_ = size;
  }

  LemkeResult follow(const Vector<long double>& cover) {
    LemkeResult result;
    int leaving = leave(first_row(cover), n_);
    const int limit = 100 + 6 * n_;  // paths seldom have more than 3 n
    for (result.pivots = 1; leaving != artificial() && result.pivots < limit; ++result.pivots) {
      const int column = place(leaving < n_ ? leaving + n_ : leaving - n_);
      const int row = blocking_row(column);
      if (row < 0) {
        result.status = LemkeStatus::ray;
        return result;
      }
      leaving = leave(row, column);
    }
    if (leaving == artificial()) result.status = LemkeStatus::solved;
    result.z = Vector<long double>::Zero(n_);
    for (int i = 0; i < n_; ++i) {
      const int variable = basic_[i];
      const bool is_z = variable >= n_ && variable != artificial();
      if (is_z) result.z(variable - n_) = size_ * std::max(table_.constant(i), 0.0L);
    }
    return result;
  }

 private:
  int artificial() const { return 2 * n_; }
  int place(int variable) const { return place_[variable]; }
  bool is_basic(int variable) const {
    const auto at = place(variable);
    return at < basic_.size() && basic_[at] == variable;
  }

  /// Exchanges the variables there and returns the one that has left the basis.
  int leave(int row, int column) {
    table_.exchange(row, column);
    int& left = basic_[row];
    int& entered = nonbasic_[column];
    std::swap(left, entered);
    place_[left] = row;
    place_[entered] = column;
    return entered;
  }

  /// Where the artificial variable must begin for all others to be lexicographically positive.
  int first_row(const Vector<long double>& cover) const {
    int best = 0;
    for (int i = 1; i < n_; ++i) {
      if (table_.constant(i) / cover(i) <= table_.constant(best) / cover(best)) best = i;
    }
    return best;
  }

  /// The share of e^(j + 1) in basic variable i, if q_j were larger by that.
  long double perturbation(int i, int j) const {
    if (is_basic(j)) return place(j) == i ? 1 : 0;
    return -table_.row(i)[place(j)];
  }

  /// Whether row i blocks the column sooner than row k: both do at the same value but for the perturbations.
  bool blocks_sooner(int i, int k, int column) const {
    const long double slope_i = -table_.row(i)[column], slope_k = -table_.row(k)[column];
    for (int j = 0; j < n_; ++j) {
      const long double difference = perturbation(i, j) / slope_i - perturbation(k, j) / slope_k;
      if (std::abs(difference) > lemke_tie) return difference < 0;
    }
    return slope_i > slope_k;
  }

  /// The basic variable that is the first to become 0 as the variable of this column grows; -1: none.
  int blocking_row(int column) const {
    long double least = std::numeric_limits<long double>::infinity();
    for (int i = 0; i < n_; ++i) {
      const long double slope = -table_.row(i)[column];
      if (slope > lemke_zero) least = std::min(least, std::max(table_.constant(i), 0.0L) / slope);
    }
    int best = -1;
    for (int i = 0; i < n_; ++i) {
      const long double slope = -table_.row(i)[column];
      if (!(slope > lemke_zero)) continue;
      if (std::max(table_.constant(i), 0.0L) / slope > least + lemke_tie * (1 + least)) continue;
      if (basic_[i] == artificial()) return i;  // the end of the path
      if (best < 0 || blocks_sooner(i, best, column)) best = i;
    }
    return best;
  }

  int n_ = 0;
  Dictionary table_;
  long double size_ = 1;
  List<int> basic_;
  List<int> nonbasic_;
  List<int> place_;  // of a variable: its row where it is basic, else its column
};

}  // namespace

LemkeResult lemke(const Matrix<long double>& M, const Vector<long double>& q,
                  const Vector<long double>& cover) {
  const bool fits = M.rows() == q.size() && M.cols() == q.size() && cover.size() == q.size();
  require(fits, "lemke", "M", "square, and q and cover of its size", static_cast<double>(M.rows()));
  bool is_positive = true;
  for (Eigen::Index i = 0; i < cover.size(); ++i) is_positive = is_positive && cover(i) > 0;
  require(is_positive, "lemke", "cover", "above 0", "a number that is not");
  LemkeResult result;
  bool has_negative = false;
  for (Eigen::Index i = 0; i < q.size(); ++i) has_negative = has_negative || q(i) < 0;
  if (!has_negative) {
    result.status = LemkeStatus::solved;
    result.z = Vector<long double>::Zero(q.size());
    return result;
  }
  return LemkeTable(M, q, cover).follow(cover);
}

LemkeResult lemke(const Matrix<long double>& M, const Vector<long double>& q) {
  return lemke(M, q, Vector<long double>::Ones(q.size()));
}

}  // namespace cairn
