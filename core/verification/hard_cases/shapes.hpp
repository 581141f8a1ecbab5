#pragma once

#include <functional>
#include <vector>

#include "verification/known_answers/support/scene.hpp"

/// The shapes that hard cases are made of, meshed in the program. Lengths in m.
namespace talus {

/// A convex body by its corners and faces (corner numbers, counter-clockwise seen from outside): every face a fan of
/// triangles, every triangle a tetrahedron with the mean of the corners.
TetMesh convex_mesh(const std::vector<Vec3>& corners, const std::vector<std::vector<int>>& faces);

/// The convex hull of a few corners (each triple is looked at), all of them extreme, meshed as above.
TetMesh hull_mesh(const std::vector<Vec3>& corners);

/// One mesh of several whose faces match: nodes at the same place, to the last bit, become one.
TetMesh welded(const std::vector<TetMesh>& parts);

/// The cells between lines x, y and z that are solid; whole faces of cells may touch, nothing less.
TetMesh grid_mesh(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z,
                  const std::function<bool(int, int, int)>& solid);

/// A pyramid, its base centred on the origin and its tip above.
TetMesh spike(double width, double height);
/// A roof: its base, `width` along x and `length` along y, centred on the origin, its ridge along y.
TetMesh wedge(double width, double length, double height);
TetMesh cube(double side);  ///< about the origin
/// A regular prism with a vertical axis, its base centred on the origin.
TetMesh prism(int sides, double radius, double height);
/// A ring about y whose profile is a square of that thickness, of `sides` straight pieces; `inner`: the radius of its
/// inner corners.
TetMesh ring(double inner, double thickness, int sides);
/// A letter J of square bars of side 1, standing on y = ±0.5: its inside, `width` wide and open above, lies between a
/// stem that rises by `stem` above it and a lip that rises by `lip`, less.
TetMesh hook(double width, double stem, double lip);
/// A box from z = −depth − floor to 0 with a slot along y in its top, about x = 0.
TetMesh slotted_box(double slot_width, double depth, double half_width, double half_length, double floor);
/// The same with a square hole.
TetMesh holed_box(double hole_width, double depth, double half_width, double floor);

/// Turned about the origin, then moved.
TetMesh placed(TetMesh mesh, const Mat3& turn, const Vec3& shift);
TetMesh placed(TetMesh mesh, const Vec3& shift);
/// The turn about an axis [degrees].
Mat3 turn_about(const Vec3& axis, double angle);

/// Half a turn about x.
Mat3 upside_down();

/// Moves a block of the scene, or everything in it: nodes, loads and held points.
void shift_block(CaseScene& scene, const std::string& name, const Vec3& shift);
void shift_scene(CaseScene& scene, const Vec3& shift);

}  // namespace talus
