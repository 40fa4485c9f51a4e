// Vector instructions would add in an order that depends on the machine.
#define EIGEN_DONT_VECTORIZE
#include "core/solid/rbf_correction.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <cmath>

namespace slipstick {
namespace {

// Corrections cost this share of their squares; 200 rounds bring what is left below 10^-7.
constexpr double kRegularisation = 1e-4;
constexpr int kRoundsMax = 200;
constexpr double kToleranceOfSolver = 1e-7;

using Matrix = Eigen::SparseMatrix<double>;

struct System {
  Matrix weights;            // a column a function, a row a point, and the regularisation below
  Eigen::VectorXd residual;  // f at the points
};

System system_of(const std::vector<RbfFunction>& functions, const PointIndex& index) {
  const auto points = static_cast<Eigen::Index>(index.points().size());
  const auto unknowns = static_cast<Eigen::Index>(functions.size());
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(points);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(points + unknowns);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    const RbfFunction& f = functions[static_cast<std::size_t>(i)];
    index.for_each_within(f.centre, f.radius, [&](std::uint32_t j, double square) {
      const double weight = wendland(square, f.radius);
      sums[j] += weight;
      values[j] += weight * quadric_at(f.quadric, index.points()[j] - f.centre);
      entries.emplace_back(static_cast<Eigen::Index>(j), i, weight);
    });
  }
  std::vector<Eigen::Triplet<double>> scaled;
  scaled.reserve(entries.size() + functions.size());
  for (const auto& e : entries) {
    if (sums[e.row()] > 0) scaled.emplace_back(e.row(), e.col(), e.value() / sums[e.row()]);
  }
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    scaled.emplace_back(points + i, i, std::sqrt(kRegularisation));
  }
  for (Eigen::Index j = 0; j < points; ++j) {
    if (sums[j] > 0) values[j] /= sums[j];
  }
  System system{Matrix(points + unknowns, unknowns), std::move(values)};
  system.weights.setFromTriplets(scaled.begin(), scaled.end());
  return system;
}

}  // namespace

std::vector<RbfFunction> corrected(std::vector<RbfFunction> functions, const PointIndex& index) {
  const System system = system_of(functions, index);
  Eigen::LeastSquaresConjugateGradient<Matrix> solver;
  solver.setMaxIterations(kRoundsMax);
  solver.setTolerance(kToleranceOfSolver);
  solver.compute(system.weights);
  const Eigen::VectorXd lambda = solver.solve(system.residual);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const double correction = lambda[static_cast<Eigen::Index>(i)];
    if (std::isfinite(correction)) functions[i].quadric[0] -= correction;
  }
  return functions;
}

}  // namespace slipstick
