#pragma once

#include "model/solver_tolerances.hpp"

namespace talus {

/// What decides which contact points a step has, and what they go on from. h is the mesh size of two bodies, that of
/// the finer one (`PairScale::size`). Of each value it is said what it is measured in, what it decides, where it comes
/// from ("chosen": nothing calls for just this number), and what becomes of results when it is another.
/// docs/contact.md tells of the rules that they belong to.
struct ContactTolerances {
  // Which features touch.

  /// Degrees. Facets whose normals are opposite to within this touch with an area, and the cones of normals in which a
  /// vertex or an edge may touch are wider by it. Chosen: more than faces tilt that lie on each other in practice.
  /// Larger: a tilted face bears over its whole area. Smaller: a block that tips stands on its edge sooner.
  double face_face_angle = 3;
  /// Of h. Nothing that lies deeper behind a facet touches it. Chosen. Larger: features of the far side
  /// are found. Smaller: what a step has pushed in deep is lost.
  double largest_depth = 0.3;
  /// –. Bodies that touched before lie no deeper in each other than a step's reach and this times the deepest of the
  /// last step. Chosen on the Jiweishan slide (docs/contact.md, "Depth"). Larger: what passes beside a body is taken to
  /// be in it, and makes energy. Smaller: what sinks in quickly is lost.
  double depth_per_penetration = 3;
  /// Degrees. Normals within this are along one direction: a third body holds one as this contact would; a contact
  /// found deep goes on from one with such a normal. Chosen. Larger: what is not held may slide past an edge. Smaller:
  /// a block catches on the joint of two slabs that bend.
  double flush_angle = 10;
  /// Of barycentric coordinates, and of the length of an edge. A vertex may miss a facet by this, so that none falls
  /// between two. Chosen, far above rounding. Larger: vertices beside a face touch it. Smaller: gaps in a face.
  double outside_facet = 1e-6;
  /// Of the length of an edge. By this may a crossing lie past an edge's end, so that none falls between two. Rounding.
  /// Larger: one contact is found on two edges. Smaller: on none.
  double past_edge_end = 1e-9;
  /// rad. Edges that are less convex are no edges: what crosses such a one in its middle goes in by less than a quarter
  /// of this times its length: a fifth of the penetration that dynamic stages allow (2.5e-4 h). Larger: bodies go
  /// deeper over bent faces. Smaller: more edges of the mesh are looked at.
  double convex_edge_angle = 2e-4;
  /// – (sin²). Edges at a smaller angle (0.18°) are parallel: the direction across both is hardly defined. Chosen.
  /// Larger: more contacts between edges have the normal between their cores. Smaller: normals of rounding.
  double parallel_edges = 1e-5;

  // How near to an edge, or to each other, features are in one place.

  /// Of h. Features of two bodies that are nearer are in one place; faces that lie deeper in each other than half of it
  /// do so for certain. Chosen, below the 2.5e-4 h that bodies may penetrate in dynamic stages. Larger: what lies on a
  /// face beside its edge is not held. Smaller: blocks catch on flush joints.
  double least_edge_tolerance = 1e-4;
  /// Of h. … and none that are farther. Chosen. Larger and smaller: as above, where bodies lie deep in each other.
  double most_edge_tolerance = 1e-2;
  /// –. Between both it is this times the deepest of the last step: so wide is what overlaps where one body has sunk
  /// in. Chosen, as 1 is the least that square edges need. Larger and smaller: as above.
  double edge_tolerance_per_penetration = 3;
  /// – (fraction). Of two depths one that is no more than this of the other was the way in. Chosen. Larger: what came
  /// past one face of a sharp edge is taken to have come past the other. Smaller: sharp edges catch on each other.
  double clearly_shallower = 0.5;
  /// Of h. Two contacts that are nearer and have one normal are one. Chosen. Larger: contacts of short edges are lost.
  /// Smaller: one place has two springs.
  double same_place = 1e-3;
  /// –. A facet that ends at a sharp edge in a node counts as beside that edge up to this times farther. Chosen.
  /// Larger: strips beside an edge are no contact. Smaller: slivers there catch.
  double beside_edge_at_node = 3;
  /// – (cosine). Sharp edges of two bodies that look out of their faces in directions less alike than this are
  /// opposite, and a strip between them is no contact. Chosen: 120°. Nearer to 0: more strips are none. Nearer to −1:
  /// some catch.
  double opposite_edges = -0.5;

  // Overlaps of two faces. These guard against rounding; nothing should hang on them.

