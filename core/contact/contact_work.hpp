#pragma once

namespace talus {

/// What detection has done since it was set up.
struct ContactWork {
  long body_pairs = 0;            ///< distances of two bodies that were measured
  long searches = 0;              ///< of these, the pairs whose facets were searched
  long facet_pairs_searched = 0;  ///< pairs of facets that searches found
  long facet_pairs = 0;           ///< pairs of facets looked at, step by step
  long points = 0;                ///< contact points handed out
};

}  // namespace talus
