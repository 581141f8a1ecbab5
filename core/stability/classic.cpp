#include "stability/all_scenes.hpp"
namespace talus { std::vector<StabilityScene> classic_scenes() { return {}; } }
