#include "output_file.hpp"

#include "command.hpp"
#include "io/whole_file.hpp"

namespace talus::cli {

void write_output(const std::filesystem::path& file, const std::string& bytes) {
  about(file, [&] { replace_whole_file(file, bytes); });
}

}  // namespace talus::cli
