#include "contact/broad/facet_boxes.hpp"

namespace talus {

FacetBoxes::FacetBoxes(const ContactFeatures& features, const Odometers& odometers)
    : features_(features),
      odometers_(odometers),
      boxes_(features.facets.size()),
      refreshed_at_(features.facets.size()),
      trees_(features.facet_begin.size() - 1),
      refitted_at_(trees_.size()) {}

std::span<const Box> FacetBoxes::boxes_of(int body) const {
  const int begin = features_.facet_begin[body], end = features_.facet_begin[body + 1];
  return std::span(boxes_).subspan(begin, end - begin);
}

Box FacetBoxes::measure(int facet, std::span<const Vec3> x) const {
  Box box;
  for (int k : features_.facets[facet].nodes) box.add(x[k]);
  return box;
}

void FacetBoxes::refit(int body, std::span<const Vec3> x) {
  Reading& last = refitted_at_[body];
  const Reading now{odometers_.travelled(body), odometers_.moves(body)};
  if (last.moves == now.moves) return;
  for (int f = features_.facet_begin[body]; f < features_.facet_begin[body + 1]; ++f) boxes_[f] = measure(f, x);
  if (last.moves == never) {
    trees_[body].build(boxes_of(body));
  } else {
    trees_[body].refit(boxes_of(body));
  }
  last = now;
}

double FacetBoxes::farthest_coordinate(int body) const {
  if (refitted_at_[body].moves == never) return 0;
  return trees_[body].box().lower.cwiseAbs().cwiseMax(trees_[body].box().upper.cwiseAbs()).maxCoeff();
}

void FacetBoxes::refresh(int facet, std::span<const Vec3> x) {
  const std::uint64_t moves = odometers_.moves(features_.facets[facet].body);
  refreshed_at_[facet].bring_to(moves, [&] { boxes_[facet] = measure(facet, x); });
}

void FacetBoxes::pairs_within(int a, int b, double distance, std::vector<std::pair<int, int>>& pairs) {
  const std::size_t first = pairs.size();
  trees_[a].pairs_within(trees_[b], distance, boxes_of(a), boxes_of(b), stack_, pairs);
  for (std::size_t i = first; i < pairs.size(); ++i) {
    pairs[i].first += features_.facet_begin[a];
    pairs[i].second += features_.facet_begin[b];
  }
}

}  // namespace talus
