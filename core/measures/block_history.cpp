#include "measures/block_history.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "base/error.hpp"
#include "base/units.hpp"
#include "measures/node_places.hpp"
#include "mesh/tet_mesh.hpp"
#include "results/field.hpp"
#include "results/text_table.hpp"

namespace talus {

namespace {

constexpr std::array quantities = {
    BlockQuantity{"displacement", "Displacement", "m", [](const BlockState& b) { return b.displacement.norm(); }},
    BlockQuantity{"displacement.x", "Displacement x", "m", [](const BlockState& b) { return b.displacement.x(); }},
    BlockQuantity{"displacement.y", "Displacement y", "m", [](const BlockState& b) { return b.displacement.y(); }},
    BlockQuantity{"displacement.z", "Displacement z", "m", [](const BlockState& b) { return b.displacement.z(); }},
    BlockQuantity{"speed", "Speed", "m/s", [](const BlockState& b) { return b.velocity.norm(); }},
    BlockQuantity{"velocity.x", "Velocity x", "m/s", [](const BlockState& b) { return b.velocity.x(); }},
    BlockQuantity{"velocity.y", "Velocity y", "m/s", [](const BlockState& b) { return b.velocity.y(); }},
    BlockQuantity{"velocity.z", "Velocity z", "m/s", [](const BlockState& b) { return b.velocity.z(); }},
    BlockQuantity{"rotation", "Rotation", "°", [](const BlockState& b) { return b.rotation; }},
    BlockQuantity{"kinetic_energy", "Kinetic energy", "J", [](const BlockState& b) { return b.kinetic_energy; }},
    BlockQuantity{"stress", "Largest von Mises stress", "Pa", [](const BlockState& b) { return b.stress; }},
    BlockQuantity{"contact_force", "Contact force", "N", [](const BlockState& b) { return b.contact_force.norm(); }},
    BlockQuantity{"normal_force", "Normal forces, summed", "N", [](const BlockState& b) { return b.normal_force; }},
    BlockQuantity{"shear_force", "Shear forces, summed", "N", [](const BlockState& b) { return b.shear_force; }},
};

/// 6 V, exact for a tetrahedron.
double six_volumes(const TetMesh& mesh, const std::array<int, 4>& tetrahedron) {
  const auto at = [&](int i) -> const Vec3& {
    return mesh.nodes[static_cast<std::size_t>(tetrahedron[static_cast<std::size_t>(i)])];
  };
  return (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0));
}

}  // namespace

std::span<const BlockQuantity> all_block_quantities() { return quantities; }

const BlockQuantity& block_quantity_named(std::string_view name) {
  const auto found = std::ranges::find(quantities, name, &BlockQuantity::name);
  if (found != quantities.end()) return *found;
  std::string names;
  for (const BlockQuantity& quantity : quantities) names += (names.empty() ? "" : ", ") + std::string(quantity.name);
  throw InputError("quantity " + std::string(name), "there is no such quantity of blocks", "choose one of " + names);
}

BlockWatch::BlockWatch(const BlockSystem& system, std::vector<double> densities)
    : system_(system), densities_(std::move(densities)), fit_(system), first_node_(first_nodes(system)) {
  std::size_t next = 0;
  for (const Block& block : system.blocks) {
    first_tetrahedron_.push_back(next);
    next += block.mesh.tetrahedra.size();
  }
}

/// ½ ∫ ρ v² dV with v linear in each tetrahedron: ∫ Nᵢ Nⱼ dV = V (1 + δᵢⱼ) / 20.
double BlockWatch::kinetic_energy(const Block& block, const Vec3* velocity) const {
  const auto material = static_cast<std::size_t>(block.material);
  if (material >= densities_.size()) return std::numeric_limits<double>::quiet_NaN();
  double energy = 0;
  for (const auto& tetrahedron : block.mesh.tetrahedra) {
    Vec3 sum = Vec3::Zero();
    double squares = 0;
    for (const int node : tetrahedron) {
      sum += velocity[node];
      squares += velocity[node].squaredNorm();
    }
    energy += densities_[material] / 240 * six_volumes(block.mesh, tetrahedron) * (sum.squaredNorm() + squares);
  }
  return energy;
}

