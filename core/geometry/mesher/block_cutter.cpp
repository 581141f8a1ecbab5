#include "geometry/mesher/block_cutter.hpp"

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <tuple>

#include "base/error.hpp"
#include "geometry/mesher/facet.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

/// One plane that acts on one solid: a facet's of the solid as it came, or a joint's.
struct ActivePlane {
  int plane = 0;              ///< index into the table
  int cut = -1;               ///< index of the cut that gave it its joint; −1: none did
  std::vector<Facet> facets;  ///< of the solid, or where a joint's plane passes through it
};

class SolidCutter {
 public:
  SolidCutter(const MesherJob& job, const ImportedModel& model, int solid, PlaneTable& planes)
      : job_(job),
        solid_(job.solids[static_cast<std::size_t>(solid)]),
        imported_(model.solids[static_cast<std::size_t>(solid)]),
        origin_(model.origin),
        solid_index_(solid),
        planes_(planes) {
    constexpr double near = 1e-4;
    reach_ = near * std::min(mesh_size_of(solid_, imported_), imported_.longest_side() / 10);
    for (int tag : faces_of(imported_.volumes)) {
      Facet facet = read_facet(tag);
      if (!facet.plane) {
        flat_ = false;
        continue;
      }
      const int plane = planes_.index_of(*facet.plane, facet.outline);
      facet.plane = planes_[plane];
      active(plane).facets.push_back(std::move(facet));
    }
  }

  /// True when the plane divides the solid or lies on one of its facets.
  bool add(int cut, const Plane& plane);

  std::vector<CutBlock> cut();

 private:
  ActivePlane& active(int plane) {
    const auto known = std::find_if(active_.begin(), active_.end(),
                                    [&](const ActivePlane& candidate) { return candidate.plane == plane; });
    return known != active_.end() ? *known : active_.emplace_back(ActivePlane{plane, -1, {}});
  }
  int active_plane_under(const Plane& plane) const;
  void give_joint(ActivePlane& entry, int cut) const;
  bool may_divide(const Plane& plane) const;
  std::vector<Facet> sections(const Plane& plane) const;
  std::map<int, FacetOrigin> facet_origins(int volume) const;
  CutBlock make_block(int volume) const;
  void check_volumes(const std::vector<CutBlock>& blocks) const;

  const MesherJob& job_;
  const MesherSolid& solid_;
  const ImportedSolid& imported_;
  Vec3 origin_;
  int solid_index_;
  PlaneTable& planes_;
  double reach_ = 0;  ///< m, within which a plane counts as lying on a facet
  bool flat_ = true;  ///< every face of the solid is
  std::vector<ActivePlane> active_;
  gmsh::vectorpair tools_;
};

int SolidCutter::active_plane_under(const Plane& plane) const {
  for (const ActivePlane& entry : active_) {
    for (const Facet& facet : entry.facets) {
      if (lies_on(plane, facet, reach_)) return entry.plane;
    }
  }
  return -1;
}

void SolidCutter::give_joint(ActivePlane& entry, int cut) const {
  const auto& cuts = job_.cuts;
  if (entry.cut >= 0) {
    const MesherCut &first = cuts[static_cast<std::size_t>(entry.cut)], &second = cuts[static_cast<std::size_t>(cut)];
    if (first.joint != second.joint) {
      throw InputError(second.title, "lies on the same plane of solid " + solid_.name + " as " + first.title,
                       "keep one of the two joints there, or limit the cuts with \"solids\"");
    }
    return;
  }
  entry.cut = cut;
}

