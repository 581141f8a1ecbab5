#include "effects/contact_pass.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>

#include "base/parallel.hpp"

namespace talus {

namespace {

constexpr int points_of_a_part = 256;  // a tenth of a millisecond's work
constexpr int parts_at_once = 32;      // what comes of them stays in the cache until it is added
constexpr int columns_worth_a_thread = 200;

/// Those of the effects that act at a point.
struct Acting {
  std::array<std::size_t, 3> effects{};
  std::size_t count = 0;
  auto begin() const { return effects.begin(); }
  auto end() const { return effects.begin() + static_cast<std::ptrdiff_t>(count); }
};

}  // namespace

void ContactPass::set(std::vector<ContactEffect*> effects) {
  effects_ = std::move(effects);
  parts_.resize(parts_at_once);
  for (Part& part : parts_) part.forces.resize(effects_.size());
}

const Attachments& ContactPass::moves() const { return effects_.front()->links().moves(); }

void ContactPass::divide() {
  const auto most = std::ranges::max_element(effects_, {}, [](const auto* effect) { return effect->points().size(); });
  const std::vector<int>& points = (*most)->points();
  const ContactLinks& links = effects_.front()->links();
  boundaries_.assign(1, 0);
  for (std::size_t next = points_of_a_part; next < points.size(); next += points_of_a_part) {
    int begin = points[next];
    while (begin > boundaries_.back() && links.of_the_same_bodies(begin - 1, begin)) --begin;
    if (begin > boundaries_.back()) boundaries_.push_back(begin);
  }
  boundaries_.push_back(std::numeric_limits<int>::max());
}

template <class Find, class Add>
void ContactPass::each_part(const Find& find, const Add& add) {
  divide();
  const int count = static_cast<int>(boundaries_.size()) - 1;
  for (int first = 0; first < count; first += parts_at_once) {
    const int now = std::min(parts_at_once, count - first);
    const auto find_some = [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        Part& part = parts_[i];
        part.begin = boundaries_[first + i];
        part.end = boundaries_[first + i + 1];
        find(part);
      }
    };
    in_parallel(now, 1, std::ref(find_some));
    add(std::span<const Part>(parts_).first(now));
  }
}

template <class Use>
void ContactPass::each_point(const Part& part, const Use& use) const {
  constexpr int none = std::numeric_limits<int>::max();
  using Cursor = std::pair<std::vector<int>::const_iterator, std::vector<int>::const_iterator>;
  std::array<Cursor, 3> left;
  for (std::size_t k = 0; k < effects_.size(); ++k) {
    const std::vector<int>& points = effects_[k]->points();
    left[k] = {std::ranges::lower_bound(points, part.begin), std::ranges::lower_bound(points, part.end)};
  }
  for (;;) {
    int point = none;
    for (std::size_t k = 0; k < effects_.size(); ++k)
      if (left[k].first != left[k].second) point = std::min(point, *left[k].first);
    if (point == none) return;
    Acting acting;
    for (std::size_t k = 0; k < effects_.size(); ++k) {
      if (left[k].first == left[k].second || *left[k].first != point) continue;
      acting.effects[acting.count++] = k;
      ++left[k].first;
    }
    use(point, acting);
  }
}

void ContactPass::add_gradients(const Increment& d, Arms arms, bool follow, std::span<Eigen::VectorXd> sums) {
  if (effects_.empty()) return;
  const Attachments& moves = this->moves();
  const auto find = [&](Part& part) {
    for (auto& forces : part.forces) forces.clear();
    Attachments::Forces forces(moves, d, arms, part.forces);
    each_point(part, [&](int point, const Acting& acting) {
      const Vec3 u = moves.increment(point, d);
      for (const std::size_t k : acting) {
        if (follow) effects_[k]->follow(point, u);
        const Vec3 gradient = -effects_[k]->force(point, u);
        if (!gradient.isZero(0)) forces.add(point, k, gradient);
      }
    });
  };
  each_part(find, [&](std::span<const Part> parts) {
    for (const Part& part : parts)
      for (std::size_t k = 0; k < effects_.size(); ++k)
        for (const BlockForce& force : part.forces[k]) sums[k].segment<3>(3 * force.dof_block) += force.force;
  });
}

void ContactPass::add_tangents(const Increment& d, Arms arms, SymmetricBlocks& symmetric,
                               UnsymmetricBlocks* unsymmetric) {
  if (effects_.empty()) return;
  const Attachments& moves = this->moves();
  const auto tangent_at = [&](int point, const Acting& acting) {
    const Vec3 u = moves.increment(point, d);
    PointTangent at;
    for (const std::size_t k : acting) effects_[k]->add_tangent(point, u, at);
    return at;
  };
  const auto find = [&](Part& part) {
    part.pairs.clear();
    part.all_meet = true;
    Attachments::PairSums sums(moves, d, unsymmetric != nullptr, part.pairs);
    each_point(part, [&](int point, const Acting& acting) {
      if (moves.meets(point))
        sums.add(point, tangent_at(point, acting));
      else
        part.all_meet = false;
    });
  };
  each_part(find, [&](std::span<const Part> parts) {
    add_pairs(parts, symmetric, unsymmetric);
    for (const Part& part : parts) {
      if (part.all_meet) continue;
      each_point(part, [&](int point, const Acting& acting) {
        if (!moves.meets(point)) moves.add_tangent(point, d, arms, tangent_at(point, acting), &symmetric, unsymmetric);
      });
    }
  });
}

void ContactPass::add_pairs(std::span<const Part> parts, SymmetricBlocks& symmetric,
                            UnsymmetricBlocks* unsymmetric) const {
  const Attachments& moves = this->moves();
  moves.find_slots(symmetric.pattern());
  if (unsymmetric)
    for (const Part& part : parts) moves.make_room(part.pairs, *unsymmetric);
  const auto add_to_columns = [&](int first, int end) {
    for (const Part& part : parts) moves.add(part.pairs, &symmetric, unsymmetric, {first, end});
  };
  in_parallel(symmetric.nodes(), columns_worth_a_thread, std::ref(add_to_columns));
}

}  // namespace talus
