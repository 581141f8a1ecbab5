#include "base/memory_limit.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/error.hpp"

namespace talus {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::atomic<double> told{unbounded};

/// The number behind a word at the start of a line; infinite where there is none.
double number_behind(const std::filesystem::path& file, const std::string& word) {
  std::ifstream stream(file);
  double number = 0;
  for (std::string read; stream >> read; stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (read == word && stream >> number) return number;
  return unbounded;
}

/// The only number of a file; infinite where it says "max", or is not there.
double number_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  double number = 0;
  return stream >> number ? number : unbounded;
}

/// What is left to the control group that the process is in, and to those around it (version 2); pages of files that
/// the system would give back count as left.
double left_to_group() {
  const std::filesystem::path root = "/sys/fs/cgroup";
  std::ifstream stream("/proc/self/cgroup");
  double left = unbounded;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("0::/")) continue;
    for (std::filesystem::path group = line.substr(4);; group = group.parent_path()) {
      const std::filesystem::path folder = root / group;
      const double most = number_in(folder / "memory.max"), now = number_in(folder / "memory.current");
      if (std::isfinite(most) && std::isfinite(now)) {
        const double given_back = number_behind(folder / "memory.stat", "inactive_file");
        left = std::min(left, most - now + (std::isfinite(given_back) ? given_back : 0));
      }
      if (group.empty()) break;
    }
  }
  return std::max(0.0, left);
}

double left_to_machine() {
  constexpr double kilobyte = 1024;
  return kilobyte * number_behind("/proc/meminfo", "MemAvailable:");
}

}  // namespace

MemoryLimit memory_limit() {
  if (std::isfinite(told)) return {told, true};
  return {std::min(left_to_machine(), left_to_group()), false};
}

void set_memory_limit(double bytes) { told = bytes; }

void require_memory(double bytes, const std::string& place, const std::string& work, const std::string& remedy) {
  const MemoryLimit limit = memory_limit();
  if (bytes <= limit.bytes) return;
  throw InputError(place,
                   work + " takes about " + bytes_text(bytes) + " of memory, and " +
                       (limit.told ? "--max-memory allows " : "this machine has ") + bytes_text(limit.bytes),
                   remedy + ", or allow more with --max-memory");
}

std::string bytes_text(double bytes) {
  constexpr std::array units = {"kB", "MB", "GB", "TB"};
  constexpr double thousand = 1000;
  std::size_t unit = 0;
  double count = bytes / thousand;
  for (; count >= thousand && unit + 1 < units.size(); ++unit) count /= thousand;
  const double digit = count > 0 ? std::pow(10.0, std::floor(std::log10(count)) - 1) : 1;
  char text[40];
  std::snprintf(text, sizeof text, count < 1e6 ? "%.*f %s" : "%.*e %s",
                count < 9.95  ? 1
                : count < 1e6 ? 0
                              : 1,
                digit * std::round(count / digit), units[unit]);
  return text;
}

std::optional<double> bytes_from(std::string_view text) {
  constexpr std::string_view units = "kMGT";
  double count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || !(count > 0) || !std::isfinite(count)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  while (text.starts_with(' ')) text.remove_prefix(1);
  if (!text.empty() && units.find(text.front()) != units.npos) {
    count *= std::pow(1000.0, static_cast<double>(units.find(text.front()) + 1));
    text.remove_prefix(1);
  }
  if (!text.empty() && text != "B") return std::nullopt;
  return count;
}

}  // namespace talus
