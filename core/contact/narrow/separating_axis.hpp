#pragma once

#include <array>

#include "contact/narrow/step_geometry.hpp"

namespace talus {

/// How far two bodies are apart along the direction in which they are farthest apart or, where they lie in each other,
/// least deep: that of a face's normal, or the one across two edges where normals of both are opposite (the separating
/// axis theorem; Gottschalk, Lin, Manocha 1996, with arcs on the sphere of normals as by Gregorius 2013). Of bodies
/// that are not convex only those faces count that have the whole body on one side. No contact is deeper than that:
/// along the normals of a vertex, an edge or a face that seems to lie deeper the bodies lie in each other, but along
/// another direction they do not. Directions are looked at one after the other, and no more of them than a question
/// needs.
class SeparatingAxis {
 public:
  /// Positions are others now.
  void begin() { bodies_ = {-1, -1}; }
  /// Whether both bodies keep their shape, and are less deep in each other than a contact with this gap [m] says, by
  /// more than is noticeable.
  bool refutes(const StepGeometry& step, int body_a, int body_b, double gap);
  /// Whether both bodies are convex, or were so before they deformed, and as deep in each other as a contact with this
  /// gap [m] says: no direction parts them by less, or of bodies that deform by noticeably less.
  bool confirms(const StepGeometry& step, int body_a, int body_b, double gap);

 private:
  /// Whether they are apart by more than `enough` along some direction [m].
  bool any_wider(const StepGeometry& step, int body_a, int body_b, double enough);
  void look_along_normals(const StepGeometry& step, int body, int other, double enough);
  void look_across_edges(const StepGeometry& step, double enough);

  std::array<int, 2> bodies_ = {-1, -1};
  double widest_ = 0;      // m, the largest gap of the directions that were looked at
  bool complete_ = false;  // all were
};

}  // namespace talus
