#include "document/brought_files.hpp"

#include "base/error.hpp"
#include "io/whole_file.hpp"
#include "model/solid_shape.hpp"

namespace talus {

namespace fs = std::filesystem;

void bring_file(const fs::path& source, const fs::path& target) {
  std::error_code unknown;
  if (!fs::is_regular_file(source, unknown) || fs::equivalent(source, target, unknown)) return;
  if (fs::exists(target, unknown)) {
    if (read_whole_file(source) == read_whole_file(target)) return;
    throw InputError(target.string(), "another file of this name is there already",
                     "save the project in another folder, or move that file away");
  }
  std::error_code error;
  fs::create_directories(target.parent_path(), error);
  fs::copy_file(source, target, error);
  if (error) throw InputError(target.string(), error.message(), "choose a folder that can be written");
}

void bring_files(const Project& project, const fs::path& from, const fs::path& to) {
  std::error_code unknown;
  if (from.empty() || from == to || fs::equivalent(from, to, unknown)) return;
  for (const Solid& solid : project.solids) {
    const std::string* file = file_of(solid.shape);
    if (file && fs::path(*file).is_relative()) bring_file(from / *file, to / *file);
  }
}

}  // namespace talus
