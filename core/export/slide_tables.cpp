#include "export/slide_tables.hpp"

#include <cmath>
#include <ostream>

#include "export/export_folder.hpp"
#include "model/number_text.hpp"
#include "results/text_table.hpp"

namespace talus {

namespace fs = std::filesystem;

std::string grid_text(const DepthGrid& grid) {
  constexpr const char* no_data = "-9999";
  std::string text = "ncols " + std::to_string(grid.columns) + "\nnrows " + std::to_string(grid.rows) + "\nxllcorner " +
                     number_text(grid.west) + "\nyllcorner " + number_text(grid.south) + "\ncellsize " +
                     number_text(grid.cell) + "\nNODATA_value " + no_data + '\n';
  for (int row = grid.rows - 1; row >= 0; --row)
    for (int column = 0; column < grid.columns; ++column) {
      const double depth = grid.at(column, row);
      text += std::isfinite(depth) ? significant(depth, 6) : no_data;
      text += column + 1 < grid.columns ? ' ' : '\n';
    }
  return text;
}

void export_slide(const Slide& slide, const BlockSystem& system, const fs::path& folder) {
  prepare_export_folder(folder);
  write_export_file(folder / "front.csv", [&](std::ostream& stream) {
    stream << "time [s],advance [m],velocity [m/s],volume [m3]\n";
    for (const FrontMoment& moment : slide.front)
      stream << csv_line({moment.time, moment.advance, moment.velocity, moment.volume}) << '\n';
  });
  write_export_file(folder / "blocks.csv", [&](std::ostream& stream) {
    stream << "block,name,volume [m3]\n";
    for (const int number : slide.run_out.rock.blocks) {
      const Block& block = system.blocks[static_cast<std::size_t>(number)];
      stream << number << ',' << csv_field(block.name) << ',' << number_text(block.volume) << '\n';
    }
  });
  write_export_file(folder / "deposit.csv", [&](std::ostream& stream) {
    stream << "ring,x [m],y [m]\n";
    for (std::size_t ring = 0; ring < slide.deposit.outline.size(); ++ring)
      for (const auto& [x, y] : slide.deposit.outline[ring]) stream << ring << ',' << csv_line({x, y}) << '\n';
  });
  write_export_file(folder / "depth.asc", [&](std::ostream& stream) { stream << grid_text(slide.deposit.grid); });
}

}  // namespace talus
