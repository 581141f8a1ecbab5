#pragma once

#include <memory>
#include <vector>

#include "effects/called_effects.hpp"
#include "effects/inertia.hpp"
#include "effects/normal_contact.hpp"
#include "effects/shear_contact.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

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

/// `set` and `links` outlive the composition. Throws InputError for a load or a constraint outside its block. Without
/// contact: no block can reach another one yet.
Composition compose(const Project& project, const BlockSystem& system, int stage, BodySet& set,
                    const ContactLinks& links, const EffectTolerances& tolerances = {}, bool with_contact = true);

/// Where effects were put in: before the one that had this place, so many.
struct PutIn {
  int place = 0, count = 0;
};

/// The effects of contact, put into a composition without.
PutIn put_in_contact(Composition& composition, const Project& project, const BlockSystem& system,
                     const EffectTolerances& tolerances);

}  // namespace talus
