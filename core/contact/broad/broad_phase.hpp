#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "contact/broad/neighbours.hpp"
#include "contact/contact_settings.hpp"
#include "contact/contact_work.hpp"
#include "contact/reach.hpp"

namespace talus {

/// What two bodies' contact is measured against.
struct PairScale {
  double size;       ///< m, the smaller mesh size; a fixed body does not count
  double stiffness;  ///< Pa/m, κE*/h
};

/// A face of the body with the lower number and one of the other.
struct FacePair {
  int a, b;
};

/// Calls `visit` with the pairs of faces of two bodies each, of pairs that are sorted by bodies.
template <class Visit>
void visit_body_pairs(const ContactFeatures& features, std::span<const FacePair> pairs, const Visit& visit) {
  const auto body = [&](int face) { return features.faces[face].body; };
  for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
    const auto same = [&](const FacePair& p) {
      return body(p.a) == body(pairs[begin].a) && body(p.b) == body(pairs[begin].b);
    };
    while (end < pairs.size() && same(pairs[end])) ++end;
    visit(pairs.subspan(begin, end - begin));
  }
}

/// Finds the pairs of faces whose boxes are near each other. Work follows motion: neighbouring bodies are sought when
/// one has left the box it was given, faces of two bodies when these have gone further than the margin of their last
/// search, and pairs of faces found are looked at only where one may be near by now.
class BroadPhase {
 public:
  /// Counts what it looks at in `work`; this and the features outlive it.
  BroadPhase(const ContactFeatures& features, std::span<const ContactBody> bodies, const ContactSettings& settings,
             ContactWork& work);

  /// Some bodies are held from now on, or no longer.
  void set_bodies(std::span<const ContactBody> bodies);
  /// A body falls asleep or wakes. Scales do not change.
  void set_asleep(int body, bool asleep);

  /// No node of the body moved by more than `displacement` [m] since this was said last. Before find(), everything that
  /// moved must be told of, or …
  void moved(int body, double displacement);
  /// … read off the positions, which costs a look at all nodes of bodies that are not asleep.
  void read_motion(std::span<const Vec3> x);

  /// Pairs of faces whose boxes are within the search distance of their bodies at positions x; sorted by bodies and
  /// then by faces. What is found does not depend on earlier calls. Two fixed bodies have none, nor have two of which
  /// one is asleep and the other asleep or fixed. `nearer`: a lesser distance for two bodies of which more is known
  /// [m]; below 0 for those that are left out.
  std::span<const FacePair> find(std::span<const Vec3> x, const Reach& reach,
                                 const std::function<double(int body_a, int body_b)>& nearer = {});

  /// How far apart the features of two bodies may lie and yet touch: the reach outside, the depth inside.
  double search_distance(int body_a, int body_b, const Reach& reach) const;
  PairScale scale(int body_a, int body_b) const;
  /// As of the scale. [m]
  double size(int body_a, int body_b) const { return std::min(sizes_[body_a], sizes_[body_b]); }

  /// Of a face that find() gave in a pair, when it did.
  const Box& box(int face) const { return faces_.box(face); }

  const Odometers& odometers() const { return odometers_; }

 private:
  /// Two bodies that are neighbours. Whether something is to be done is asked of how far both have gone together, plus
  /// the search distance.
  struct BodyPair {
    int a, b;
    double depth;  // m, the search distance without a reach
    double search_at, filter_at;
    std::vector<FacePair> candidates;  // sorted
    std::vector<int> faces;            // among the candidates
  };
  double gone(const BodyPair& pair) const { return odometers_.travelled(pair.a) + odometers_.travelled(pair.b); }
  bool rests(int body) const { return bodies_[body].fixed || asleep_[body]; }
  void stand(int body);
  void list_neighbours();
  int new_pair(int body_a, int body_b);
  void begin(BodyPair& pair) const;
  double distance_of(const BodyPair& pair, double worthwhile, std::span<const Vec3> x);
  void search(BodyPair& pair, std::span<const Vec3> x, double distance);
  void take_candidates(BodyPair& pair);
  /// Neighbours, as many as have some number of candidates together, and what is near of them.
  struct Part {
    int first, last;  // of due_
    std::vector<FacePair> near;
  };
  struct Due {
    int pair;
    double distance;  // m
  };
  void filter(BodyPair& pair, std::span<const Vec3> x, double distance, std::vector<FacePair>& near);
  void filter_due(std::span<const Vec3> x, const std::function<double(int, int)>& nearer);

  const ContactFeatures& features_;
  std::vector<ContactBody> bodies_;
  std::vector<char> asleep_;
  ContactSettings settings_;
  double largest_size_ = 0;    // m, of bodies that are not fixed
  std::vector<double> sizes_;  // m, a body; infinite if it is fixed

  Odometers odometers_;
  FaceBoxes faces_;
  Neighbours neighbours_;
  std::vector<BodyPair> pairs_;     // in no order, with the lists of former pairs for new ones
  std::vector<int> listed_, free_;  // numbers of pairs_: neighbours in order; unused
  std::vector<std::pair<int, int>> new_, found_;
  std::vector<char> is_taken_;  // a face
  std::vector<Due> due_;        // to be filtered
  std::vector<Part> parts_;
  std::vector<FacePair> near_;
  ContactWork& work_;
};

}  // namespace talus
