#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/project.hpp"

namespace talus {

/// How accurately a project is solved: what an accuracy study varies and nothing else.
struct Setting {
  std::optional<BodyKind> body;  ///< of all blocks that may move; empty: each as the project has it, unlike ones
  Strain strain = Strain::corotational;
  Integrator integrator = Integrator::newmark;
  double time_step = 1;                           ///< of dynamic stages, in units of the project's own
  double static_step = 1;                         ///< of static stages, likewise
  double mesh_size = 1;                           ///< of every solid, in units of the project's own
  std::optional<double> penetration_tolerance;    ///< of the mesh size; empty: springs as they are
  double tolerance = SolverSettings{}.tolerance;  ///< that steps are solved to
  Preset scheme = Preset::talus;                  ///< where it is not the project's, all that a preset sets is its
  ContactModel contact = ContactModel::area;
  double contact_stiffness = 1;  ///< of contacts whose joint says none, in units of the project's own
  bool operator==(const Setting&) const = default;
};

/// The setting by a scheme: strain and integrator too are those of the scheme.
Setting by_scheme(Preset scheme, Setting setting);

/// The project's own.
Setting own_setting(const Project& project);

/// The project under another setting; its own gives it back as it is. Model times stay: a stage of so many steps gets
/// more or fewer of them. A solid that leaves its mesh size open gets the usual one times the factor. Throws InputError
/// for a solid from a file that leaves it open, since its usual one is known to the mesher alone.
Project under(const Setting& setting, const Project& project);

/// "tetrahedra · Δ/2 · h/2": the body, and whatever else is not the project's own. The own one alone says so.
std::string label_of(const Setting& setting, const Setting& own);

/// "affine", or "as given" where the project's blocks are unlike.
std::string body_text(const Setting& setting);

/// "off" without one.
std::string penetration_text(const Setting& setting);

}  // namespace talus
