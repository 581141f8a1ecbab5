#include "measures/line_probe.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "fields/field_values.hpp"
#include "measures/node_places.hpp"
#include "results/text_table.hpp"

namespace talus {

namespace {

/// The part of a line that lies in a tetrahedron, as shares of the line, and the corners' weights at both ends.
struct Passage {
  double begin = 0, end = 1;
  Eigen::Vector4d at_begin, at_end;
};

/// Weights are linear along the line: none is negative inside. False where the line passes by, or touches only.
bool passes(const std::array<Vec3, 4>& corners, const Vec3& from, const Vec3& to, Passage& passage) {
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = corners[static_cast<std::size_t>(i) + 1] - corners[0];
  Mat3 inverse;
  bool invertible = false;
  edges.computeInverseWithCheck(inverse, invertible, 0.0);
  if (!invertible) return false;
  const auto weights = [&](const Vec3& point) {
    const Vec3 part = inverse * (point - corners[0]);
    return Eigen::Vector4d(1 - part.sum(), part.x(), part.y(), part.z());
  };
  const Eigen::Vector4d start = weights(from), along = weights(to) - start;
  for (int i = 0; i < 4; ++i) {
    if (along[i] == 0) {
      if (start[i] < 0) return false;
      continue;
    }
    const double zero = -start[i] / along[i];
    if (along[i] > 0)
      passage.begin = std::max(passage.begin, zero);
    else
      passage.end = std::min(passage.end, zero);
  }
  constexpr double touching = 1e-12;  // of the line
  if (passage.end - passage.begin <= touching) return false;
  passage.at_begin = start + passage.begin * along;
  passage.at_end = start + passage.end * along;
  return true;
}

/// The line comes near the block at all.
bool comes_near(const std::vector<Vec3>& nodes, const Vec3& from, const Vec3& to) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& node : nodes) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  const Vec3 line_low = from.cwiseMin(to), line_high = from.cwiseMax(to);
  return (line_low.array() <= high.array()).all() && (line_high.array() >= low.array()).all();
}

}  // namespace

LineProbe probe_line(const BlockSystem& system, const Frame& frame, const Field& field, const Vec3& from,
                     const Vec3& to) {
  const double length = (to - from).norm();
  if (!(length > 0) || !std::isfinite(length))
    throw InputError("line", "its ends are one point, or none", "give two different points, x,y,z,x,y,z in m");
  if (field.place() == FieldPlace::wall)
    throw InputError("field " + std::string(field.name), "it has values on the walls of joints alone",
                     "take a field of the rock, as displacement or stress");
  const std::vector<double> field_values = FieldValues(system).of(frame, field);
  LineProbe probe;
  std::size_t first_node = 0, first_tetrahedron = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    const std::vector<Vec3> nodes = places(block, first_node, frame);
    for (std::size_t t = 0; comes_near(nodes, from, to) && t < block.mesh.tetrahedra.size(); ++t) {
      const auto& tetrahedron = block.mesh.tetrahedra[t];
      std::array<Vec3, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = nodes[static_cast<std::size_t>(tetrahedron[i])];
      Passage passage;
      if (!passes(corners, from, to, passage)) continue;
      LineProbe::Piece piece{static_cast<int>(b), length * passage.begin, length * passage.end};
      if (field.place() != FieldPlace::node) {
        const std::size_t place = field.place() == FieldPlace::block ? b : first_tetrahedron + t;
        piece.value_at_begin = piece.value_at_end = field_values[place];
      } else {
        for (int i = 0; i < 4; ++i) {
          const double value =
              field_values[first_node + static_cast<std::size_t>(tetrahedron[static_cast<std::size_t>(i)])];
          piece.value_at_begin += passage.at_begin[i] * value;
          piece.value_at_end += passage.at_end[i] * value;
        }
      }
      probe.pieces.push_back(piece);
    }
    first_node += nodes.size();
    first_tetrahedron += block.mesh.tetrahedra.size();
  }
  std::ranges::stable_sort(probe.pieces, {}, [](const LineProbe::Piece& piece) { return piece.begin + piece.end; });
  return probe;
}

LineProbe::Curve LineProbe::curve() const {
  Curve curve;
  for (const Piece& piece : pieces) {
    const double gap = 1e-9 * pieces.back().end;
    if (!curve.along.empty() && piece.begin > curve.along.back() + gap) {
      curve.along.push_back((curve.along.back() + piece.begin) / 2);
      curve.values.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    curve.along.insert(curve.along.end(), {piece.begin, piece.end});
    curve.values.insert(curve.values.end(), {piece.value_at_begin, piece.value_at_end});
  }
  return curve;
}

std::string probe_csv(const LineProbe& probe, const BlockSystem& system, const Field& field, const Vec3& from,
                      const Vec3& to) {
  std::string text =
      "distance [m],x [m],y [m],z [m],block," + std::string(field.name) + " [" + std::string(field.unit) + "]\n";
  const Vec3 direction = (to - from).normalized();
  for (const LineProbe::Piece& piece : probe.pieces)
    for (const auto& [along, value] :
         {std::pair(piece.begin, piece.value_at_begin), std::pair(piece.end, piece.value_at_end)}) {
      const Vec3 place = from + along * direction;
      text += csv_line({along, place.x(), place.y(), place.z()}) + ',' +
              csv_field(system.blocks[static_cast<std::size_t>(piece.block)].name) + ',' + csv_line({value}) + '\n';
    }
  return text;
}

}  // namespace talus
