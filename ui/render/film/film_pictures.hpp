#pragma once

#include <span>
#include <vector>

namespace talus {

/// When each picture of a film is taken.
struct FilmClock {
  double begin = 0, end = 0;  ///< s, of the model
  double speed = 1;           ///< seconds of the model in a second of film
  int rate = 25;              ///< pictures a second

  /// One for each moment from the beginning to the end. Throws InputError for a speed that is none, or that would make
  /// more than a million.
  int pictures() const;
  /// Of a picture, s; that of the last one is the end.
  double moment(int picture) const;
};

/// Which frame each picture of a film shows: the one nearest to its moment. `times` [s] ascend; none have no pictures.
std::vector<int> frames_of_pictures(std::span<const double> times, const FilmClock& clock);

}  // namespace talus
