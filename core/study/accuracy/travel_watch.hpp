#pragma once

#include <optional>
#include <vector>

#include "study/accuracy/study_run.hpp"

namespace talus {

struct BlockSystem;
struct BodySet;

/// A block has set off once it is a hundredth of its size, the cube root of its volume, from where it was; it rests
/// after the last time that it has gone so far again, by linear interpolation in steps. Who has done so within the last
/// twentieth of the time still moves.
class TravelWatch {
 public:
  TravelWatch(const Project& project, const BlockSystem& system);

  /// After every step.
  void look(const StepReport& step, const BodySet& bodies);
  StudyTravel travel() const;

 private:
  struct Way {
    int block = 0;
    double mass = 0, reach = 0;         ///< kg; m
    Vec3 place = Vec3::Zero();          ///< m, of the centroid before the run
    Vec3 gone = Vec3::Zero();           ///< m, by now
    Vec3 anchor = Vec3::Zero();         ///< m, how far it had gone when it was last `reach` from the one before
    std::optional<double> first, last;  ///< s, when it was
  };
  void follow(Way& way, const Vec3& gone, double begin, double end);
  double extent(bool by_now) const;

  const Project& project_;
  std::vector<Way> ways_;
  bool counts_ = false;
  double begin_ = 0, end_ = 0;  ///< s, of the time that counts
};

}  // namespace talus
