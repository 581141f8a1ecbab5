#include "contact/history/contact_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/contact_law.hpp"

namespace talus {

void ContactMemory::transfer(std::span<const FoundPoint> points) {
  transfers_.clear();
  points_ = points;
  own_.assign(points.size(), -1);
  auto point = points.begin();
  bool all_continue = true;
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    History& history = histories_[i];
    while (point != points.end() && point->key < history.key) ++point;
    const bool is_there = point != points.end() && point->key == history.key && !point->is_beside;
    if (is_there) own_[point - points.begin()] = static_cast<int>(i);
    history.continues = is_there && !point->dropped;
    all_continue = all_continue && history.continues;
  }
  if (by_key_alone_) return;
  const auto is_new_face_face = [&](const FoundPoint& p) { return p.area > 0 && own_[&p - points.data()] < 0; };
  if (std::any_of(points.begin(), points.end(), is_new_face_face)) sort_by_family();
  if (all_continue) return;
  list_successors();
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    const History& history = histories_[i];
    if (history.continues) continue;
    if (history.area > 0 && std::binary_search(face_face_families_.begin(), face_face_families_.end(), history.family))
      continue;
    if (const FoundPoint* successor = successor_of(history))
      transfers_.emplace_back(successor->key, static_cast<int>(i));
  }
  std::sort(transfers_.begin(), transfers_.end());
}

void ContactMemory::list_successors() {
  face_face_families_.clear();
  for (const FoundPoint& p : points_) {
    if (p.dropped || !(p.area > 0)) continue;
    if (face_face_families_.empty() || face_face_families_.back() != p.family) face_face_families_.push_back(p.family);
  }
  std::sort(face_face_families_.begin(), face_face_families_.end());
  by_bodies_.sort(points_, [](const FoundPoint& p) { return !p.dropped && !p.is_beside; });
}

const FoundPoint* ContactMemory::successor_of(const History& history) const {
  const FoundPoint* successor = nullptr;
  double least = std::numeric_limits<double>::infinity();
  bool same_features = false;
  for (const auto& [bodies, number] : by_bodies_.of(history.bodies)) {
    const FoundPoint& p = points_[number];
    if (p.normal.dot(history.normal) < tolerances_.transfer_agreement) continue;
    // What continues beside it was a contact of its own, unless it is left over of a face–face contact.
    const bool same = p.family == history.family && (history.area > 0 || !with_key(p.key));
    const double reach =
        (same ? tolerances_.transfer_along_features : tolerances_.transfer_across_features) * history.size;
    const double gap = std::max(0.0, p.gap), squared = (p.position - history.position).squaredNorm() + gap * gap;
    if (!(squared < reach * reach) || (same_features && !same)) continue;
    if (squared < least || (same && !same_features)) least = squared, successor = &p, same_features = same;
  }
  return successor;
}

const ContactMemory::History* ContactMemory::with_key(std::uint64_t key) const {
  const auto same = std::lower_bound(keys_.begin(), keys_.end(), key);
  return same != keys_.end() && *same == key ? &histories_[same - keys_.begin()] : nullptr;
}

const ContactMemory::History* ContactMemory::nearest_face_face(const FoundPoint& point, double distance) const {
  const double from = point.position.x() - distance, to = point.position.x() + distance;
  const auto first = std::lower_bound(by_family_.begin(), by_family_.end(), point.family, [&](int m, std::uint64_t f) {
    return histories_[m].family != f ? histories_[m].family < f : histories_[m].position.x() < from;
  });
  const History* nearest = nullptr;
  double least = distance * distance;
  for (auto it = first; it != by_family_.end() && histories_[*it].family == point.family; ++it) {
    const History& history = histories_[*it];
    if (history.position.x() > to) break;
    const double squared = (history.position - point.position).squaredNorm();
    if (history.area > 0 && squared < least) least = squared, nearest = &history;
  }
  return nearest;
}

void ContactMemory::add_forces(const History& history, const FoundPoint& point, TransferredHistory& sum) const {
  const double ratio = history.area > 0 && point.area > 0 ? point.area / history.area : 1;  // tractions stay
  if (history.normal ==
      point.normal) {  // to the bit: else rounding would make what sticks at its strength slip some day
    sum.shear += ratio * history.shear;
  } else {
    const double length = history.shear.norm();
    const Vec3 in_plane = history.shear - point.normal * point.normal.dot(history.shear);
    const double left = in_plane.norm();
    if (left > tolerances_.least_turned_shear * length) sum.shear += in_plane * (ratio * length / left);
  }
  sum.multiplier += ratio * history.multiplier;
  const double force = std::max(0.0, history.normal_force - history.multiplier);
  sum.spring_force += ratio * force;
  sum.spring_energy += 0.5 * ratio * force * std::max(0.0, -history.gap);
  sum.shear_energy += ratio * history.shear_energy;
}

