// Floor 7. Jacobi's method through OpenCL.
#include <cairn/device/opencl_jacobi.hpp>

#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>
#include <algorithm>
#include <concepts>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <cairn/device/opencl_kernels.hpp>

namespace cairn {

namespace {

/// As in the kernels, field for field.
template <Scalar Real>
struct DeviceRow {
  Real jacobian_a[3] = {}, jacobian_b[3] = {};
  Real bias = 0, softness = 0, step = 0, lower = 0, upper = 0, friction = 0, disc = 0;
  int a = 0, b = 0, normal_row = 0, second_normal_row = 0, first_extra = 0, extra_count = 0;
};

template <Scalar Real>
struct DeviceTerm {
  Real jacobian[3] = {};
  int body = 0;
};

/// The first device that can compute with Real.
template <Scalar Real>
std::optional<cl::Device> find_device() {
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error&) {
    return std::nullopt;  // a loader without drivers calls that an error
  }
  for (const cl::Platform& platform : platforms) {
    std::vector<cl::Device> devices;
    try {
      platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error&) {
      continue;
    }
    for (const cl::Device& device : devices) {
      const bool knows_double = device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0;
      if (std::same_as<Real, float> || knows_double) return device;
    }
  }
  return std::nullopt;
}

/// A device with kernels for Real.
struct Compiled {
  cl::Device device;
  cl::Context context;
  cl::Program program;
};

template <Scalar Real>
Compiled compile() {
  const std::optional<cl::Device> device = find_device<Real>();
  if (!device) {
    throw std::runtime_error(
        std::same_as<Real, float>
            ? "OpenClJacobi: no OpenCL device; a driver has to be installed, such as pocl-opencl-icd"
            : "OpenClJacobi: no OpenCL device that knows double; a driver such as pocl-opencl-icd does");
  }
  std::string options =
      std::same_as<Real, float> ? "-D REAL=float -D DOT=x+(y+z)" : "-D REAL=double -D DOT=(x+y)+z";
  options += " -cl-std=CL1.2";
  const bool rounds_roots =
      (device->getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
  if (std::same_as<Real, float> && rounds_roots) options += " -cl-fp32-correctly-rounded-divide-sqrt";
  const cl::Context context(*device);
  cl::Program program(context, std::string(jacobi_kernels));
  program.build(options.c_str());
  return {*device, context, program};
}

/// Compiled once in a process.
template <Scalar Real>
const Compiled& compiled() {
  static const Compiled made = compile<Real>();
  return made;
}

template <Scalar Real>
std::vector<DeviceRow<Real>> device_rows(const VelocityProblem<Real>& problem, const PerRow<Real>& step) {
  std::vector<DeviceRow<Real>> rows;
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Bounds<Real>& bounds = row.bounds;
    rows.push_back({.bias = row.bias,
                    .softness = row.softness,
                    .step = step[i],
                    .lower = bounds.lower,
                    .upper = bounds.upper,
                    .friction = bounds.friction,
                    .disc = bounds.disc,
                    .a = row.a.index,
                    .b = row.b.index,
                    .normal_row = bounds.normal_row,
                    .second_normal_row = bounds.second_normal_row,
                    .first_extra = row.first_extra,
                    .extra_count = row.extra_count});
    for (int k = 0; k < 3; ++k) {
      rows.back().jacobian_a[k] = row.jacobian_a[k];
      rows.back().jacobian_b[k] = row.jacobian_b[k];
    }
  }
  return rows;
}

template <Scalar Real>
std::vector<DeviceTerm<Real>> device_terms(const VelocityProblem<Real>& problem) {
  std::vector<DeviceTerm<Real>> terms;
  for (const RowTerm<Real>& term : problem.extra_terms) {
    terms.push_back({{term.jacobian[0], term.jacobian[1], term.jacobian[2]}, term.body.index});
  }
  return terms;
}

/// What acts on each body: its rows in their order, and M^-1 j^T of each.
template <Scalar Real>
struct Gathering {
  std::vector<int> first;  // n + 1: where the entries of a body begin
  std::vector<int> row_of;
  std::vector<Real> share;  // three for each entry
};

template <Scalar Real>
Gathering<Real> gathering(const VelocityProblem<Real>& problem) {
  Gathering<Real> result;
  const auto moves = [&](BodyId body) { return !problem.inverse_mass[body].isZero(Real(0)); };
  const auto place = [](BodyId body) { return static_cast<std::size_t>(body.index); };
  std::vector<int>& first = result.first;
  first.assign(static_cast<std::size_t>(problem.body_count()) + 1, 0);
  for (const ConstraintRow<Real>& row : problem.rows) {
    for_each_term(problem, row,
                  [&](BodyId body, const Vec3<Real>&) { first[place(body) + 1] += moves(body) ? 1 : 0; });
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> next = first;
  result.row_of.resize(static_cast<std::size_t>(first.back()));
  result.share.resize(3 * result.row_of.size());
  for (int i = 0; i < problem.row_count(); ++i) {
    for_each_term(problem, problem.rows[i], [&](BodyId body, const Vec3<Real>& jacobian) {
      if (!moves(body)) return;
      const auto entry = static_cast<std::size_t>(next[place(body)]++);
      result.row_of[entry] = i;
      const Vec3<Real> share = problem.inverse_mass[body].cwiseProduct(jacobian);
      std::copy(share.begin(), share.end(), result.share.begin() + static_cast<std::ptrdiff_t>(3 * entry));
    });
  }
  return result;
}

}  // namespace

/// The problem where the device has it.
template <Scalar Real>
struct OpenClJacobi<Real>::Device {
  cl::Device device = compiled<Real>().device;
  cl::Context context = compiled<Real>().context;
  cl::CommandQueue queue{context, device};
  cl::Kernel update_rows{compiled<Real>().program, "update_rows"};
  cl::Kernel move_bodies{compiled<Real>().program, "move_bodies"};
  cl::Buffer rows, terms, velocity, impulse, next, change, first, row_of, share;
  std::size_t bytes = 0;
  std::size_t row_count = 0, body_count = 0;

