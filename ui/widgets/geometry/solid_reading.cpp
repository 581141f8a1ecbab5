#include "widgets/geometry/solid_reading.hpp"

#include <algorithm>
#include <cmath>

#include "model/rules/solid_rules.hpp"

namespace talus {

namespace {

constexpr double far = 1e4;                 // m: beyond it coordinates are those of a survey's grid
constexpr double kilometre = 1e3;           // m
constexpr double below_all_ground = -12e3;  // m

/// As deep below the lowest point of the ground as it is high, in whole metres.
double baseBelow(const SolidSurface& deep) {
  double lowest = deep.max.z();
  for (const Vec3& vertex : deep.vertices)
    if (vertex.z() > deep.min.z() + 1) lowest = std::min(lowest, vertex.z());  // the underside apart
  const double height = std::max(deep.max.z() - lowest, (deep.max - deep.min).head<2>().maxCoeff() / 10);
  return std::floor(lowest - height);
}

std::optional<Turn> turnOf(const ImportChoices& choices) {
  // About the zero of the survey's grid, so that its axes are turned and not the local ones.
  switch (choices.up) {
    case ImportChoices::Up::y:
      return Turn{Vec3::UnitX(), 90, -choices.origin};
    case ImportChoices::Up::x:
      return Turn{Vec3::UnitY(), -90, -choices.origin};
    case ImportChoices::Up::z:
      break;
  }
  return std::nullopt;
}

}  // namespace

Solid solidFrom(const std::filesystem::path& file, const ImportChoices& choices) {
  Solid solid;
  if (choices.asTerrain) {
    solid.shape = TerrainShape{file.string(), choices.base.value_or(0), choices.tolerance};
  } else {
    solid.shape = FileShape{file.string(), choices.scale};
    solid.turn = turnOf(choices);
  }
  return solid;
}

SolidReading readSolid(const std::filesystem::path& file, ImportChoices choices, Progress& progress) {
  SolidReading reading;
  const auto read = [&] {
    const Solid solid = solidFrom(file, choices);
    check(solid, Place() / "solids" / 0);
    return solid_surface(solid, choices.origin, "/", progress);
  };
  try {
    if (choices.asTerrain && !choices.base) {
      choices.base = below_all_ground;
      choices.base = baseBelow(read());
    }
    reading.surface = read();
    reading.base = choices.base.value_or(0);
  } catch (const InputError& error) {
    reading.problem = error;
  } catch (const std::exception& error) {
    reading.problem = InputError(file.string(), error.what(), "see that the program is installed whole");
  }
  return reading;
}

std::optional<Vec3> localOrigin(const SolidSurface& surface) {
  const Vec3 middle = (surface.min + surface.max) / 2;
  if (middle.cwiseAbs().maxCoeff() <= far) return std::nullopt;
  Vec3 origin = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    if (std::abs(middle[i]) > far) origin[i] = std::floor(middle[i] / kilometre) * kilometre;
  return origin;
}

}  // namespace talus
