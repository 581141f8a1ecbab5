#include "geometry/mesher/overlap.hpp"

#include <gmsh.h>

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "geometry/mesher/facet.hpp"
#include "geometry/mesher/flat_bodies.hpp"
#include "geometry/mesher/polyhedron.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

constexpr int none = -1;

struct Candidate {
  int solid = 0;
  int volume = 0;  ///< of gmsh's model; none yet for a convex solid
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
    if (!model.solids[i].convex.faces.empty())
      candidates.push_back({static_cast<int>(i), none, model.solids[i].bounds});
  }
  return candidates;
}

/// Whether the plane of some face of the first leaves the second outside, but for `allowed`.
bool face_parts(const PolyhedronShape& first, const PolyhedronShape& second, double allowed) {
  return std::any_of(first.faces.begin(), first.faces.end(), [&](const std::vector<int>& face) {
    const Plane plane = plane_of(first, face);
    return std::all_of(second.vertices.begin(), second.vertices.end(),
                       [&](const Vec3& vertex) { return plane.distance(vertex) >= -allowed; });
  });
}

/// Of convex solids. Some that only pass each other edge by edge are not told apart.
bool are_apart(const PolyhedronShape& a, const PolyhedronShape& b, double allowed) {
  return !a.faces.empty() && !b.faces.empty() && (face_parts(a, b, allowed) || face_parts(b, a, allowed));
}

/// Convex solids become volumes of gmsh's model when OpenCASCADE is to say.
int tag_of(Candidate& candidate, const ImportedModel& model) {
  if (candidate.volume == none) {
    candidate.volume = add_polyhedron(model.solids[static_cast<std::size_t>(candidate.solid)].convex);
    occ::synchronize();
  }
  return candidate.volume;
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
  std::vector<Candidate> candidates = all_volumes(model);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t k = i + 1; k < candidates.size(); ++k) {
      Candidate &a = candidates[i], &b = candidates[k];
      const double allowed = rounding * std::min(a.bounds.sizes().maxCoeff(), b.bounds.sizes().maxCoeff());
      const Eigen::AlignedBox3d common = a.bounds.intersection(b.bounds);
      if (common.isEmpty() || common.sizes().minCoeff() <= allowed) continue;
      if (are_apart(model.solids[static_cast<std::size_t>(a.solid)].convex,
                    model.solids[static_cast<std::size_t>(b.solid)].convex, allowed))
        continue;
      gmsh::vectorpair shared;
      std::vector<gmsh::vectorpair> ancestry;
      occ::intersect({{3, tag_of(a, model)}}, {{3, tag_of(b, model)}}, shared, ancestry, -1, false, false);
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
