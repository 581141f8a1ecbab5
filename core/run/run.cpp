#include "run/run.hpp"

#include "base/parallel.hpp"
#include "results/folder.hpp"
#include "run/recording.hpp"

namespace talus {

RunReport run(const Project& project, const BlockSystem& system, const RunOptions& options, RunObserver& observer) {
  const ThreadLimit limit(options.threads);
  Simulation simulation(project, system);
  Recording recording(project, system, options, simulation, observer);
  const std::optional<Checkpoint> last =
      options.resume ? read_checkpoint(options.out / "checkpoint.h5") : std::optional<Checkpoint>();
  if (last)
    recording.resume(*last);
  else
    recording.begin();
  try {
    while (!simulation.finished() && !recording.interpenetrating() && observer.go_on()) recording.take_step();
    return recording.finish();
  } catch (const WriteError& error) {
    return recording.break_off(error);
  }
}

}  // namespace talus
