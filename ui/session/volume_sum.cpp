#include "session/volume_sum.hpp"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "render/paint/numbers.hpp"

namespace talus {

namespace {

constexpr double volume_rounding = 1e-6;  // of the solids' volume

QString cubicMetres(double volume) { return QString::fromStdString(format_number(volume, 6)) + QStringLiteral(" m³"); }

/// The project asks for blocks to be left out.
bool leavesOut(const Project& project) {
  return project.splinters.rule == SplinterRule::drop ||
         std::ranges::any_of(project.blocks, [](const BlockOverride& block) { return block.removed; });
}

}  // namespace

bool VolumeSum::addsUp() const { return std::abs(blocks - solids) <= volume_rounding * solids; }

VolumeSum volumeSum(const BlockSystem& system) {
  VolumeSum sum{0, system.solids_volume};
  for (const Block& block : system.blocks) sum.blocks += block.volume;
  return sum;
}

std::optional<Problem> volumeProblem(const BlockSystem& system, const Project& project) {
  const VolumeSum sum = volumeSum(system);
  if (sum.addsUp() || (sum.blocks < sum.solids && leavesOut(project))) return std::nullopt;
  return Problem{.severity = Problem::Severity::warning,
                 .place = QObject::tr("blocks"),
                 .problem = QObject::tr("they have %1 together, the solids %2")
                                .arg(cubicMetres(sum.blocks), cubicMetres(sum.solids)),
                 .remedy = QObject::tr("look for solids that are open or overlap, and for cuts that nearly meet"),
                 .of = Problem::Of::run};
}

}  // namespace talus
