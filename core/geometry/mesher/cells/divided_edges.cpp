#include "geometry/mesher/cells/divided_edges.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/size_field.hpp"

namespace talus {
namespace {

using Edge = std::pair<int, int>;

/// Shares of the way from one end to the other, such that every piece is as long as the sizes along it say.
std::vector<double> division_of(const Vec3& from, const Vec3& to, const SkinSize& size) {
  constexpr int samples = 64;
  std::vector<double> pieces{0};  // up to each sample: the integral of one over the size
  for (int k = 0; k < samples; ++k) {
    const Vec3 point = from + (k + 0.5) / samples * (to - from);
    pieces.push_back(pieces.back() + (to - from).norm() / samples / size_at(point, size.own, size.refinements));
  }
  constexpr double rounding = 1e-9;
  const int count = static_cast<int>(std::ceil(pieces.back() * (1 - rounding)));
  std::vector<double> shares;
  for (int k = 1; k < count; ++k) {
    const double wanted = pieces.back() * k / count;
    const auto after = std::upper_bound(pieces.begin(), pieces.end(), wanted);
    const double before = *(after - 1);
    shares.push_back((static_cast<double>(after - pieces.begin() - 1) + (wanted - before) / (*after - before)) /
                     samples);
  }
  return shares;
}

class DividedEdges {
 public:
  DividedEdges(SkinVertices& vertices, const SkinSize& size) : vertices_(vertices), size_(size) {}

  /// The vertices between the ends, in order from `from`.
  std::vector<int> between(int from, int to) {
    const Edge edge = std::minmax(from, to);
    const auto [known, fresh] = between_.try_emplace(edge);
    if (fresh) {
      const Vec3 a = vertices_[edge.first], b = vertices_[edge.second];
      for (double share : division_of(a, b, size_)) known->second.push_back(vertices_.add(a + share * (b - a)));
    }
    std::vector<int> ordered = known->second;
    if (from > to) std::reverse(ordered.begin(), ordered.end());
    return ordered;
  }

 private:
  SkinVertices& vertices_;
  const SkinSize& size_;
  std::map<Edge, std::vector<int>> between_;
};

}  // namespace

const Vec3& SkinVertices::operator[](int index) const {
  const auto of_cells = static_cast<int>(complex_.vertices().size());
  return index < of_cells ? complex_.vertex(index) : more_[static_cast<std::size_t>(index - of_cells)];
}

int SkinVertices::add(const Vec3& vertex) {
  more_.push_back(vertex);
  return static_cast<int>(complex_.vertices().size() + more_.size()) - 1;
}

void divide_edges(std::vector<FacetOutline>& outlines, SkinVertices& vertices, const SkinSize& size) {
  DividedEdges divided(vertices, size);
  for (FacetOutline& outline : outlines) {
    std::vector<Edge> shorter;
    for (const auto& [from, to] : outline.edges) {
      int last = from;
      for (int vertex : divided.between(from, to)) shorter.emplace_back(std::exchange(last, vertex), vertex);
      shorter.emplace_back(last, to);
    }
    std::ranges::sort(shorter);
    outline.edges = std::move(shorter);
  }
}

}  // namespace talus
