#pragma once

#include "geometry/mesher/surfaces/height_points.hpp"

/// What the module talus-height-grid has to offer: read_grid through GDAL, which fills `result`.
extern "C" __attribute__((visibility("default"))) void talus_read_grid(const std::string& path,
                                                                       const std::string& as_written,
                                                                       const talus::Vec3& origin,
                                                                       talus::HeightPoints& result);
