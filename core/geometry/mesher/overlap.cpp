#include "geometry/mesher/overlap.hpp"

#include <gmsh.h>

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "geometry/mesher/facet.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

struct Candidate {
  int solid = 0, volume = 0;
  Eigen::AlignedBox3d bounds;
};

std::vector<Candidate> all_volumes(const ImportedModel& model) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < model.solids.size(); ++i) {
    for (int tag : model.solids[i].volumes) {
      Vec3 low, high;
      occ::getBoundingBox(3, tag, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
      candidates.push_back({static_cast<int>(i), tag, {low, high}});
    }
  }
  return candidates;
}

[[noreturn]] void refuse(const MesherSolid& a, const MesherSolid& b, const Measure& shared, const Vec3& origin) {
  const Vec3 where = shared.centroid + origin;
  std::ostringstream problem;
  problem << "overlaps " << (&a == &b ? "itself: two bodies of its file share rock," : "solid " + b.name + " by") << " "
          << shared.volume << " m³ around (" << where.x() << ", " << where.y() << ", " << where.z() << ")";
  throw InputError("solid " + a.name, problem.str(), "move or shape them so that they only touch");
}

}  // namespace

void check_no_overlap(const ImportedModel& model, const std::vector<MesherSolid>& solids) {
  constexpr double rounding = 2e-5;  // of the smaller solid's longest side: what rounded coordinates may cost
  const std::vector<Candidate> candidates = all_volumes(model);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t k = i + 1; k < candidates.size(); ++k) {
      const Candidate &a = candidates[i], &b = candidates[k];
      const double allowed = rounding * std::min(a.bounds.sizes().maxCoeff(), b.bounds.sizes().maxCoeff());
      const Eigen::AlignedBox3d common = a.bounds.intersection(b.bounds);
      if (common.isEmpty() || common.sizes().minCoeff() <= allowed) continue;
      gmsh::vectorpair shared;
      std::vector<gmsh::vectorpair> ancestry;
      occ::intersect({{3, a.volume}}, {{3, b.volume}}, shared, ancestry, -1, false, false);
      occ::synchronize();
      gmsh::vectorpair scratch;
      for (const auto& [dimension, tag] : shared) {
        if (dimension == 3) {
          const Measure measure = measure_volume(tag);
          if (measure.thickness() > allowed) {
            refuse(solids[static_cast<std::size_t>(a.solid)], solids[static_cast<std::size_t>(b.solid)], measure,
                   model.origin);
          }
        }
        // A part that is one of the solids itself keeps that one's tag.
        if (tag != a.volume && tag != b.volume) scratch.emplace_back(dimension, tag);
      }
      occ::remove(scratch, true);
      occ::synchronize();
    }
  }
}

}  // namespace talus