  template <typename T>
  cl::Buffer sent(const std::vector<T>& values) {
    const std::size_t size = values.size() * sizeof(T);
    cl::Buffer buffer(context, CL_MEM_READ_WRITE, std::max(size, sizeof(T)));
    if (size > 0) queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, size, values.data());
    bytes += size;
    return buffer;
  }

  void send(const VelocityProblem<Real>& problem, const PerRow<Real>& step) {
    bytes = 0;
    row_count = static_cast<std::size_t>(problem.row_count());
    body_count = static_cast<std::size_t>(problem.body_count());
    rows = sent(device_rows(problem, step));
    terms = sent(device_terms(problem));
    const Gathering<Real> gathered = gathering(problem);
    first = sent(gathered.first);
    row_of = sent(gathered.row_of);
    share = sent(gathered.share);
    std::vector<Real> numbers;
    for (const Vec3<Real>& v : problem.velocity) numbers.insert(numbers.end(), {v[0], v[1], v[2]});
    velocity = sent(numbers);
    impulse = sent(std::vector<Real>(problem.impulse.begin(), problem.impulse.end()));
    next = sent(std::vector<Real>(row_count));
    change = sent(std::vector<Real>(row_count));
    for (const auto& [place, buffer] : {std::pair(0, &rows), {1, &terms}, {2, &velocity}, {5, &change}}) {
      update_rows.setArg(static_cast<cl_uint>(place), *buffer);
    }
    for (const auto& [place, buffer] :
         {std::pair(0, &first), {1, &row_of}, {2, &share}, {3, &change}, {4, &velocity}}) {
      move_bodies.setArg(static_cast<cl_uint>(place), *buffer);
    }
  }

  void sweep() {
    update_rows.setArg(3, impulse);
    update_rows.setArg(4, next);
    queue.enqueueNDRangeKernel(update_rows, cl::NullRange, cl::NDRange(row_count));
    queue.enqueueNDRangeKernel(move_bodies, cl::NullRange, cl::NDRange(body_count));
    std::swap(impulse, next);
  }

  /// Reads impulses and velocities. Returns the largest change of an impulse in the last sweep [N s].
  Real read(VelocityProblem<Real>& problem) {
    std::vector<Real> numbers(3 * body_count), changes(row_count);
    queue.enqueueReadBuffer(velocity, CL_FALSE, 0, numbers.size() * sizeof(Real), numbers.data());
    queue.enqueueReadBuffer(impulse, CL_FALSE, 0, row_count * sizeof(Real), problem.impulse.data());
    queue.enqueueReadBuffer(change, CL_TRUE, 0, row_count * sizeof(Real), changes.data());
    const Real* v = numbers.data();
    for (Vec3<Real>& velocity_of_body : problem.velocity) {
      velocity_of_body = {v[0], v[1], v[2]};
      v += 3;
    }
    Real largest = 0;
    for (const Real x : changes) largest = std::max(largest, std::abs(x));
    return largest;
  }
};

template <Scalar Real>
OpenClJacobi<Real>::OpenClJacobi(const SolverSettings& settings)
    : settings_(settings), host_(settings, Splitting::mass) {
  check(settings, "OpenClJacobi");
  settings_.order = RowOrder::as_written;
  try {
    device_ = std::make_unique<Device>();
  } catch (const cl::Error& error) {
    throw std::runtime_error(std::string("OpenClJacobi: ") + error.what() + " failed, code " +
                             std::to_string(error.err()));
  }
}

template <Scalar Real>
OpenClJacobi<Real>::~OpenClJacobi() = default;

template <Scalar Real>
SolveReport OpenClJacobi<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (problem.row_count() == 0 || (observer != nullptr && observer->watches_rows())) {
    return host_.solve(problem, observer);
  }
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem);
  prepare_jacobi(problem, Real(settings_.relaxation), Splitting::mass, rows_on_body_, step_);
  apply_impulses(problem);
  const bool asked = observer != nullptr || settings_.tolerance > 0 || settings_.patience > 0;
  try {
    device_->send(problem, step_);
    return stopping_.repeat(problem, observer, [&](int number, auto) {
      device_->sweep();
      // A time budget is one of time on the device: a sweep is not done before it can be read.
      const bool read = asked || settings_.time_budget > 0 || number == settings_.iterations;
      return read ? device_->read(problem) : Real(0);
    });
  } catch (const cl::Error& error) {
    throw std::runtime_error(std::string("OpenClJacobi: ") + error.what() + " failed, code " +
                             std::to_string(error.err()));
  }
}

template <Scalar Real>
std::size_t OpenClJacobi<Real>::memory() const {
  return device_->bytes + rows_on_body_.bytes() + step_.bytes();
}

template <Scalar Real>
std::string OpenClJacobi<Real>::device() const {
  return device_->device.template getInfo<CL_DEVICE_NAME>();
}

template <Scalar Real>
bool has_opencl_device() {
  return find_device<Real>().has_value();
}

template class OpenClJacobi<float>;
template class OpenClJacobi<double>;
template bool has_opencl_device<float>();
template bool has_opencl_device<double>();

}  // namespace cairn
