#include "render/film/film_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "render/paint/numbers.hpp"

namespace talus {

std::vector<int> frames_of_pictures(std::span<const double> times, double speed, int rate) {
  constexpr double most_pictures = 1e6;
  if (!(speed > 0) || !std::isfinite(speed))
    throw InputError("speed", "this is no speed", "give seconds of the model in a second of film, as 1 or 0.1");
  if (times.empty()) return {};
  const double pictures = std::round((times.back() - times.front()) / speed * rate) + 1;
  if (pictures > most_pictures)
    throw InputError("speed", "the film would have " + format_number(pictures) + " pictures", "choose a higher speed");
  std::vector<int> frames;
  std::size_t shown = 0;
  for (int i = 0; i < static_cast<int>(pictures); ++i) {
    const double moment = times.front() + i * speed / rate;
    while (shown + 1 < times.size() && std::abs(times[shown + 1] - moment) <= std::abs(times[shown] - moment)) ++shown;
    frames.push_back(static_cast<int>(shown));
  }
  frames.back() = static_cast<int>(times.size()) - 1;
  return frames;
}

}  // namespace talus
