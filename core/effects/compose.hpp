#pragma once

#include <memory>
#include <string>
#include <vector>

#include "effects/inertia.hpp"
#include "effects/normal_contact.hpp"
#include "effects/shear_contact.hpp"
#include "model/project.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Whether a scene calls for an effect, and why or why not.
struct EffectStatus {
  EffectKind kind = EffectKind::elasticity;
  bool active = false;
  std::string reason;
};

/// Every kind once, in the order in which effects are added up: whether a stage calls for it. Costs no solving.
std::vector<EffectStatus> called_effects(const Project& project, const BlockSystem& system);

/// The effects of a stage. What is not called for is not here.
struct Composition {
  std::vector<std::unique_ptr<Effect>> effects;
  BodySet* bodies = nullptr;            ///< whose unknowns they move
  const ContactLinks* links = nullptr;  ///< of their contacts; null: they have none
  Inertia* inertia = nullptr;           ///< among effects; null where every block is fixed
  std::vector<NormalContact*> normal;   ///< among effects; empty where nothing can touch
  ShearContact* shear = nullptr;        ///< among effects; null where no joint resists shear
  bool rebounds = false;                ///< blocks can meet: at the end of dynamic steps they part by the law of impact
};

/// `set` and `links` outlive the composition. Throws InputError for a load or a constraint outside its block.
Composition compose(const Project& project, const BlockSystem& system, int stage, BodySet& set,
                    const ContactLinks& links, const EffectTolerances& tolerances = {});

}  // namespace talus
