#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

namespace talus {

/// GMRES with right preconditioning (Saad & Schultz 1986; Saad 1993, flexible) for systems that are nearly symmetric.
/// Keeps its vectors from call to call.
class Gmres {
 public:
  using Map = std::function<void(const Eigen::VectorXd& from, Eigen::VectorXd& to)>;

  /// Solves A x = b to |b − A x| ≤ tolerance·|b| in at most `limit` iterations. Returns how many it took; `limit` if
  /// the tolerance was not reached.
  int solve(const Map& apply, const Map& precondition, const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance,
            int limit);

 private:
  std::vector<Eigen::VectorXd> basis_, preconditioned_;
  Eigen::MatrixXd hessenberg_;
  Eigen::VectorXd cosine_, sine_, residual_, work_;
};

}  // namespace talus
