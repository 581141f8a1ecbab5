#pragma once

#include <string_view>

namespace talus {

/// How much a block may do: nothing; move as one; deform homogeneously too; deform tetrahedron by tetrahedron; or what
/// `BodyChooser` makes of it. The last is a wish: no built block has it.
enum class BodyKind { fixed, rigid, affine, tetrahedra, automatic };

/// The word the project file and the results use.
constexpr std::string_view to_string(BodyKind kind) {
  switch (kind) {
    case BodyKind::fixed:
      return "fixed";
    case BodyKind::rigid:
      return "rigid";
    case BodyKind::affine:
      return "affine";
    case BodyKind::automatic:
      return "auto";
    case BodyKind::tetrahedra:
      break;
  }
  return "tetrahedra";
}

}  // namespace talus
