#include "geometry/mesher/solid_cutter.hpp"

#include <gmsh.h>

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "geometry/mesher/solid_size.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

/// Whether a facet comes near a joint that ends, wherever its plane goes on.
bool is_near(const Facet& facet, const ActingJoint& joint, double reach) {
  Eigen::AlignedBox3d box, other;
  for (const Vec3& point : facet.outline) box.extend(point);
  for (const Vec3& point : joint.outline) other.extend(point);
  const Vec3 margin = Vec3::Constant(reach);
  return box.intersects(Eigen::AlignedBox3d(other.min() - margin, other.max() + margin));
}

int add_polygon(const std::vector<Vec3>& corners) {
  std::vector<int> points, lines;
  for (const Vec3& corner : corners) points.push_back(occ::addPoint(corner.x(), corner.y(), corner.z()));
  for (std::size_t k = 0; k < points.size(); ++k)
    lines.push_back(occ::addLine(points[k], points[(k + 1) % points.size()]));
  return occ::addPlaneSurface({occ::addCurveLoop(lines)});
}

std::vector<Vec3> put_onto(const Plane& plane, std::vector<Vec3> points) {
  for (Vec3& point : points) point -= plane.distance(point) * plane.normal;
  return points;
}

}  // namespace

SolidCutter::SolidCutter(const MesherJob& job, const ImportedModel& model, int solid, PlaneTable& planes)
    : job_(job),
      solid_(job.solids[static_cast<std::size_t>(solid)]),
      imported_(model.solids[static_cast<std::size_t>(solid)]),
      solid_index_(solid),
      planes_(planes) {
  reach_ = least_thickness(solid_, imported_);
  for (int tag : faces_of(imported_.volumes)) {
    Facet facet = read_facet(tag);
    if (!facet.plane) {
      flat_ = false;
      continue;
    }
    const int plane = planes_.index_of(*facet.plane, facet.outline);
    facet.plane = planes_[plane];
    active(plane).is_skin = true;
    active(plane).facets.push_back(std::move(facet));
  }
}

