#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.hpp"
#include "geometry/mesher/surfaces/height_grid.hpp"

/// The drivers of two formats alone: all of them take a tenth of a second.
extern "C" void GDALRegister_AAIGrid();
extern "C" void GDALRegister_GTiff();

namespace talus {
namespace {

struct CloseGrid {
  void operator()(GDALDatasetH grid) const { GDALClose(grid); }
};
using Grid = std::unique_ptr<void, CloseGrid>;

Grid open_grid(const std::string& path, const std::string& as_written) {
  CPLSetErrorHandler(CPLQuietErrorHandler);
  GDALRegister_AAIGrid();
  GDALRegister_GTiff();
  CPLSetConfigOption("AAIGRID_DATATYPE", "Float64");  // single precision otherwise
  const std::array<const char*, 3> formats{"AAIGrid", "GTiff", nullptr};
  Grid grid(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, formats.data(), nullptr, nullptr));
  if (!grid)
    throw InputError(as_written, "is not a readable grid of heights", "export it again as ESRI ASCII or GeoTIFF");
  return grid;
}

/// Heights and places in one unit: metres.
void check_coordinates(GDALDatasetH grid, const std::string& as_written) {
  const char* system = GDALGetProjectionRef(grid);
  if (!system || !*system) return;
  const OGRSpatialReferenceH reference = OSRNewSpatialReference(system);
  const bool degrees = reference && OSRIsGeographic(reference);
  OSRDestroySpatialReference(reference);
  if (degrees)
    throw InputError(as_written, "has its coordinates in degrees",
                     "project it to metres, for example by gdalwarp -t_srs EPSG:32632");
}

void check_heights(GDALDatasetH grid, const std::string& as_written) {
  constexpr double most_cells = 5e7;
  const double cells = static_cast<double>(GDALGetRasterXSize(grid)) * GDALGetRasterYSize(grid);
  if (cells > most_cells)
    throw InputError(as_written, "has " + std::to_string(static_cast<long long>(cells)) + " cells",
                     "cut it to the slope, or make its cells larger, for example by gdal_translate -tr 2 2");
  const GDALColorInterp colour = GDALGetRasterColorInterpretation(GDALGetRasterBand(grid, 1));
  if (colour == GCI_RedBand || colour == GCI_PaletteIndex)
    throw InputError(as_written, "is a picture, not heights", "give the elevation model itself");
}

/// A row of heights; NaN where there is none.
std::vector<double> read_row(GDALRasterBandH band, int row, const std::string& as_written) {
  std::vector<double> heights(static_cast<std::size_t>(GDALGetRasterBandXSize(band)));
  const int width = static_cast<int>(heights.size());
  if (GDALRasterIO(band, GF_Read, 0, row, width, 1, heights.data(), width, 1, GDT_Float64, 0, 0) != CE_None)
    throw InputError(as_written, "ends at row " + std::to_string(row + 1), "export it again");
  int has_no_data = 0, has_scale = 0, has_offset = 0;
  const double no_data = GDALGetRasterNoDataValue(band, &has_no_data);
  const double scale = GDALGetRasterScale(band, &has_scale), offset = GDALGetRasterOffset(band, &has_offset);
  for (double& height : heights) {
    if (has_no_data && height == no_data)
      height = std::numeric_limits<double>::quiet_NaN();
    else
      height = height * (has_scale ? scale : 1) + (has_offset ? offset : 0);
  }
  return heights;
}

}  // namespace
}  // namespace talus

using namespace talus;

void talus_read_grid(const std::string& path, const std::string& as_written, const Vec3& origin, HeightPoints& result) {
  const Grid grid = open_grid(path, as_written);
  check_coordinates(grid.get(), as_written);
  check_heights(grid.get(), as_written);
  std::array<double, 6> place{0, 1, 0, 0, 0, 1};
  GDALGetGeoTransform(grid.get(), place.data());
  SurfaceFinding missing{SurfaceFinding::Kind::no_data, 0, Vec3::Zero(), true};
  const GDALRasterBandH band = GDALGetRasterBand(grid.get(), 1);
  for (int row = 0; row < GDALGetRasterYSize(grid.get()); ++row) {
    const std::vector<double> heights = read_row(band, row, as_written);
    for (std::size_t column = 0; column < heights.size(); ++column) {
      const double i = static_cast<double>(column) + 0.5, k = row + 0.5;
      const Vec3 point(place[0] - origin.x() + place[1] * i + place[2] * k,
                       place[3] - origin.y() + place[4] * i + place[5] * k, heights[column] - origin.z());
      if (std::isfinite(heights[column])) {
        result.points.push_back(point);
      } else if (missing.count++ == 0) {
        missing.where = {point.x(), point.y(), 0};
      }
    }
  }
  if (missing.count > 0) result.findings.push_back(missing);
}