/// Whether the solid may have rock on both sides; only flat solids are told apart by their corners.
bool SolidCutter::may_divide(const Plane& plane) const {
  double lowest = 1, highest = -1;
  bool first = true;
  const auto take = [&](const Vec3& point) {
    const double distance = plane.distance(point);
    lowest = first ? distance : std::min(lowest, distance);
    highest = first ? distance : std::max(highest, distance);
    first = false;
  };
  if (flat_) {
    for (const ActivePlane& entry : active_) {
      for (const Facet& facet : entry.facets) {
        for (const Vec3& point : facet.outline) take(point);
      }
    }
  } else {
    for (int corner = 0; corner < 8; ++corner) {
      take(imported_.bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
  }
  constexpr double rounding = 1e-9;
  const double tolerance = rounding * imported_.longest_side();
  return lowest < -tolerance && highest > tolerance;
}

int add_square(const Plane& plane, const Vec3& centre, double half_side) {
  const Vec3 middle = centre - plane.distance(centre) * plane.normal;
  const Vec3 u = plane.normal.unitOrthogonal() * half_side, v = plane.normal.cross(u);
  std::array<int, 4> points{}, lines{};
  const std::array<Vec3, 4> corners{middle - u - v, middle + u - v, middle + u + v, middle - u + v};
  for (std::size_t k = 0; k < 4; ++k) points[k] = occ::addPoint(corners[k].x(), corners[k].y(), corners[k].z());
  for (std::size_t k = 0; k < 4; ++k) lines[k] = occ::addLine(points[k], points[(k + 1) % 4]);
  return occ::addPlaneSurface({occ::addCurveLoop({lines.begin(), lines.end()})});
}

/// The parts of the plane inside the solid, left in gmsh's model as faces to cut with. A face larger than the solid
/// would leave dangling pieces behind.
std::vector<Facet> SolidCutter::sections(const Plane& plane) const {
  const int square = add_square(plane, imported_.bounds.center(), imported_.bounds.diagonal().norm());
  gmsh::vectorpair parts, volumes;
  std::vector<gmsh::vectorpair> ancestry;
  for (int tag : imported_.volumes) volumes.emplace_back(3, tag);
  occ::intersect({{2, square}}, volumes, parts, ancestry, -1, true, false);
  occ::synchronize();
  std::vector<Facet> facets;
  for (const auto& [dimension, tag] : parts) {
    if (dimension != 2) continue;
    facets.push_back(read_facet(tag));
    facets.back().plane = plane;
  }
  return facets;
}

bool SolidCutter::add(int cut, const Plane& plane) {
  const int under = active_plane_under(plane);
  const bool merged = under >= 0;
  if (merged) {
    ActivePlane& entry = active(under);
    const bool already_cut = entry.cut >= 0;
    give_joint(entry, cut);
    if (already_cut) return true;
  }
  // A plane on a facet may still divide the rest of a solid that is not convex; along the facet's own plane then.
  const Plane along = merged ? planes_[under] : plane;
  if (!may_divide(along)) return merged;
  std::vector<Facet> found = sections(along);
  if (found.empty()) return merged;
  int index = under;
  if (!merged) {
    std::vector<Vec3> outline;
    for (const Facet& section : found) outline.insert(outline.end(), section.outline.begin(), section.outline.end());
    index = planes_.index_of(plane, outline);
    give_joint(active(index), cut);
  }
  for (Facet& section : found) {
    tools_.emplace_back(2, section.tag);
    active(index).facets.push_back(std::move(section));
  }
  return true;
}

/// By the plane of the solid or of a joint that the face lies on closest.
std::map<int, FacetOrigin> SolidCutter::facet_origins(int volume) const {
  std::map<int, FacetOrigin> origins;
  const double tolerance = reach_;
  for (int tag : faces_of({volume})) {
    const Facet facet = read_facet(tag);
    FacetOrigin origin;
    if (facet.plane) {
      double nearest = tolerance;
      for (const ActivePlane& entry : active_) {
        double farthest = 0;
        for (const Vec3& point : facet.outline) {
          farthest = std::max(farthest, std::abs(planes_[entry.plane].distance(point)));
        }
        if (farthest >= nearest || angle_between(planes_[entry.plane], *facet.plane) > 0.01) continue;
        nearest = farthest;
        origin.plane = entry.plane;
        origin.joint = entry.cut < 0 ? -1 : job_.cuts[static_cast<std::size_t>(entry.cut)].joint;
      }
    }
    origins.emplace(tag, origin);
  }
  return origins;
}

std::string coordinates(const Vec3& point) {
  std::ostringstream text;
  text << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return text.str();
}

CutBlock SolidCutter::make_block(int volume) const {
  const Measure measure = measure_volume(volume);
  if (measure.thickness() < reach_) {
    std::ostringstream problem;
    problem << "the cuts leave a splinter " << measure.thickness() << " m thick around "
            << coordinates(measure.centroid + origin_);
    throw InputError("solid " + solid_.name, problem.str(), "move a cut so that the piece goes or becomes thicker");
  }
  return {solid_index_, volume, measure.volume, measure.centroid, facet_origins(volume)};
}

void SolidCutter::check_volumes(const std::vector<CutBlock>& blocks) const {
  constexpr double allowed = 1e-9;
  double sum = 0;
  for (const CutBlock& block : blocks) sum += block.volume;
  if (std::abs(sum - imported_.volume) <= allowed * imported_.volume) return;
  std::ostringstream problem;
  problem.precision(12);
  problem << "cutting it gave blocks of " << sum << " m³ from " << imported_.volume << " m³";
  throw InputError("solid " + solid_.name, problem.str(), "move cuts that nearly coincide apart or make them one");
}

std::vector<CutBlock> SolidCutter::cut() {
  gmsh::vectorpair pieces, solids;
  for (int tag : imported_.volumes) solids.emplace_back(3, tag);
  if (tools_.empty()) {
    pieces = solids;
  } else {
    std::vector<gmsh::vectorpair> ancestry;
    try {
      occ::fragment(solids, tools_, pieces, ancestry);
    } catch (const std::string& reason) {
      throw InputError("solid " + solid_.name, "could not be cut (" + reason + ")",
                       "move cuts that nearly coincide apart");
    }
    occ::synchronize();
  }
  std::set<int> volumes;
  for (const auto& [dimension, tag] : pieces) {
    if (dimension == 3) volumes.insert(tag);
  }
  std::vector<CutBlock> blocks;
  for (int tag : volumes) blocks.push_back(make_block(tag));
  check_volumes(blocks);
  // Centroids that differ by rounding alone must not decide the order: it would not repeat on another machine.
  const double grain = 1e-6 * imported_.longest_side();
  const auto order = [&](const CutBlock& block) {
    const Vec3 cell = (block.centroid / grain).array().round();
    return std::tuple(cell.x(), cell.y(), cell.z());
  };
  std::sort(blocks.begin(), blocks.end(), [&](const CutBlock& a, const CutBlock& b) { return order(a) < order(b); });
  return blocks;
}

std::vector<Plane> planes_of(const MesherCut& cut, const Vec3& origin) {
  const Vec3 normal = upward_normal(cut.dip, cut.dip_direction);
  std::vector<Plane> planes;
  for (const MesherPlane& drawn : cut.drawn) {
    const Vec3 own = upward_normal(drawn.dip, drawn.dip_direction);
    planes.push_back({own, own.dot(drawn.through - origin)});
  }
  if (!planes.empty()) return planes;
  for (int k = 0; k < cut.count; ++k) {
    planes.push_back({normal, normal.dot(cut.through - origin) + k * cut.spacing});
  }
  return planes;
}

bool acts_on(const MesherCut& cut, int solid) {
  return cut.solids.empty() || std::find(cut.solids.begin(), cut.solids.end(), solid) != cut.solids.end();
}

}  // namespace

double mesh_size_of(const MesherSolid& solid, const ImportedSolid& imported) {
  return solid.mesh_size.value_or(imported.longest_side() / 10);
}

CutModel cut_solids(const MesherJob& job, const ImportedModel& model,
                    const std::function<void(double, std::string_view)>& report) {
  Eigen::AlignedBox3d bounds;
  for (const ImportedSolid& solid : model.solids) bounds.extend(solid.bounds);
  constexpr double rounding = 1e-10;
  CutModel result{PlaneTable(rounding * bounds.diagonal().norm()), {}};
  std::vector<bool> hit(job.cuts.size(), false);
  for (std::size_t s = 0; s < job.solids.size(); ++s) {
    if (!model.solids[s].is_body()) continue;
    const int solid = static_cast<int>(s);
    report(static_cast<double>(s) / static_cast<double>(job.solids.size()), "cutting " + job.solids[s].name);
    SolidCutter cutter(job, model, solid, result.planes);
    for (std::size_t c = 0; c < job.cuts.size(); ++c) {
      if (!acts_on(job.cuts[c], solid)) continue;
      for (const Plane& plane : planes_of(job.cuts[c], model.origin)) {
        if (cutter.add(static_cast<int>(c), plane)) hit[c] = true;
      }
    }
    const std::vector<CutBlock> blocks = cutter.cut();
    result.blocks.insert(result.blocks.end(), blocks.begin(), blocks.end());
  }
  for (std::size_t c = 0; c < job.cuts.size(); ++c) {
    if (!hit[c]) {
      throw InputError(job.cuts[c].title,
                       "misses every solid" + std::string(job.cuts[c].solids.empty() ? "" : " it is limited to"),
                       "move its point \"through\", or remove it");
    }
  }
  return result;
}

}  // namespace talus
