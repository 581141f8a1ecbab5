#include "contact/contact_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/units.hpp"

namespace talus {
namespace {

// Of the size: how far a contact may have moved on between features …
constexpr double along_features = 2;  // of the same two patches or creases
constexpr double across_features = 0.5;
constexpr double least_agreement = 0.2;  // cosine between normals of two contacts that are one
}  // namespace

void ContactMemory::claim(std::span<const FoundPoint> points) {
  facing_.clear();
  handed_.clear();
  auto point = points.begin();
  for (Memo& memo : memos_) {
    while (point != points.end() && point->key < memo.key) ++point;
    memo.lives = point != points.end() && point->key == memo.key && !point->dropped;
  }
  if (by_key_alone_) return;
  for (const FoundPoint& p : points) {
    if (p.dropped || !(p.area > 0)) continue;
    if (facing_.empty() || facing_.back() != p.family) facing_.push_back(p.family);
  }
  std::sort(facing_.begin(), facing_.end());
  for (std::size_t i = 0; i < memos_.size(); ++i) {
    const Memo& memo = memos_[i];
    if (memo.lives) continue;
    if (memo.area > 0 && std::binary_search(facing_.begin(), facing_.end(), memo.family)) continue;
    if (const FoundPoint* heir = heir_of(memo, points)) handed_.emplace_back(heir->key, static_cast<int>(i));
  }
  std::sort(handed_.begin(), handed_.end());
}

const FoundPoint* ContactMemory::heir_of(const Memo& memo, std::span<const FoundPoint> points) const {
  const FoundPoint* heir = nullptr;
  double least = std::numeric_limits<double>::infinity();
  bool kin = false;
  for (const FoundPoint& p : points) {
    if (p.dropped || p.bodies != memo.bodies || p.normal.dot(memo.normal) < least_agreement) continue;
    // What lives on beside it was a contact of its own, unless it is left over of facets that faced each other.
    const bool same = p.family == memo.family && (memo.area > 0 || !with_key(p.key));
    const double reach = (same ? along_features : across_features) * memo.size;
    const double gap = std::max(0.0, p.gap), squared = (p.position - memo.position).squaredNorm() + gap * gap;
    if (!(squared < reach * reach) || (kin && !same)) continue;
    if (squared < least || (same && !kin)) least = squared, heir = &p, kin = same;
  }
  return heir;
}

const ContactMemory::Memo* ContactMemory::with_key(std::uint64_t key) const {
  const auto same =
      std::lower_bound(memos_.begin(), memos_.end(), key, [](const Memo& m, std::uint64_t k) { return m.key < k; });
  return same != memos_.end() && same->key == key ? &*same : nullptr;
}

const ContactMemory::Memo* ContactMemory::nearest_facing(const FoundPoint& point, double distance) const {
  const double from = point.position.x() - distance, to = point.position.x() + distance;
  const auto first = std::lower_bound(by_family_.begin(), by_family_.end(), point.family, [&](int m, std::uint64_t f) {
    return memos_[m].family != f ? memos_[m].family < f : memos_[m].position.x() < from;
  });
  const Memo* nearest = nullptr;
  double least = distance * distance;
  for (auto it = first; it != by_family_.end() && memos_[*it].family == point.family; ++it) {
    const Memo& memo = memos_[*it];
    if (memo.position.x() > to) break;
    const double squared = (memo.position - point.position).squaredNorm();
    if (memo.area > 0 && squared < least) least = squared, nearest = &memo;
  }
  return nearest;
}

void ContactMemory::add_forces(const Memo& memo, const FoundPoint& point, Recollection& sum) {
  const double share = memo.area > 0 && point.area > 0 ? point.area / memo.area : 1;  // tractions stay
  if (memo.normal == point.normal) {  // to the bit: else rounding would make what sticks at its strength slip some day
    sum.shear += share * memo.shear;
  } else {
    const double length = memo.shear.norm();
    const Vec3 turned = memo.shear - point.normal * point.normal.dot(memo.shear);
    const double left = turned.norm();
    if (left > 1e-6 * length) sum.shear += turned * (share * length / left);
  }
  sum.multiplier += share * memo.multiplier;
  sum.spring_force += share * std::max(0.0, memo.normal_force - memo.multiplier);
}

std::optional<ContactMemory::Recollection> ContactMemory::recall(const FoundPoint& point, double size) const {
  const Memo* own = with_key(point.key);
  if (!own && point.area > 0 && !by_key_alone_) own = nearest_facing(point, along_features * size);
  const auto handed = std::lower_bound(handed_.begin(), handed_.end(), std::pair(point.key, 0));
  const bool has_heritage = handed != handed_.end() && handed->first == point.key;
  if (!own && !has_heritage) return std::nullopt;

  const Memo& first = own ? *own : memos_[handed->second];
  Recollection all{.slip = first.slip,
                   .overlap = first.overlap,
                   .hardening = first.hardening,
                   .mode = first.mode,
                   .bonded = first.bonded,
                   .lost_area = first.area > 0 && point.area == 0};
  if (own) add_forces(*own, point, all);
  for (auto it = handed; it != handed_.end() && it->first == point.key; ++it)
    add_forces(memos_[it->second], point, all);
  return all;
}

double ContactMemory::depth_along(int body, const Vec3& direction, int but) const {
  const double flush = std::cos(radians(flush_angle));
  double deepest = 0;
  const auto look = [&](const Memo& memo) {
    const bool first = memo.bodies[0] == body;
    if (memo.bodies[first ? 1 : 0] == but || !((first ? 1 : -1) * memo.normal.dot(direction) > flush)) return;
    deepest = std::max(deepest, memo.overlap - memo.gap);
  };
  for (int i = of_body_begin_[body]; i < of_body_begin_[body + 1]; ++i) look(memos_[of_body_[i]]);
  resting_.visit(body, look);
  return deepest;
}

double ContactMemory::known_compression(const FoundPoint& point, double stiffness) const {
  const auto contacts_of = [&](int body) {
    return std::span(of_body_).subspan(of_body_begin_[body], of_body_begin_[body + 1] - of_body_begin_[body]);
  };
  const auto first = contacts_of(point.bodies[0]), second = contacts_of(point.bodies[1]);
  double most = 0;
  for (const int m : first.size() < second.size() ? first : second) {
    const Memo& memo = memos_[m];
    if (memo.bodies != point.bodies || !(memo.normal.dot(point.normal) > std::cos(radians(flush_angle)))) continue;
    most = std::max(most, std::min(-memo.gap, (memo.normal_force - memo.multiplier) / stiffness));
  }
  return most;
}

bool ContactMemory::ever_broken(std::uint64_t family) const {
  return std::binary_search(broken_.begin(), broken_.end(), family);
}

void ContactMemory::accept(std::span<const ContactPoint> points, std::span<const std::uint64_t> families,
                           std::span<const ContactOutcome> outcomes) {
  memos_.clear();
  any_bonded_ = false;
  const std::size_t broken_before = broken_.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& p = points[i];
    const ContactOutcome& o = outcomes[i];
    const bool bonded = p.bonded && !o.broke;
    if (o.broke) broken_.push_back(families[i]);
    if (p.mode == ContactMode::open && !bonded) continue;
    any_bonded_ = any_bonded_ || bonded;
    memos_.push_back({.key = p.key,
                      .family = families[i],
                      .bodies = {p.bodies[0], p.bodies[1]},
                      .joint = p.joint,
                      .position = p.position,
                      .normal = p.normal,
                      .shear = o.shear_force,
                      .gap = o.gap,
                      .size = p.size,
                      .area = p.area,
                      .normal_force = o.normal_force,
                      .multiplier = o.multiplier,
                      .slip = p.slip_start + o.slip,
                      .overlap = p.overlap,
                      .hardening = p.hardening,
                      .mode = p.mode,
                      .bonded = bonded,
                      .lives = false});
  }
  if (broken_.size() > broken_before) {
    std::sort(broken_.begin(), broken_.end());
    broken_.erase(std::unique(broken_.begin(), broken_.end()), broken_.end());
  }
  sort_by_family();
  sort_by_body();
}

