#pragma once

#include <QString>
#include <array>

namespace talus {

/// The workflow, in its order; Ctrl+1…9 goes to each.
enum class Step { geometry, joints, blocks, mesh, materials, loads, stages, solve, results };

inline constexpr std::array all_steps{Step::geometry, Step::joints, Step::blocks, Step::mesh,   Step::materials,
                                      Step::loads,    Step::stages, Step::solve,  Step::results};

/// Steps that set the project up, before anything is solved.
constexpr bool isSetUp(Step step) { return step < Step::solve; }

/// The word that the command line and tests use, which is the icon's name too.
constexpr const char* stepKey(Step step) {
  constexpr std::array keys{"geometry", "joints", "blocks", "mesh", "materials", "loads", "stages", "solve", "results"};
  return keys[static_cast<size_t>(step)];
}

inline QString stepTitle(Step step) {
  QString title = QString::fromLatin1(stepKey(step));
  title[0] = title[0].toUpper();
  return title;
}

}  // namespace talus
