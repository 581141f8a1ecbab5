#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/mesher/acting_joints.hpp"
#include "geometry/mesher/cut_block.hpp"
#include "geometry/mesher/facet.hpp"
#include "geometry/mesher/plane_table.hpp"
#include "geometry/mesher/shape_import.hpp"

namespace talus {

/// Dimensions and tags, as gmsh has them.
using Entities = std::vector<std::pair<int, int>>;

/// One plane that acts on one solid: a facet's of the solid as it came, or a joint's.
struct ActivePlane {
  int plane = 0;              ///< index into the table
  int cut = -1;               ///< index of the cut that gave all of it its joint; −1: none did
  bool is_skin = false;       ///< facets of the solid lie on it
  std::vector<Facet> facets;  ///< of the solid, or where joints pass through it
};

/// A face to cut with, and the joint that it is part of.
struct Tool {
  int tag = 0;             ///< of gmsh's current model
  int cut = 0, joint = 0;  ///< indices of the cut and of the joint in it
  bool ends = false;
  bool on_skin = false;  ///< it lies on a facet of the solid
};

/// Cuts one solid of gmsh's OpenCASCADE model along all joints that act on it, at once.
class SolidCutter {
 public:
  /// `solid`: index into the job's solids. Planes of its facets are put into the table.
  SolidCutter(const MesherJob& job, const ImportedModel& model, int solid, PlaneTable& planes);

  /// True when the joint divides the solid or lies on one of its facets.
  bool add(const ActingJoint& joint);

  /// The pieces, by the centroid's x, then y, then z; each facet has the joint of the plane or of the joint that it
  /// lies on. Throws InputError where cutting fails or loses volume.
  std::vector<CutBlock> cut();

  /// Index of the cut and of the joint in it, of those that end and are part of some block's surface.
  const std::set<std::pair<int, int>>& dividing() const { return dividing_; }

 private:
  ActivePlane& active(int plane) {
    const auto known = std::find_if(active_.begin(), active_.end(),
                                    [&](const ActivePlane& candidate) { return candidate.plane == plane; });
    return known != active_.end() ? *known : active_.emplace_back(ActivePlane{plane, -1, false, {}});
  }
  int active_plane_under(const ActingJoint& joint) const;
  void give_joint(ActivePlane& entry, int cut) const;
  bool may_divide(const Plane& plane) const;
  std::vector<Facet> sections(const Plane& plane, const ActingJoint& joint) const;
  Entities divided(const Entities& solids);
  void leave_out_dead_ends(const Entities& solids);
  int joint_of(const ActivePlane& entry, int face) const;
  CutFacet cut_facet(int face) const;
  std::map<int, CutFacet> facets_of(int volume);
  CutBlock make_block(int volume);
  void check_volumes(const std::vector<CutBlock>& blocks) const;

  const MesherJob& job_;
  const MesherSolid& solid_;
  const ImportedSolid& imported_;
  int solid_index_;
  PlaneTable& planes_;
  double reach_ = 0;  ///< m, within which a plane counts as lying on a facet
  bool flat_ = true;  ///< every face of the solid is
  std::vector<ActivePlane> active_;
  std::vector<Tool> tools_;
  std::map<int, Tool> tool_of_face_;  ///< of those that end, by the tag of the face that is part of it
  std::set<std::pair<int, int>> dividing_;
  std::map<int, CutFacet> facet_of_face_;  ///< of the pieces, by the tag of the face, which two of them may share
};

}  // namespace talus
