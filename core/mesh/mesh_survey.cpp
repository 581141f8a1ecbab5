#include "mesh/mesh_survey.hpp"

#include <algorithm>

namespace talus {

namespace {

bool is_worse(const PoorTetrahedron& a, const PoorTetrahedron& b) { return a.quality < b.quality; }

/// Keeps the worst, as a heap whose top is the best of them.
void keep(std::vector<PoorTetrahedron>& worst, const PoorTetrahedron& one, std::size_t most) {
  if (worst.size() == most && !is_worse(one, worst.front())) return;
  if (worst.size() == most) {
    std::pop_heap(worst.begin(), worst.end(), is_worse);
    worst.pop_back();
  }
  worst.push_back(one);
  std::push_heap(worst.begin(), worst.end(), is_worse);
}

}  // namespace

std::size_t Histogram::bin_of(double value) const {
  const double place = (value - low) / width();
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(counts.size() - 1)));
}

MeshSurvey survey_mesh(const BlockSystem& system, Progress& progress, std::size_t most_listed) {
  MeshSurvey survey;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    if (progress.cancelled()) throw Cancelled{};
    if (system.blocks[b].stands_on_corners) {
      survey.blocks.emplace_back();
      continue;
    }
    const TetMesh& mesh = system.blocks[b].mesh;
    survey.blocks.push_back(mesh_quality(mesh, [&](std::size_t t, double quality, const DihedralRange& dihedrals) {
      ++survey.quality.counts[survey.quality.bin_of(quality)];
      ++survey.dihedral.counts[survey.dihedral.bin_of(dihedrals.smallest)];
      Vec3 sum = Vec3::Zero();
      for (const int node : mesh.tetrahedra[t]) sum += mesh.nodes[static_cast<std::size_t>(node)];
      keep(survey.worst, {static_cast<int>(b), static_cast<int>(t), quality, dihedrals.smallest, sum / 4}, most_listed);
    }));
  }
  std::sort_heap(survey.worst.begin(), survey.worst.end(), is_worse);
  return survey;
}

}  // namespace talus
