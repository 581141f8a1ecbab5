#include "contact/broad/face_boxes.hpp"

namespace talus {

FaceBoxes::FaceBoxes(const ContactFeatures& features, const Odometers& odometers)
    : features_(features),
      odometers_(odometers),
      boxes_(features.faces.size()),
      refreshed_(features.faces.size()),
      trees_(features.face_begin.size() - 1),
      refitted_at_(trees_.size()) {}

std::span<const Box> FaceBoxes::boxes_of(int body) const {
  const int begin = features_.face_begin[body], end = features_.face_begin[body + 1];
  return std::span(boxes_).subspan(begin, end - begin);
}

Box FaceBoxes::measure(int face, std::span<const Vec3> x) const {
  Box box;
  for (int k : features_.outline(face)) box.add(x[k]);
  return box;
}

void FaceBoxes::forget(std::span<const int> bodies) {
  for (const int body : bodies) {
    const int begin = features_.face_begin[body], end = features_.face_begin[body + 1];
    MeasuredOnce::forget(std::span(refreshed_).subspan(begin, end - begin));
  }
}

void FaceBoxes::refit(int body, std::span<const Vec3> x) {
  Reading& last = refitted_at_[body];
  const Reading now{odometers_.travelled(body), odometers_.moves(body)};
  if (last.moves == now.moves) return;
  for (int f = features_.face_begin[body]; f < features_.face_begin[body + 1]; ++f) boxes_[f] = measure(f, x);
  if (last.moves == never) {
    trees_[body].build(boxes_of(body));
  } else {
    trees_[body].refit(boxes_of(body));
  }
  last = now;
}

double FaceBoxes::farthest_coordinate(int body) const {
  if (refitted_at_[body].moves == never) return 0;
  return trees_[body].box().lower.cwiseAbs().cwiseMax(trees_[body].box().upper.cwiseAbs()).maxCoeff();
}

void FaceBoxes::refresh(int face, std::span<const Vec3> x) {
  refreshed_[face].bring_about([&] { boxes_[face] = measure(face, x); });
}

void FaceBoxes::pairs_within(int a, int b, double distance, std::vector<std::pair<int, int>>& pairs) {
  const std::size_t first = pairs.size();
  trees_[a].pairs_within(trees_[b], distance, boxes_of(a), boxes_of(b), stack_, pairs);
  for (std::size_t i = first; i < pairs.size(); ++i) {
    pairs[i].first += features_.face_begin[a];
    pairs[i].second += features_.face_begin[b];
  }
}

}  // namespace talus
