#include "results/field.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/error.hpp"

namespace talus {

namespace {

using Source = Field::Source;
using Measure = Field::Measure;

constexpr std::array fields = {
    Field{"displacement", "Displacement", "m", Source::displacement, Measure::magnitude},
    Field{"displacement.x", "Displacement x", "m", Source::displacement, Measure::component, 0},
    Field{"displacement.y", "Displacement y", "m", Source::displacement, Measure::component, 1},
    Field{"displacement.z", "Displacement z", "m", Source::displacement, Measure::component, 2},
    Field{"velocity", "Velocity", "m/s", Source::velocity, Measure::magnitude},
    Field{"velocity.x", "Velocity x", "m/s", Source::velocity, Measure::component, 0},
    Field{"velocity.y", "Velocity y", "m/s", Source::velocity, Measure::component, 1},
    Field{"velocity.z", "Velocity z", "m/s", Source::velocity, Measure::component, 2},
    Field{"rotation", "Rotation", "°", Source::rotation, Measure::magnitude},
    Field{"stress.von_mises", "Von Mises stress", "Pa", Source::stress, Measure::magnitude},
    Field{"stress.max_principal", "Largest principal stress", "Pa", Source::stress, Measure::max_principal},
    Field{"stress.min_principal", "Smallest principal stress", "Pa", Source::stress, Measure::min_principal},
    Field{"stress.max_shear", "Largest shear stress", "Pa", Source::stress, Measure::max_shear},
    Field{"stress.mean", "Mean stress", "Pa", Source::stress, Measure::mean},
    Field{"stress.xx", "Stress xx", "Pa", Source::stress, Measure::component, 0},
    Field{"stress.yy", "Stress yy", "Pa", Source::stress, Measure::component, 1},
    Field{"stress.zz", "Stress zz", "Pa", Source::stress, Measure::component, 2},
    Field{"stress.xy", "Stress xy", "Pa", Source::stress, Measure::component, 3},
    Field{"stress.yz", "Stress yz", "Pa", Source::stress, Measure::component, 4},
    Field{"stress.zx", "Stress zx", "Pa", Source::stress, Measure::component, 5},
    Field{"stress.safety", "Safety factor of rock", "", Source::stress, Measure::safety},
    Field{"strain.volumetric", "Volumetric strain", "", Source::strain, Measure::volumetric},
    Field{"strain.max_principal", "Largest principal strain", "", Source::strain, Measure::max_principal},
    Field{"strain.min_principal", "Smallest principal strain", "", Source::strain, Measure::min_principal},
    Field{"strain.max_shear", "Largest shear strain", "", Source::strain, Measure::max_shear},
    Field{"body", "Kind of body", "", Source::block, Measure::body},
    Field{"motion", "Motion of blocks", "", Source::block, Measure::motion},
    Field{"asleep", "Blocks that sleep", "", Source::block, Measure::sleep},
    Field{"joint.normal_stress", "Normal stress on joints", "Pa", Source::joint, Measure::normal},
    Field{"joint.shear_stress", "Shear stress on joints", "Pa", Source::joint, Measure::shear},
    Field{"joint.mobilised", "Mobilised shear strength", "", Source::joint, Measure::mobilised},
    Field{"joint.slip", "Slip of joints", "m", Source::joint, Measure::slip},
    Field{"joint.opening", "Opening of joints", "m", Source::joint, Measure::opening},
    Field{"joint.state", "State of joints", "", Source::joint, Measure::state},
    Field{"joint.bond", "Bonds of joints", "", Source::joint, Measure::bond},
    Field{"joint.cohesion", "Cohesion left", "Pa", Source::joint, Measure::cohesion},
};

double value(const Vec3& vector, const Field& field) {
  return field.measure == Measure::magnitude ? vector.norm() : vector[field.index];
}

double value(const Voigt& stress, const Field& field) {
  switch (field.measure) {
    case Measure::magnitude:
      return von_mises(stress);
    case Measure::component:
      return stress[field.index];
    case Measure::mean:
      return stress.head<3>().mean();
    case Measure::max_principal:
      return principal_stresses(stress)[0];
    case Measure::min_principal:
      return principal_stresses(stress)[2];
    default:
      break;
  }
  const Vec3 principal = principal_stresses(stress);
  return (principal[0] - principal[2]) / 2;
}

template <class Tensor>
std::vector<double> values_of(const std::vector<Tensor>& tensors, const Field& field) {
  std::vector<double> result(tensors.size());
  std::transform(tensors.begin(), tensors.end(), result.begin(),
                 [&field](const Tensor& tensor) { return value(tensor, field); });
  return result;
}

}  // namespace

std::span<const Field> all_fields() { return fields; }

const Field& field_named(std::string_view name) {
  const std::string_view sought = name == "stress" ? "stress.von_mises" : name;
  const auto found = std::ranges::find(fields, sought, &Field::name);
  if (found != fields.end()) return *found;
  std::string names;
  for (const Field& field : fields) names += (names.empty() ? "" : ", ") + std::string(field.name);
  throw InputError("field " + std::string(name), "there is no such field", "choose one of " + names);
}

std::vector<double> values(const Frame& frame, const Field& field) {
  switch (field.measure == Measure::safety ? Source::block : field.source) {
    case Source::displacement:
      return values_of(frame.displacement, field);
    case Source::velocity:
      return values_of(frame.velocity, field);
    case Source::stress:
      return values_of(frame.stress, field);
    default:
      break;
  }
  throw std::invalid_argument(std::string(field.name) + " asks for the blocks as well");
}

double von_mises(const Voigt& stress) {
  const double xy = stress[0] - stress[1], yz = stress[1] - stress[2], zx = stress[2] - stress[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * stress.tail<3>().squaredNorm());
}

namespace {

Mat3 tensor_of(const Voigt& stress) {
  Mat3 tensor;
  tensor << stress[0], stress[3], stress[5],  //
      stress[3], stress[1], stress[4],        //
      stress[5], stress[4], stress[2];
  return tensor;
}

}  // namespace

Vec3 principal_stresses(const Voigt& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor_of(stress), Eigen::EigenvaluesOnly);
  return solver.eigenvalues().reverse();
}

PrincipalAxes principal_axes(const Voigt& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor_of(stress));
  return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
}

}  // namespace talus
