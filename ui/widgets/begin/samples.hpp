#pragma once

#include <QString>
#include <filesystem>
#include <vector>

namespace talus {

/// A shipped project, as the start page shows it.
struct Sample {
  std::filesystem::path project;
  QString name, description;
  std::filesystem::path picture;  ///< may not exist
};

/// Those in `folder`, one in each subfolder, by name; those that cannot be read are left out.
std::vector<Sample> samplesIn(const std::filesystem::path& folder);

/// Where the program was installed with its samples, or else its source folder.
std::filesystem::path samplesFolder();

}  // namespace talus