std::vector<BlockState> BlockWatch::states(const Frame& frame, std::span<const int> blocks) const {
  std::vector<BlockState> states(blocks.size());
  std::map<int, std::size_t> place;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    place[blocks[i]] = i;
    const auto b = static_cast<std::size_t>(blocks[i]);
    const Block& block = system_.blocks[b];
    if (block.mesh.nodes.empty()) continue;
    const std::size_t first = first_node_[b];
    const std::vector<Vec3> moved = places(block, first, frame);
    BlockState& state = states[i];
    state.displacement = fit_.mean(blocks[i], &frame.displacement[first]);
    state.velocity = fit_.mean(blocks[i], &frame.velocity[first]);
    state.rotation =
        degrees(Eigen::AngleAxisd(fit_.pose(blocks[i], block.mesh.nodes.data(), moved.data()).rotation).angle());
    state.kinetic_energy = kinetic_energy(block, &frame.velocity[first]);
    for (std::size_t t = 0; t < block.mesh.tetrahedra.size(); ++t)
      state.stress = std::max(state.stress, von_mises(frame.stress[first_tetrahedron_[b] + t]));
  }
  for (const ContactSample& contact : frame.contacts) {
    const Vec3 on_first = contact.normal_force * contact.normal + contact.shear_force;
    for (const int side : {0, 1}) {
      const auto found = place.find(contact.blocks[side]);
      if (found == place.end()) continue;
      BlockState& state = states[found->second];
      state.contact_force += side == 0 ? on_first : Vec3(-on_first);
      state.normal_force += std::abs(contact.normal_force);
      state.shear_force += contact.shear_force.norm();
    }
  }
  return states;
}

std::vector<double> BlockHistory::values(std::size_t block, const BlockQuantity& quantity) const {
  std::vector<double> result;
  for (const BlockState& state : of_block.at(block)) result.push_back(quantity.of(state));
  return result;
}

BlockHistory block_history(const ResultReader& results, std::vector<int> blocks, std::vector<double> densities,
                           Progress& progress) {
  const BlockWatch watch(results.system(), std::move(densities));
  BlockHistory history;
  history.blocks = std::move(blocks);
  for (const int block : history.blocks)
    history.names.push_back(results.system().blocks.at(static_cast<std::size_t>(block)).name);
  history.times = results.frame_times();
  history.of_block.resize(history.blocks.size());
  for (std::size_t number = 0; number < history.times.size(); ++number) {
    if (progress.cancelled()) throw Cancelled{};
    progress.report(static_cast<double>(number) / static_cast<double>(history.times.size()),
                    "frame " + std::to_string(number + 1) + " of " + std::to_string(history.times.size()));
    const std::vector<BlockState> states = watch.states(results.frame(static_cast<int>(number)), history.blocks);
    for (std::size_t i = 0; i < states.size(); ++i) history.of_block[i].push_back(states[i]);
  }
  return history;
}

std::string history_csv(const BlockHistory& history, std::span<const BlockQuantity> wanted) {
  std::string text = "time [s]";
  std::vector<std::vector<double>> columns{history.times};
  for (std::size_t i = 0; i < history.blocks.size(); ++i)
    for (const BlockQuantity& quantity : wanted) {
      text += ',' +
              csv_field(history.names[i] + '.' + std::string(quantity.name) + " [" + std::string(quantity.unit) + ']');
      columns.push_back(history.values(i, quantity));
    }
  text += '\n';
  for (std::size_t row = 0; row < history.times.size(); ++row) {
    std::vector<double> line;
    for (const std::vector<double>& column : columns) line.push_back(column[row]);
    text += csv_line(line) + '\n';
  }
  return text;
}

}  // namespace talus
