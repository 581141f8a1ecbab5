#include "geometry/kept_meshes.hpp"

#include <utility>

namespace talus {

std::vector<std::uint64_t> KeptMeshes::keys() const {
  std::vector<std::uint64_t> keys;
  for (const auto& [key, mesh] : meshes_) keys.push_back(key);
  return keys;
}

const MesherBlock& KeptMeshes::mesh_of(MesherBlock answer) {
  if (answer.key == 0) return passing_ = std::move(answer);
  used_.insert(answer.key);
  if (answer.is_known) {
    ++taken_;
    return meshes_.at(answer.key);
  }
  return meshes_[answer.key] = std::move(answer);
}

void KeptMeshes::end_of_build() {
  std::erase_if(meshes_, [this](const auto& one) { return !used_.contains(one.first); });
  used_.clear();
  taken_over_ = std::exchange(taken_, 0);
}

}  // namespace talus
