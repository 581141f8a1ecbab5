#pragma once

#include <array>
#include <span>
#include <vector>

namespace talus {

/// Which contacts may be swept over at once. Bodies are numbered by how many contacts lie between them and a first one;
/// contacts then couple bodies of one layer, or of two that follow one upon the other. What is done to the contacts of
/// every second layer touches no body twice: these go at once, then the others (red and black, layer by layer). Layers
/// hang on the contacts alone, so the order of a sweep is the same on any number of threads.
class SweepLayers {
 public:
  /// The two bodies of a contact; −1: one that no impulse moves.
  using Pair = std::array<int, 2>;

  /// The layer of each contact, from 0; all 0 where there are too few to be divided. The contacts hang together.
  const std::vector<int>& of(std::span<const Pair> pairs, int bodies);

 private:
  void list_neighbours(std::span<const Pair> pairs);
  /// Numbers bodies by how far they are from this one; returns one of the farthest.
  int number_from(int first);
  /// Joins layers that follow one upon the other until each has contacts enough.
  void join_thin_layers();

  std::vector<int> begin_;            // of each body: into neighbours_
  std::vector<int> neighbours_;       // bodies
  std::vector<int> distance_;         // of each body: contacts from the first; −1: not known
  std::vector<int> queue_;            // bodies, the nearest first
  std::vector<int> layers_, counts_;  // of contacts; of layers: contacts, then what layer they become
};

}  // namespace talus
