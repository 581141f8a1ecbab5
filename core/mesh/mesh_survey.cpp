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
    const TetMesh& mesh = system.blocks[b].mesh;
    MeshQuality whole;
    double sum = 0;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
      const auto& nodes = mesh.tetrahedra[t];
      const Vec3 &p = mesh.nodes[nodes[0]], &q = mesh.nodes[nodes[1]], &r = mesh.nodes[nodes[2]],
                 &s = mesh.nodes[nodes[3]];
      const double quality = tetrahedron_quality(p, q, r, s);
      const DihedralRange angles = tetrahedron_dihedrals(p, q, r, s);
      ++survey.quality.counts[survey.quality.bin_of(quality)];
      ++survey.dihedral.counts[survey.dihedral.bin_of(angles.smallest)];
      sum += quality;
      whole.worst = std::min(whole.worst, quality);
      whole.smallest_dihedral = std::min(whole.smallest_dihedral, angles.smallest);
      whole.largest_dihedral = std::max(whole.largest_dihedral, angles.largest);
      keep(survey.worst, {static_cast<int>(b), static_cast<int>(t), quality, angles.smallest, (p + q + r + s) / 4},
           most_listed);
    }
    if (!mesh.tetrahedra.empty()) whole.mean = sum / static_cast<double>(mesh.tetrahedra.size());
    survey.blocks.push_back(whole);
  }
  std::sort_heap(survey.worst.begin(), survey.worst.end(), is_worse);
  return survey;
}

}  // namespace talus