std::optional<ContactMemory::TransferredHistory> ContactMemory::transferred_to(int number, double size) const {
  const FoundPoint& point = points_[number];
  const History* own = own_[number] >= 0 ? &histories_[own_[number]] : nullptr;
  if (!own && point.area > 0 && !by_key_alone_)
    own = nearest_face_face(point, tolerances_.transfer_along_features * size);
  const auto received = std::lower_bound(transfers_.begin(), transfers_.end(), std::pair(point.key, 0));
  const bool has_transfers = received != transfers_.end() && received->first == point.key;
  if (!own && !has_transfers) return std::nullopt;

  const History& first = own ? *own : histories_[received->second];
  TransferredHistory all{.slip = first.slip,
                         .initial_interference = first.initial_interference,
                         .penalty_scaling = first.penalty_scaling,
                         .mode = first.mode,
                         .bonded = first.bonded,
                         .same_spring = own && own->key == point.key && !(own->area > 0 && point.area == 0)};
  if (own) add_forces(*own, point, all);
  for (auto it = received; it != transfers_.end() && it->first == point.key; ++it)
    add_forces(histories_[it->second], point, all);
  return all;
}

ContactMemory::Hold ContactMemory::hold_of(const History& history, int body) {
  const bool first = history.bodies[0] == body;
  return {first ? history.normal : Vec3(-history.normal), history.initial_interference - history.gap,
          history.bodies[first ? 1 : 0]};
}

double ContactMemory::depth_along(int body, const Vec3& direction, int but) const {
  double deepest = 0;
  const auto look = [&](const Hold& hold) {
    if (hold.depth > deepest && hold.by != but && hold.normal.dot(direction) > flush_cosine_) deepest = hold.depth;
  };
  for (const Hold& hold : holds(body)) look(hold);
  resting_.visit(body, [&](const History& history) { look(hold_of(history, body)); });
  return deepest;
}

std::span<const ContactMemory::Hold> ContactMemory::holds(int body) const {
  return std::span(holds_).subspan(holds_begin_[body], holds_begin_[body + 1] - holds_begin_[body]);
}

/// Those of the one that has fewer.
std::span<const int> ContactMemory::histories_of_either(int body_a, int body_b) const {
  const auto contacts_of = [&](int body) {
    return std::span(of_body_).subspan(of_body_begin_[body], of_body_begin_[body + 1] - of_body_begin_[body]);
  };
  const auto of_a = contacts_of(body_a), of_b = contacts_of(body_b);
  return of_a.size() < of_b.size() ? of_a : of_b;
}

void ContactMemory::visit_between(const std::array<int, 2>& bodies,
                                  const std::function<void(const ContactHistory&)>& look) const {
  for (const int m : histories_of_either(bodies[0], bodies[1]))
    if (histories_[m].bodies == bodies) look(histories_[m]);
}

double ContactMemory::depth_between(int body_a, int body_b) const {
  double deepest = 0;
  const bool a_has_fewer = holds(body_a).size() < holds(body_b).size();
  const int other = a_has_fewer ? body_b : body_a;
  for (const Hold& hold : holds(a_has_fewer ? body_a : body_b))
    if (hold.by == other) deepest = std::max(deepest, hold.depth);
  return deepest;
}

double ContactMemory::known_compression(const FoundPoint& point, double stiffness) const {
  double most = 0;
  for (const int m : histories_of_either(point.bodies[0], point.bodies[1])) {
    const History& history = histories_[m];
    if (history.bodies != point.bodies || !(history.normal.dot(point.normal) > flush_cosine_)) continue;
    most = std::max(most, std::min(-history.gap, (history.normal_force - history.multiplier) / stiffness));
  }
  return most;
}

bool ContactMemory::ever_broken(std::uint64_t family) const {
  return std::binary_search(broken_.begin(), broken_.end(), family);
}

