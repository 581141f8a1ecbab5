#include "export/export_folder.hpp"

#include <fstream>
#include <numeric>

#include "base/error.hpp"

namespace talus {

namespace fs = std::filesystem;

void prepare_export_folder(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) throw InputError(folder.string(), "cannot be made: " + problem.message(), "choose another --out");
  if (!fs::is_empty(folder))
    throw InputError(folder.string(), "is not empty", "choose another --out, or empty it first");
}

std::string numbered_name(const std::string& name, int frame, const std::string& ending) {
  const std::string number = std::to_string(frame);
  return name + '_' + std::string(number.size() < 5 ? 5 - number.size() : 0, '0') + number + ending;
}

void write_export_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  write(stream);
  stream.close();
  if (!stream) throw InputError(file.string(), "cannot be written", "free space on the disk or choose another --out");
}

void for_each_frame(const ResultReader& results, std::span<const int> numbers, Progress& progress,
                    const std::function<void(const Frame&)>& write) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (progress.cancelled()) throw Cancelled{};
    progress.report(static_cast<double>(i) / static_cast<double>(numbers.size()),
                    "frame " + std::to_string(i + 1) + " of " + std::to_string(numbers.size()));
    write(results.frame(numbers[i]));
  }
}

std::vector<int> all_frames(const ResultReader& results) {
  std::vector<int> numbers(results.frame_times().size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace talus
