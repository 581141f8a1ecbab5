#include "widgets/results/data_export.hpp"

#include "export/export.hpp"
#include "export/export_folder.hpp"
#include "io/whole_file.hpp"
#include "render/scene/block_colours.hpp"
#include "report/report.hpp"
#include "results/result_folder.hpp"

namespace talus {

namespace {

void writeData(DataFormat format, const ResultReader& results, int frame, const std::filesystem::path& to,
               Progress& progress) {
  switch (format) {
    case DataFormat::csv:
      return export_csv(results, all_frames(results), to, progress);
    case DataFormat::vtu:
      return export_vtu(results, all_frames(results), to, progress);
    case DataFormat::stl:
      return replace_whole_file(to, stl_of(results.system(), results.frame(frame)));
    case DataFormat::gltf:
      return replace_whole_file(to, animated_glb_of(results, fractions_of_colours(results.system()), progress));
  }
}

}  // namespace

Writing writingOfData(DataFormat format, const std::filesystem::path& results, int frame,
                      const std::filesystem::path& to) {
  return [=](Progress& progress) { writeData(format, ResultReader(results), frame, to, progress); };
}

Writing writingOfReport(const std::filesystem::path& results, const std::filesystem::path& to) {
  return [=](Progress&) {
    const report::Writer write = report::writer_for(to);
    replace_whole_file(to, write(report::report_of(results)));
  };
}

}  // namespace talus