void ContactMemory::accept(const ContactSet& contacts, std::span<const std::uint64_t> families,
                           std::span<const ContactOutcome> outcomes) {
  histories_.clear();
  keys_.clear();
  any_bonded_ = false;
  const std::size_t broken_before = broken_.size();
  for (const int i : contacts.by_key) {
    const ContactPoint& p = contacts.points[i];
    const ContactOutcome& o = outcomes[i];
    const bool bonded = p.bonded && !o.broke;
    if (o.broke) broken_.push_back(families[i]);
    if (p.mode == ContactMode::open && !bonded) continue;
    any_bonded_ = any_bonded_ || bonded;
    keys_.push_back(p.key);
    const double given_by = p.let_go ? std::max(0.0, -o.gap) : 0;  // m, from now on it interferes
    histories_.push_back({.key = p.key,
                          .family = families[i],
                          .bodies = {p.bodies[0], p.bodies[1]},
                          .joint = p.joint,
                          .position = p.position,
                          .normal = p.normal,
                          .shear = o.shear_force,
                          .gap = o.gap + given_by,
                          .size = p.size,
                          .area = p.area,
                          .normal_force = p.let_go ? 0 : o.normal_force,
                          .multiplier = o.multiplier,
                          .spring_energy = spring_energy(p, o),
                          .shear_energy = shear_spring_energy(p, o.shear_force),
                          .slip = p.slip_start + o.slip,
                          .initial_interference = p.initial_interference + given_by,
                          .penalty_scaling = p.penalty_scaling,
                          .friction = p.friction,
                          .cohesion = bonded ? p.cohesion : 0,
                          .mode = p.mode,
                          .bonded = bonded,
                          .broken = p.broken || o.broke,
                          .continues = false});
  }
  if (broken_.size() > broken_before) {
    std::sort(broken_.begin(), broken_.end());
    broken_.erase(std::unique(broken_.begin(), broken_.end()), broken_.end());
  }
  by_family_.clear();
  sort_by_body();
}

void ContactMemory::sort_by_family() {
  if (by_family_.size() == histories_.size()) return;
  by_family_.resize(histories_.size());
  std::iota(by_family_.begin(), by_family_.end(), 0);
  std::sort(by_family_.begin(), by_family_.end(), [&](int a, int b) {
    const History &p = histories_[a], &q = histories_[b];
    if (p.family != q.family) return p.family < q.family;
    return p.position.x() != q.position.x() ? p.position.x() < q.position.x() : a < b;
  });
}

void ContactMemory::sort_by_body() {
  std::fill(of_body_begin_.begin(), of_body_begin_.end(), 0);
  for (const History& history : histories_)
    for (const int body : history.bodies) ++of_body_begin_[body];
  std::partial_sum(of_body_begin_.begin(), of_body_begin_.end(), of_body_begin_.begin());  // where each body's end
  of_body_.resize(2 * histories_.size());
  for (int m = static_cast<int>(histories_.size()) - 1; m >= 0; --m)
    for (const int body : histories_[m].bodies) of_body_[--of_body_begin_[body]] = m;
  list_holds();
}

/// The contacts of a face on another have one normal, to the bit: together they are one hold, if they follow each other
/// closely.
void ContactMemory::list_holds() {
  constexpr std::ptrdiff_t look_back = 8;  // holds: a body may have thousands
  holds_.clear();
  for (int body = 0; body + 1 < static_cast<int>(holds_begin_.size()); ++body) {
    const auto begin = static_cast<std::ptrdiff_t>(holds_.size());
    for (int i = of_body_begin_[body]; i < of_body_begin_[body + 1]; ++i) {
      const Hold hold = hold_of(histories_[of_body_[i]], body);
      const auto last = std::max(begin, static_cast<std::ptrdiff_t>(holds_.size()) - look_back);
      const auto same = std::find_if(holds_.begin() + last, holds_.end(), [&](const Hold& other) {
        return other.by == hold.by && other.normal == hold.normal;
      });
      if (same == holds_.end())
        holds_.push_back(hold);
      else
        same->depth = std::max(same->depth, hold.depth);
    }
    holds_begin_[body + 1] = static_cast<int>(holds_.size());
  }
}

void ContactMemory::rest(std::span<const int> changed, const std::function<bool(int)>& rests) {
  const auto awake = [&](int body) { return !rests(body); };
  for (int body : changed) {
    if (awake(body)) {
      resting_.take(
          body, [](int) { return true; }, histories_);
    } else {
      resting_.take(body, awake, histories_);
    }
  }
  std::erase_if(histories_, [&](const History& history) {
    if (awake(history.bodies[0]) || awake(history.bodies[1])) return false;
    resting_.put(history);
    return true;
  });
  std::sort(histories_.begin(), histories_.end(), [](const History& p, const History& q) { return p.key < q.key; });
  any_bonded_ = std::any_of(histories_.begin(), histories_.end(), [](const History& m) { return m.bonded; });
  keys_.clear();
  for (const History& history : histories_) keys_.push_back(history.key);
  by_family_.clear();
  sort_by_body();
}

}  // namespace talus
