#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// How far each body has gone: step by step the largest displacement of any of its nodes, summed up. Between two
/// readings no node of the body moved, along any axis, further than by what the readings differ. A body that nobody
/// tells of, or whose nodes nobody compares, has not moved and costs nothing.
class Odometers {
 public:
  explicit Odometers(std::size_t bodies) : bodies_(bodies) {}

  /// No node of the body moved by more than `displacement` [m].
  void add(int body, double displacement);

  /// Reads the displacement off the body's nodes: those from `first` on, `count` of them, of the positions x of all
  /// nodes. They are compared with those of the last call.
  void read(int body, int first, int count, std::span<const Vec3> x);

  double travelled(int body) const { return bodies_[body].travelled; }  ///< m, an upper bound
  double pace(int body) const { return bodies_[body].pace; }            ///< m, the last displacement
  /// Counts the times that the body moved: its nodes are where they were while this stays the same.
  std::uint64_t moves(int body) const { return bodies_[body].moves; }

  /// Bodies that moved since have_seen() was called last, each once.
  std::span<const int> moved() const { return moved_; }
  void have_seen();

 private:
  struct Reading {
    double travelled = 0, pace = 0;
    std::uint64_t moves = 0;
    bool is_listed = false;
  };
  std::vector<Reading> bodies_;
  std::vector<int> moved_;
  std::vector<Vec3> last_;  // positions, where they are compared
};

}  // namespace talus
