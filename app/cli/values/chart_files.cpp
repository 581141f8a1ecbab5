#include "values/chart_files.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "sheet.hpp"

namespace talus::cli {

namespace {

std::vector<std::string> write_into_folder(const ChartFiles& wanted, const Charts& rows) {
  std::error_code failure;
  std::filesystem::create_directories(wanted.out, failure);
  if (failure) throw InputError(wanted.out.string(), "cannot be made: " + failure.message(), "choose another folder");
  std::vector<std::string> files;
  for (const auto& row : rows) {
    for (const Chart& chart : row) {
      std::string name = chart.name + ".png";
      std::replace(name.begin(), name.end(), '/', '_');
      write_png(draw_chart(chart.plot, wanted.size.width, wanted.size.height), wanted.out / name);
      files.push_back((wanted.out / name).string());
    }
  }
  return files;
}

}  // namespace

std::vector<std::string> write_charts(const ChartFiles& files, const Charts& charts, const std::string& title) {
  if (!is_sheet(files.out)) return write_into_folder(files, charts);
  Sheet sheet{{}, files.size, colours(files.theme).surface, title};
  for (const auto& row : charts) {
    std::vector<Painting>& paintings = sheet.rows.emplace_back();
    for (const Chart& chart : row) paintings.push_back(chart_painting(chart.plot));
  }
  write_sheet(sheet, files.out);
  return {files.out.string()};
}

}  // namespace talus::cli
