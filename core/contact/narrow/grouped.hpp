#pragma once

#include <vector>

namespace talus {

/// Items by a number that several may share. Numbers that none has cost nothing.
template <class Item>
class Grouped {
 public:
  void clear() {
    for (const Link& link : links_) first_[link.number] = none;
    links_.clear();
    items_.clear();
  }
  void add(int number, const Item& item) {
    if (number >= static_cast<int>(first_.size())) first_.resize(number + 1, none);
    links_.push_back({number, first_[number]});
    first_[number] = static_cast<int>(items_.size());
    items_.push_back(item);
  }

  int size() const { return static_cast<int>(items_.size()); }
  const Item& operator[](int place) const { return items_[place]; }
  /// One of those with this number for which it holds, or null.
  template <class Holds>
  const Item* find(int number, const Holds& holds) const {
    if (number >= static_cast<int>(first_.size())) return nullptr;
    for (int place = first_[number]; place != none; place = links_[place].next)
      if (holds(items_[place])) return &items_[place];
    return nullptr;
  }
  template <class Holds>
  bool any_of(int number, const Holds& holds) const {
    return find(number, holds) != nullptr;
  }

  void archive(auto& state) { state(items_, links_, first_); }

 private:
  static constexpr int none = -1;
  struct Link {
    int number, next;

    void archive(auto& state) { state(number, next); }
  };
  std::vector<Item> items_;
  std::vector<Link> links_;
  std::vector<int> first_;  // a number: the place of one of those that have it
};

}  // namespace talus
