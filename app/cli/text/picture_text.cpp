#include "text/picture_text.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/xml_text.hpp"

namespace talus::cli {

namespace {

std::string three_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", number);
  return text;
}

std::string place_of(const PictureTile& tile) {
  return pixels_text(tile.width, tile.height) + " at " + std::to_string(tile.left) + "," + std::to_string(tile.top);
}

}  // namespace

std::string pixels_text(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height) + " pixels";
}

std::string difference_text(const PictureDifference& found, double threshold) {
  const std::string similarity =
      "similarity " + three_digits(found.similarity) + ", at least " + three_digits(threshold) + " is asked for";
  if (found.differing == 0) return similarity;
  return similarity + "; worst in the " + place_of(found.worst) + "; all that differs is in the " +
         place_of(found.region);
}

nlohmann::ordered_json tile_json(const PictureTile& tile) {
  return {{"left", tile.left}, {"top", tile.top}, {"width", tile.width}, {"height", tile.height}};
}

std::string junit_text(const std::string& suite, const std::vector<PictureTest>& tests) {
  std::string cases;
  int failures = 0;
  for (const PictureTest& test : tests) {
    cases += "    <testcase classname=\"pictures\" name=\"" + xml_text(test.name) + "\"";
    if (test.failure.empty()) {
      cases += "/>\n";
      continue;
    }
    ++failures;
    cases += ">\n      <failure message=\"" + xml_text(test.failure) + "\"/>\n    </testcase>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"" + xml_text(suite) +
         "\" tests=\"" + std::to_string(tests.size()) + "\" failures=\"" + std::to_string(failures) +
         "\" errors=\"0\">\n" + cases + "  </testsuite>\n</testsuites>\n";
}

}  // namespace talus::cli
