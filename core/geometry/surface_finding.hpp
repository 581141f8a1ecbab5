#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/vector.hpp"

namespace talus {

/// Something odd in the surface of a solid as its file has it, and whether it was put right.
struct SurfaceFinding {
  enum class Kind {
    hole,
    self_intersection,
    inside_out,
    not_manifold,
    duplicate_vertex,
    degenerate_face,
    tiny_face,
    several_bodies,
    no_data
  };
  Kind kind = Kind::hole;
  int count = 0;              ///< of holes, of pairs of faces that cross, of faces, vertices, bodies or cells
  Vec3 where = Vec3::Zero();  ///< m, in the project's coordinates: the first, or the worst of them
  bool mended = false;

  template <class Stream>
  void fields(Stream& stream) {
    stream(kind, count, where, mended);
  }
  bool operator==(const SurfaceFinding&) const = default;
};

/// Words for one of a kind, and for several.
constexpr std::string_view name_of(SurfaceFinding::Kind kind, bool several) {
  switch (kind) {
    case SurfaceFinding::Kind::hole:
      return several ? "holes" : "hole";
    case SurfaceFinding::Kind::self_intersection:
      return several ? "pairs of faces that cross" : "pair of faces that cross";
    case SurfaceFinding::Kind::inside_out:
      return several ? "faces inside out" : "face inside out";
    case SurfaceFinding::Kind::not_manifold:
      return several ? "vertices where sheets of the surface meet" : "vertex where sheets of the surface meet";
    case SurfaceFinding::Kind::duplicate_vertex:
      return several ? "vertices in the place of another" : "vertex in the place of another";
    case SurfaceFinding::Kind::degenerate_face:
      return several ? "faces without area" : "face without area";
    case SurfaceFinding::Kind::tiny_face:
      return several ? "faces as thin as a hair" : "face as thin as a hair";
    case SurfaceFinding::Kind::several_bodies:
      return several ? "separate bodies" : "body";
    case SurfaceFinding::Kind::no_data:
      break;
  }
  return several ? "cells without a height" : "cell without a height";
}

/// What was done about it, or what the user can do.
constexpr std::string_view remedy_of(SurfaceFinding::Kind kind, bool mended) {
  switch (kind) {
    case SurfaceFinding::Kind::hole:
      return mended ? "filled" : "close the surface where it was made, and export it again";
    case SurfaceFinding::Kind::self_intersection:
      return "unite or part the bodies where they were made, and export them again";
    case SurfaceFinding::Kind::inside_out:
      return "turned";
    case SurfaceFinding::Kind::not_manifold:
      return "taken apart there";
    case SurfaceFinding::Kind::duplicate_vertex:
      return "joined";
    case SurfaceFinding::Kind::degenerate_face:
      return "left out";
    case SurfaceFinding::Kind::tiny_face:
      return mended ? "left out" : "kept: it may hinder meshing there";
    case SurfaceFinding::Kind::several_bodies:
      return "each is a block of its own";
    case SurfaceFinding::Kind::no_data:
      break;
  }
  return "the surface runs straight between its neighbours there";
}

/// Whether rock cannot be made of a surface with such a finding.
constexpr bool is_fatal(const SurfaceFinding& finding) {
  return !finding.mended &&
         (finding.kind == SurfaceFinding::Kind::hole || finding.kind == SurfaceFinding::Kind::self_intersection);
}

/// "3 holes: filled"; the place is not said.
inline std::string text_of(const SurfaceFinding& finding) {
  return std::to_string(finding.count) + " " + std::string(name_of(finding.kind, finding.count != 1)) + ": " +
         std::string(remedy_of(finding.kind, finding.mended));
}

/// The error of a solid with such a finding.
inline InputError unsound(const std::string& place, const SurfaceFinding& finding) {
  std::ostringstream problem;
  problem << "its surface has " << finding.count << " " << name_of(finding.kind, finding.count != 1) << ", around ("
          << finding.where.x() << ", " << finding.where.y() << ", " << finding.where.z() << ")";
  return {place, problem.str(), std::string(remedy_of(finding.kind, finding.mended))};
}

}  // namespace talus
