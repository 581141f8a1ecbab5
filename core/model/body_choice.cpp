#include "model/body_choice.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/actions.hpp"
#include "model/number_text.hpp"
#include "model/stage_changes.hpp"

namespace talus {
namespace {

/// Above it a block of 10 m shortens by more than a centimetre: where its faces go then matters to its neighbours, and
/// one strain for the whole block no longer says it well enough.
constexpr double strain_of_a_field = 1e-3;
/// Below it a block of 10 m shortens by less than a tenth of a millimetre: nothing that slides or topples feels it.
constexpr double strain_of_neighbours = 1e-5;

std::string two_digits(double value) {
  if (value == 0) return "0";
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  const double digits = std::round(value / unit);
  return number_text(unit < 1 ? digits / std::round(1 / unit) : digits * unit);
}

void add_point(std::vector<Vec3>& points, const Vec3& point) {
  if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
}

/// Blocks that every stage holds.
std::vector<std::string> blocks_held_throughout(const Project& project) {
  if (project.stages.empty()) return {};
  std::vector<std::string> held = blocks_held_in_stage(project, 0);
  for (int stage = 1; stage < static_cast<int>(project.stages.size()); ++stage) {
    const std::vector<std::string> now = blocks_held_in_stage(project, stage);
    std::erase_if(held, [&](const std::string& name) { return std::find(now.begin(), now.end(), name) == now.end(); });
  }
  return held;
}

}  // namespace

BodyChooser::BodyChooser(const Project& project, const Vec3& extent)
    : weight_of_height_(project.gravity.cwiseAbs().dot(extent)) {
  for_each_constraint(project, [&](const Place&, const Constraint& constraint) {
    if (!constraint.at) wishes_[constraint.block].moved_as_a_whole = true;
  });
  for (const std::string& block : blocks_held_throughout(project)) wishes_[block].held_throughout = true;
  for (const Monitor& monitor : project.monitors) {
    std::string& first = wishes_[monitor.block].stress_monitor;
    if (monitor.stress && first.empty()) first = monitor.name;
  }
  for (const InSituStress& in_situ : project.in_situ) {
    for (const std::string& block : in_situ.blocks) wishes_[block].in_situ_stress = true;
  }
  for (const InitialVelocity& velocity : project.velocities) speed_ = std::max(speed_, velocity.linear.norm());
  count_points(project);
}

void BodyChooser::count_points(const Project& project) {
  for (int stage = 0; stage < static_cast<int>(project.stages.size()); ++stage) {
    const Project present = project_in_stage(project, stage);
    std::map<std::string, std::vector<Vec3>> points;
    for (const Constraint& constraint : present.constraints) {
      if (constraint.at) add_point(points[constraint.block], *constraint.at);
    }
    for (const PointLoad& load : present.loads) add_point(points[load.block], load.at);
    for (const auto& [block, list] : points) {
      wishes_[block].points = std::max(wishes_[block].points, list.size());
    }
  }
}

BodyChoice BodyChooser::choose(const std::string& block, const Material& rock) const {
  const auto found = wishes_.find(block);
  const Wishes wishes = found == wishes_.end() ? Wishes{} : found->second;
  if (wishes.moved_as_a_whole) return {BodyKind::fixed, "a constraint moves it as a whole"};
  if (wishes.held_throughout) return {BodyKind::fixed, "every stage holds it"};
  const BodyKind tetrahedra = BodyKind::tetrahedra;
  if (!wishes.stress_monitor.empty()) return {tetrahedra, "monitor " + wishes.stress_monitor + " asks for its stress"};
  if (wishes.in_situ_stress) return {tetrahedra, "stress in situ is given for it by name"};
  constexpr std::size_t bending = 2;
  if (wishes.points >= bending) {
    return {tetrahedra,
            "it is held or loaded at " + std::to_string(wishes.points) + " points, between which it may bend"};
  }
  return choose_by_strain(rock);
}

BodyChoice BodyChooser::choose_by_strain(const Material& rock) const {
  const double strain = rock.density * weight_of_height_ / rock.young + speed_ * std::sqrt(rock.density / rock.young);
  const std::string load = speed_ == 0 ? "the model's weight strains it by "
                                       : "the model's weight and " + two_digits(speed_) + " m/s strain it by ";
  const std::string by = load + two_digits(strain);
  if (strain > strain_of_a_field) return {BodyKind::tetrahedra, "soft for its load: " + by};
  if (strain > strain_of_neighbours) {
    return {BodyKind::affine, by + ", which its neighbours feel; nobody asks for its stress"};
  }
  return {BodyKind::rigid, "hard rock: " + by + "; nobody asks for its stress"};
}

}  // namespace talus