int SolidCutter::active_plane_under(const ActingJoint& joint) const {
  for (const ActivePlane& entry : active_) {
    for (const Facet& facet : entry.facets) {
      if (lies_on(joint.plane, facet, reach_) && (!joint.ends() || is_near(facet, joint, reach_))) return entry.plane;
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

/// The parts of the joint inside the solid, on a plane that is its own but for rounding, left in gmsh's model as faces
/// to cut with. A face larger than the solid would leave dangling pieces behind.
std::vector<Facet> SolidCutter::sections(const Plane& plane, const ActingJoint& joint) const {
  const int whole = add_polygon(joint.ends() ? put_onto(plane, joint.outline) : square_around(plane, imported_.bounds));
  Entities parts, volumes;
  std::vector<Entities> ancestry;
  for (int tag : imported_.volumes) volumes.emplace_back(3, tag);
  occ::intersect({{2, whole}}, volumes, parts, ancestry, -1, true, false);
  occ::synchronize();
  std::vector<Facet> facets;
  for (const auto& [dimension, tag] : parts) {
    if (dimension != 2) continue;
    facets.push_back(read_facet(tag));
    facets.back().plane = plane;
  }
  return facets;
}

bool SolidCutter::add(const ActingJoint& joint) {
  const int under = active_plane_under(joint);
  const bool merged = under >= 0;
  if (merged) {
    ActivePlane& entry = active(under);
    const bool already_cut = entry.cut >= 0;
    if (already_cut || !joint.ends()) give_joint(entry, joint.cut);
    if (already_cut) {
      if (joint.ends()) dividing_.emplace(joint.cut, joint.index);
      return true;
    }
  }
  // A plane on a facet may still divide the rest of a solid that is not convex; along the facet's own plane then. A
  // joint that ends on a facet divides the facet.
  const Plane along = merged ? planes_[under] : joint.plane;
  const bool on_facet = merged && joint.ends();
  if (!on_facet && !may_divide(along)) return merged;
  std::vector<Facet> found = sections(along, joint);
  if (found.empty()) return merged && !joint.ends();
  int index = under;
  if (!merged) {
    std::vector<Vec3> outline;
    for (const Facet& section : found) outline.insert(outline.end(), section.outline.begin(), section.outline.end());
    index = planes_.index_of(joint.plane, outline);
    if (!joint.ends()) give_joint(active(index), joint.cut);
  }
  for (Facet& section : found) {
    tools_.push_back({section.tag, joint.cut, joint.index, joint.ends(), active(index).is_skin});
    active(index).facets.push_back(std::move(section));
  }
  return true;
}

/// Index into Project::joints of a face on the plane; −1: none.
int SolidCutter::joint_of(const ActivePlane& entry, int face) const {
  const auto tool = tool_of_face_.find(face);
  const int cut = entry.cut >= 0 || tool == tool_of_face_.end() ? entry.cut : tool->second.cut;
  return cut < 0 ? -1 : job_.cuts[static_cast<std::size_t>(cut)].joint;
}

/// By the plane of the solid or of a joint that the face lies on closest.
CutFacet SolidCutter::cut_facet(int face) const {
  const Facet facet = read_facet(face);
  FacetOrigin origin;
  if (facet.plane) {
    double nearest = reach_;
    for (const ActivePlane& entry : active_) {
      double farthest = 0;
      for (const Vec3& point : facet.outline)
        farthest = std::max(farthest, std::abs(planes_[entry.plane].distance(point)));
      if (farthest >= nearest || angle_between(planes_[entry.plane], *facet.plane) > 0.01) continue;
      nearest = farthest;
      origin.plane = entry.plane;
      origin.joint = joint_of(entry, face);
    }
  }
  return {origin, area_of(face)};
}

std::map<int, CutFacet> SolidCutter::facets_of(int volume) {
  std::map<int, CutFacet> facets;
  for (const int face : faces_of({volume})) {
    auto known = facet_of_face_.find(face);
    if (known == facet_of_face_.end()) known = facet_of_face_.emplace(face, cut_facet(face)).first;
    facets.insert(*known);
  }
  return facets;
}

CutBlock SolidCutter::make_block(int volume) {
  const Bulk bulk = bulk_of_volume(volume);
  return {solid_index_, {volume}, {}, bulk.volume, bulk.centroid, bounds_of_volume(volume), facets_of(volume)};
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

/// Parts of joints that have no rock between them and the next joint would leave their marks on the faces around: a
/// first division tells which they are, and the parts that bound a block are the tools of the second.
void SolidCutter::leave_out_dead_ends(const Entities& solids) {
  Entities whole, pieces, spare;
  for (const Tool& tool : tools_) whole.emplace_back(2, tool.tag);
  std::vector<Entities> ancestry;
  occ::fragment(solids, whole, pieces, ancestry, -1, false, true);
  occ::synchronize();
  std::map<int, int> around_blocks;  // how many have the face: on the skin, or on both sides of a crack, it is one
  std::set<int> kept;
  for (const auto& [dimension, tag] : pieces) {
    if (dimension != 3) continue;
    spare.emplace_back(3, tag);
    for (int face : faces_of({tag})) ++around_blocks[face];
  }
  std::vector<Tool> parts;
  for (std::size_t k = 0; k < tools_.size(); ++k) {
    for (const auto& [dimension, face] : ancestry[solids.size() + k]) {
      const auto known = around_blocks.find(face);
      const bool divides = known != around_blocks.end() && known->second > (tools_[k].on_skin ? 0 : 1);
      if (dimension != 2 || !divides || !kept.insert(face).second) continue;
      parts.push_back(tools_[k]);
      parts.back().tag = face;
    }
  }
  occ::remove(spare, false);
  spare.clear();
  for (const auto& [dimension, tag] : pieces)
    if (dimension == 2 && !kept.contains(tag)) spare.emplace_back(2, tag);
  for (const auto& [face, count] : around_blocks)
    if (!kept.contains(face)) spare.emplace_back(2, face);
  occ::remove(spare, true);
  occ::synchronize();
  tools_ = std::move(parts);
}

/// The pieces of the solids along all joints.
Entities SolidCutter::divided(const Entities& solids) {
  try {
    if (std::any_of(tools_.begin(), tools_.end(), [](const Tool& tool) { return tool.ends; }))
      leave_out_dead_ends(solids);
    if (tools_.empty()) return solids;
    Entities pieces, faces;
    for (const Tool& tool : tools_) faces.emplace_back(2, tool.tag);
    std::vector<Entities> ancestry;
    occ::fragment(solids, faces, pieces, ancestry);
    occ::synchronize();
    for (std::size_t k = 0; k < tools_.size(); ++k)
      for (const auto& [dimension, face] : ancestry[solids.size() + k])
        if (dimension == 2 && tools_[k].ends) tool_of_face_.emplace(face, tools_[k]);
    return pieces;
  } catch (const std::string& reason) {
    throw InputError("solid " + solid_.name, "could not be cut (" + reason + ")",
                     "move cuts that nearly coincide apart");
  }
}

std::vector<CutBlock> SolidCutter::cut() {
  Entities solids;
  for (int tag : imported_.volumes) solids.emplace_back(3, tag);
  const Entities pieces = tools_.empty() ? solids : divided(solids);
  std::set<int> volumes;
  for (const auto& [dimension, tag] : pieces) {
    if (dimension == 3) volumes.insert(tag);
  }
  std::vector<CutBlock> blocks;
  for (int tag : volumes) blocks.push_back(make_block(tag));
  check_volumes(blocks);
  for (const CutBlock& block : blocks)
    for (const auto& [tag, facet] : block.facets)
      if (const auto tool = tool_of_face_.find(tag); tool != tool_of_face_.end())
        dividing_.emplace(tool->second.cut, tool->second.joint);
  sort_by_place(blocks, imported_.longest_side());
  return blocks;
}

}  // namespace talus
