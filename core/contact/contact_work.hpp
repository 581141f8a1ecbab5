#pragma once

namespace talus {

/// What detection has done since it was set up; at the end the limits that it came up against.
struct ContactWork {
  long body_pairs = 0;            ///< distances of two bodies that were measured
  long searches = 0;              ///< of these, the pairs whose facets were searched
  long facet_pairs_searched = 0;  ///< pairs of facets that searches found
  long facet_pairs = 0;           ///< pairs of facets looked at, step by step
  long points = 0;                ///< contact points handed out
  long unfinished_planes = 0;     ///< common planes that were still improving when their iterations were used up
  long edges_left_out = 0;        ///< sharp edges beside an overlap that found no place in its list

  void archive(auto& state) {
    state(body_pairs, searches, facet_pairs_searched, facet_pairs, points, unfinished_planes, edges_left_out);
  }
};

}  // namespace talus