void ContactMemory::sort_by_family() {
  by_family_.resize(memos_.size());
  std::iota(by_family_.begin(), by_family_.end(), 0);
  std::sort(by_family_.begin(), by_family_.end(), [&](int a, int b) {
    const Memo &p = memos_[a], &q = memos_[b];
    if (p.family != q.family) return p.family < q.family;
    return p.position.x() != q.position.x() ? p.position.x() < q.position.x() : a < b;
  });
}

void ContactMemory::sort_by_body() {
  std::fill(of_body_begin_.begin(), of_body_begin_.end(), 0);
  for (const Memo& memo : memos_)
    for (const int body : memo.bodies) ++of_body_begin_[body];
  std::partial_sum(of_body_begin_.begin(), of_body_begin_.end(), of_body_begin_.begin());  // where each body's end
  of_body_.resize(2 * memos_.size());
  for (int m = static_cast<int>(memos_.size()) - 1; m >= 0; --m)
    for (const int body : memos_[m].bodies) of_body_[--of_body_begin_[body]] = m;
}

void ContactMemory::rest(std::span<const int> changed, const std::function<bool(int)>& rests) {
  const auto awake = [&](int body) { return !rests(body); };
  for (int body : changed) {
    if (awake(body)) {
      resting_.take(
          body, [](int) { return true; }, memos_);
    } else {
      resting_.take(body, awake, memos_);
    }
  }
  std::erase_if(memos_, [&](const Memo& memo) {
    if (awake(memo.bodies[0]) || awake(memo.bodies[1])) return false;
    resting_.put(memo);
    return true;
  });
  std::sort(memos_.begin(), memos_.end(), [](const Memo& p, const Memo& q) { return p.key < q.key; });
  any_bonded_ = std::any_of(memos_.begin(), memos_.end(), [](const Memo& m) { return m.bonded; });
  sort_by_family();
  sort_by_body();
}

}  // namespace talus
