#pragma once

#include <span>
#include <vector>

#include "orientation/attitude.hpp"

/// Which ways of failing the orientations alone allow in a face: Markland's test with its later refinements. Sources:
/// Hoek & Bray (1981), Goodman (1989), Hudson & Harrison (1997, chapter 18), Wyllie & Mah (2004).
namespace talus {

struct KinematicSetting {
  PlaneAttitude face{70, 0};   ///< the slope; dip 0 … 90
  double friction_angle = 30;  ///< degrees, 0 … below 90; of all joints
  double lateral_limit = 20;   ///< degrees to either side of the face's direction, for planes and for toppling
};

/// What one joint can do in the face.
struct PlaneFindings {
  bool planar = false;            ///< daylights, is steeper than φ, and dips within the lateral limits
  bool planar_unlimited = false;  ///< the same without limits at the sides
  bool flexural = false;  ///< layers that dip into the slope steeply enough to slip on each other, within limits
  bool base = false;      ///< base plane of toppling blocks: dips out of the face, not steeper than it, within limits
  bool base_oblique = false;  ///< outside the limits, flatter than φ
};

/// What the wedge, or the column, between two joints can do.
struct IntersectionFindings {
  std::size_t first = 0, second = 0;  ///< numbers of the planes
  LineAttitude line;                  ///< of intersection, plunging
  bool wedge = false;                 ///< the line daylights and is steeper than φ
  bool on_one_plane = false;          ///< a wedge that slides on one of its planes alone
  bool wedge_flat = false;  ///< the line is flatter than φ, but the wedge slides on one plane that is steeper
  bool direct = false;      ///< block toppling: the line dips into the slope, at least 90° − face dip, within limits
  bool direct_oblique = false;  ///< outside the limits, within φ of the vertical
};

/// How many of how many.
struct KinematicCount {
  int count = 0, total = 0;
  double percent() const { return total > 0 ? 100.0 * count / total : 0; }
  bool operator==(const KinematicCount&) const = default;
};

struct KinematicCounts {
  KinematicCount planar, planar_unlimited, flexural, base, base_oblique;   ///< of planes
  KinematicCount wedge, on_one_plane, wedge_flat, direct, direct_oblique;  ///< of intersections
  bool operator==(const KinematicCounts&) const = default;
};

struct KinematicResult {
  std::vector<PlaneFindings> planes;                ///< as the planes are given
  std::vector<IntersectionFindings> intersections;  ///< of all pairs of planes that are not parallel
  KinematicCounts counts;
};

/// Throws std::invalid_argument for a face dip outside 0 … 90, φ outside 0 … 90, a limit outside 0 … 90.
///
/// Planar: the dip vector leaves the rock through the face (d·n > 0), dip > φ, |Δ direction| ≤ limit.
/// Wedge: the same for the line of intersection, without limits at the sides. It slides on plane 1 alone where its
/// steepest descent leads away from plane 2 (d₁·n₂ > 0; Goodman & Shi 1985), else on both.
/// Flexural toppling (Goodman 1980): the normal plunges less than the slip limit, a plane of the face's direction that
/// dips (face dip − φ): its pole lies outside that great circle; pole within limits of the face's direction.
/// Direct toppling (Hudson & Harrison 1997): line within limits of the direction into the slope, plunge ≥ 90° − face
/// dip.
KinematicResult kinematic_check(std::span<const PlaneAttitude> planes, const KinematicSetting& setting);

/// The counts alone: of many planes the pairs, half their number squared, would fill the memory. `pairs`: whether they
/// are looked at; if not, nothing is counted of intersections.
KinematicCounts kinematic_counts(std::span<const PlaneAttitude> planes, const KinematicSetting& setting,
                                 bool pairs = true);

}  // namespace talus
