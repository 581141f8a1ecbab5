#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// A CSV file that grows line by line. Each line leaves the program whole, so a kill costs none that was written.
class TextTableWriter {
 public:
  /// Makes the file with its header. Throws WriteError, as `add` does.
  TextTableWriter(std::filesystem::path file, const std::vector<std::string>& header);
  /// Goes on in a file behind its first `size` bytes, which end a line; what follows them is cut off.
  TextTableWriter(std::filesystem::path file, std::uint64_t size);
  void add(const std::vector<double>& row);

 private:
  void write(const std::string& line);

  std::filesystem::path path_;
  std::ofstream stream_;
};

/// The rows of numbers below the header, those of `columns` numbers; a last line that is torn is left out.
/// A file that is missing has no rows. Throws InputError for another line that is not `columns` numbers.
std::vector<std::vector<double>> read_text_table(const std::filesystem::path& file, std::size_t columns);

/// The last row that is whole, found without reading those before; none where there is none or it is damaged.
std::optional<std::vector<double>> last_row(const std::filesystem::path& file, std::size_t columns);

/// A CSV field, in quotes when it holds a comma, a quote or a line break (RFC 4180).
std::string csv_field(const std::string& text);

/// Numbers as the shortest decimals that read back exactly, with commas between.
std::string csv_line(const std::vector<double>& row);

}  // namespace talus
