#pragma once

#include "templates/template.hpp"

/// The templates, one a file.
namespace talus {

ProjectTemplate bench_slope();
ProjectTemplate rock_wedge();
ProjectTemplate toppling_face();
ProjectTemplate rock_column();
ProjectTemplate tunnel_roof();
ProjectTemplate cavern();
ProjectTemplate dry_stone_wall();

}  // namespace talus
