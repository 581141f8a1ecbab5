#pragma once

#include <filesystem>
#include <string>

#include "render/paint/image.hpp"

namespace talus {

/// Where pictures that were right are kept, and where those that differ from them are put.
struct BaselineFolders {
  std::filesystem::path baselines = std::filesystem::path(TALUS_SOURCE_DIR) / "tests/images/baselines";
  std::filesystem::path differing = std::filesystem::absolute("differing_pictures");
  /// The pictures that differ become baselines: TALUS_UPDATE_BASELINES is set, as tools/update_baselines.sh does.
  bool update = std::getenv("TALUS_UPDATE_BASELINES") != nullptr;
};

/// In which way a picture differs from the baseline NAME.png, by the comparison of `talus-cli render --compare`; empty
/// where it does not. Leaves NAME.expected.png, NAME.actual.png and NAME.difference.png in the folder of those that
/// differ, which the answer names.
std::string held_to_baseline(const Image& image, const std::string& name, const BaselineFolders& folders = {});

/// Fails the running test where the picture differs from its baseline, which is named as the test, or as is said.
void expect_baseline(const Image& image);
void expect_baseline(const Image& image, const std::string& name);

}  // namespace talus
