#include "render/film/film_pictures.hpp"

#include <cmath>

#include "base/error.hpp"
#include "render/paint/numbers.hpp"

namespace talus {

int FilmClock::pictures() const {
  constexpr double most_pictures = 1e6;
  if (!(speed > 0) || !std::isfinite(speed))
    throw InputError("speed", "this is no speed", "give seconds of the model in a second of film, as 1 or 0.1");
  const double pictures = std::round((end - begin) / speed * rate) + 1;
  if (pictures > most_pictures)
    throw InputError("speed", "the film would have " + format_number(pictures) + " pictures", "choose a higher speed");
  return static_cast<int>(pictures);
}

double FilmClock::moment(int picture) const { return picture + 1 == pictures() ? end : begin + picture * speed / rate; }

std::vector<int> frames_of_pictures(std::span<const double> times, const FilmClock& clock) {
  std::vector<int> frames;
  std::size_t shown = 0;
  for (int i = 0; !times.empty() && i < clock.pictures(); ++i) {
    const double moment = clock.moment(i);
    while (shown + 1 < times.size() && std::abs(times[shown + 1] - moment) <= std::abs(times[shown] - moment)) ++shown;
    frames.push_back(static_cast<int>(shown));
  }
  return frames;
}

}  // namespace talus
