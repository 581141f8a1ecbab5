#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/paint/picture_difference.hpp"

// What is told of a picture that is compared with its baseline.
namespace talus::cli {

/// "16 × 16 pixels"
std::string pixels_text(int width, int height);
/// "similarity 0.312, at least 0.750 is asked for; worst in the 16 × 16 pixels at 640,120; …" without what differs
/// where nothing does.
std::string difference_text(const PictureDifference& found, double threshold);
nlohmann::ordered_json tile_json(const PictureTile& tile);
/// A picture that was held against its baseline; one without a `failure` passed.
struct PictureTest {
  std::string name, failure{};
};
/// As servers of continuous integration read it.
std::string junit_text(const std::string& suite, const std::vector<PictureTest>& tests);

}  // namespace talus::cli
