#include "pictures/picture_check.hpp"

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "render/paint/picture_difference.hpp"
#include "text/picture_text.hpp"

namespace talus::cli {

std::filesystem::path difference_file(std::filesystem::path picture) {
  return picture.replace_extension(".difference.png");
}

PictureVerdict compare_with_baseline(const Image& drawn, const std::filesystem::path& picture,
                                     const std::filesystem::path& baseline, double threshold,
                                     const std::filesystem::path& difference) {
  PictureVerdict verdict;
  const Image expected = read_png(baseline);
  const std::string differs = picture.string() + " differs from " + baseline.string() + ": ";
  if (expected.width != drawn.width || expected.height != drawn.height) {
    verdict.problem = differs + "it has " + pixels_text(drawn.width, drawn.height) + ", the baseline " +
                      pixels_text(expected.width, expected.height) + "; draw with --size " +
                      std::to_string(expected.width) + "x" + std::to_string(expected.height) +
                      " or make it the baseline";
    return verdict;
  }
  const PictureDifference found = compare_pictures(expected, drawn, threshold);
  verdict.json = {{"similarity", found.similarity},
                  {"worst", tile_json(found.worst)},
                  {"tiles", found.tiles},
                  {"differing", found.differing}};
  if (found.differing == 0) {
    verdict.agreement = difference_text(found, threshold);
    return verdict;
  }
  if (difference.has_parent_path()) std::filesystem::create_directories(difference.parent_path());
  write_png(difference_picture(expected, drawn, threshold), difference);
  verdict.json["region"] = tile_json(found.region);
  verdict.json["difference_picture"] = difference.string();
  verdict.problem = differs + difference_text(found, threshold) + "; look at " + difference.string();
  return verdict;
}

CLI::Option* add_threshold(CLI::App& command, double& threshold) {
  return command
      .add_option_function<double>(
          "--threshold",
          [&threshold](double share) {
            if (!(share >= 0 && share <= 1)) throw CLI::ValidationError("--threshold", "write a number from 0 to 1");
            threshold = share;
          },
          "Similarity that the worst tile must have; 1: equal pictures")
      ->type_name("T")
      ->default_str("0.75");
}

}  // namespace talus::cli