  /// Of h². A smaller overlap is none. Rounding. Larger: slivers do not bear. Smaller: normals of nothing.
  double least_overlap_area = 1e-14;
  /// Of the shorter side there. A corner of an overlap that is nearer to a vertex is that vertex's, and so is its
  /// history. Chosen. Larger: corners change names early. Smaller: two corners beside each vertex.
  double at_vertex = 1e-3;
  /// rad. Facets that are tilted less are parallel. Rounding. Larger: halfway normals push sideways. Smaller: which
  /// normal is taken hangs on rounding.
  double noticeable_tilt = 1e-9;
  /// – (fraction). A facet whose area changed by less has not been spread. Rounding. Larger: springs of a body that
  /// deforms get stiffer unseen. Smaller: areas of rigid bodies change by rounding.
  double noticeable_spread = 1e-9;
  /// Of the longest side squared. A facet that is thinner as seen in the common plane has no area. Rounding.
  double least_facet_area = 1e-12;
  /// Of the perimeter. Corners of an overlap that are nearer are one. Rounding.
  double same_corner = 1e-9;
  /// Of the area. What a corner's sector has at least; less is what rounding leaves of a sliver. Rounding.
  double least_sector = 1e-12;
  /// –. A node whose weight in a stencil is less takes no part. Rounding; would else couple nodes for nothing. Larger:
  /// forces act beside where they should. Smaller: a denser matrix.
  double least_stencil_weight = 1e-6;

  // Vertex–vertex and vertex–edge contact, with features rounded by the edge tolerance.

  /// Of the rounding. The core of a needle lies no deeper below its tip. Chosen. Larger: normals of needles turn late.
  /// Smaller: of blunter ones, too.
  double deepest_core = 10;
  /// Of the rounding. Cores that are nearer have no direction between them, and no contact. Chosen. Larger: corners
  /// that meet head-on are lost. Smaller: normals of rounding.
  double least_core_distance = 0.1;
  /// –. Added to the diagonal of the equations for a core, for along an edge every place is as good. Rounding.
  double core_regularization = 1e-9;
  /// Of h. A displacement that is less tells no direction from which a corner came. Rounding. Larger: corners of flush
  /// blocks are held late. Smaller: some are that slide past.
  double noticeable_motion = 1e-7;
  /// – (cosine). Faces of an edge whose normals are less alike (102°) are those of a sharp one, where face–face contact
  /// on both sides does not hold. Chosen. Nearer to 0: vertex–vertex contact replaces it sooner. Nearer to −1: a tip
  /// sinks into an edge.
  double sharp_edge_faces = -0.2;

  // What contacts go on from.

  /// Of h. A contact that lost its features hands on its force over at most this, if on the same two faces or edges …
  /// Chosen: two facets. Larger: forces jump. Smaller: friction is forgotten where a contact passes from facet to
  /// facet.
  double transfer_along_features = 2;
  /// Of h. … and over at most this between others of the same bodies. Chosen: half a facet. As above.
  double transfer_across_features = 0.5;
  /// – (cosine). Contacts whose normals are less alike (78°) do not go on from each other. Chosen. Larger: friction is
  /// forgotten at bends. Smaller: a force turns into one that acts elsewhere.
  double transfer_agreement = 0.2;
  /// – (fraction). Shear force of which the new plane keeps less has no direction there and is forgotten. Rounding.
  double least_turned_shear = 1e-6;
  /// Of its compression. A spring that its gap says to be compressed otherwise, by more than this, than its force says
  /// has its gap measured by other features than before; what the gap changes by then interferes, if a body deforms.
  /// Chosen. Larger: bodies that deform and slide from facet to facet make energy. Smaller: they sink in as they roll.
  double same_compression = 0.1;
  /// Of h. Facets nearer than this when two bodies are seen first are one joint, and bonded if its law says so. Chosen.
  /// Larger: bonds across open joints. Smaller: joints of imprecise geometry have no cohesion.
  double bonded_gap = 1e-3;

  // Normals updated at the end of a step.

  /// Of the mesh size. Contacts that slide by less in a step begin it with the normal of its start. Chosen. Larger:
  /// blocks that turn as they slide make energy. Smaller: more normals are asked for.
  double foreseen_slide = 1e-6;
  /// Of the tolerance of penetration. Contacts that slide by less keep their normal. Chosen. Larger: points go deeper
  /// than they know. Smaller: more normals are asked for.
  double noticeable_slide = 0.1;
  /// Of the tolerance of penetration. A normal is updated if the contact is deeper by it, by more than this. Chosen: it
  /// adds up from step to step. Larger: bodies creep into each other. Smaller: steps converge twice for rounding.
  double noticeable_deepening = 1e-3;

  // The common plane of two facets, in the facet-wise model alone.

  /// – (cosine). A plane's normal may point against the outward side by no more than this. Chosen. Larger: facets part
  /// on their wrong sides. Smaller: planes across thin facets are lost.
  double inward_normal = 0.05;
  /// Of squared lengths. Directions that are shorter are rounding.
  double least_direction = 1e-20;
  /// Of the longest side. Vertices that are nearer to the plane than to this are on it as the closest is. Rounding.
  double on_common_plane = 1e-9;
};

/// All that decides what a run computes beside the project itself. A bench runs hard cases with other values.
struct Tolerances {
  ContactTolerances contact;
  SolverTolerances solver;
};

}  // namespace talus
