#pragma once

#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "measures/deposit.hpp"
#include "measures/run_out.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// What a slide came to: all that is measured of the rock that has moved by one frame.
struct Slide {
  double time = 0;            ///< s, of that frame
  int movable = 0;            ///< blocks that are not built fixed
  double movable_volume = 0;  ///< m³
  RunOut run_out;
  Deposit deposit;
  std::vector<PlanRing> source;    ///< m, outline of the moved rock where it was at rest, as that of the deposit
  std::vector<FrontMoment> front;  ///< of the frames up to that one, in order

  /// The one in which the front was fastest; null where no frame is.
  const FrontMoment* fastest() const;
};

struct SlideSettings {
  RunOutSettings run_out;
  std::optional<double> cell;  ///< m, of the depth map, as `deposit_of` takes it
  bool operator==(const SlideSettings&) const = default;
};

/// Up to the frame of this number. Throws InputError as its parts do, std::out_of_range where there is no such frame,
/// Cancelled.
Slide measure_slide(const ResultReader& results, int frame, const SlideSettings& settings, Progress& progress);

}  // namespace talus
