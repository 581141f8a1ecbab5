#include "contact/contact_memory.hpp"

#include <algorithm>
#include <numeric>

namespace talus {

void ContactMemory::claim(std::span<const FoundPoint> points) {
  auto point = points.begin();
  for (Memo& memo : memos_) {
    while (point != points.end() && point->key < memo.key) ++point;
    memo.claimed = point != points.end() && point->key == memo.key;
  }
}

const ContactMemory::Memo* ContactMemory::recall(const FoundPoint& point, double distance) {
  const auto same = std::lower_bound(memos_.begin(), memos_.end(), point.key,
                                     [](const Memo& m, std::uint64_t key) { return m.key < key; });
  if (same != memos_.end() && same->key == point.key) return &*same;

  const double from = point.position.x() - distance, to = point.position.x() + distance;
  const auto first = std::lower_bound(by_family_.begin(), by_family_.end(), point.family, [&](int m, std::uint64_t f) {
    return memos_[m].family != f ? memos_[m].family < f : memos_[m].position.x() < from;
  });
  Memo* nearest = nullptr;
  double least = distance * distance;
  for (auto it = first; it != by_family_.end() && memos_[*it].family == point.family; ++it) {
    if (memos_[*it].position.x() > to) break;
    Memo& memo = memos_[*it];
    if ((memo.area > 0) != (point.area > 0) || (memo.area == 0 && memo.claimed)) continue;
    const double squared = (memo.position - point.position).squaredNorm();
    if (squared < least) least = squared, nearest = &memo;
  }
  if (nearest) nearest->claimed = true;
  return nearest;
}

double ContactMemory::share_of(const Memo& memo, const FoundPoint& point) {
  return memo.area > 0 && point.area > 0 ? point.area / memo.area : 1;
}

Vec3 ContactMemory::shear_on(const Memo& memo, const FoundPoint& point) {
  const double length = memo.shear.norm();
  const Vec3 turned = memo.shear - point.normal * point.normal.dot(memo.shear);
  const double left = turned.norm();
  return left > 1e-6 * length ? Vec3(turned * (share_of(memo, point) * length / left)) : Vec3(Vec3::Zero());
}

bool ContactMemory::ever_broken(std::uint64_t family) const {
  return std::binary_search(broken_.begin(), broken_.end(), family);
}

void ContactMemory::accept(std::span<const ContactPoint> points, std::span<const std::uint64_t> families,
                           std::span<const ContactOutcome> outcomes, const std::function<bool(int body)>& held) {
  std::erase_if(memos_, [&](const Memo& m) { return !held(m.bodies[0]) || !held(m.bodies[1]); });
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& p = points[i];
    const ContactOutcome& o = outcomes[i];
    const bool bonded = p.bonded && !o.broke;
    if (o.broke) broken_.push_back(families[i]);
    if (p.mode == ContactMode::open && !bonded) continue;
    memos_.push_back({p.key,
                      families[i],
                      p.position,
                      o.shear_force,
                      p.area,
                      o.multiplier,
                      p.slip_start + o.slip,
                      p.overlap,
                      p.mode,
                      {p.bodies[0], p.bodies[1]},
                      bonded,
                      false});
  }
  std::sort(memos_.begin(), memos_.end(), [](const Memo& p, const Memo& q) { return p.key < q.key; });
  std::sort(broken_.begin(), broken_.end());
  broken_.erase(std::unique(broken_.begin(), broken_.end()), broken_.end());
  by_family_.resize(memos_.size());
  std::iota(by_family_.begin(), by_family_.end(), 0);
  std::sort(by_family_.begin(), by_family_.end(), [&](int a, int b) {
    const Memo &p = memos_[a], &q = memos_[b];
    if (p.family != q.family) return p.family < q.family;
    return p.position.x() != q.position.x() ? p.position.x() < q.position.x() : a < b;
  });
}

}  // namespace talus
