#include "results/text_table.hpp"

#include <algorithm>
#include <charconv>

#include "base/error.hpp"
#include "results/folder.hpp"

namespace talus {

namespace {

/// The numbers of a line, or nothing when it is not `columns` numbers.
std::optional<std::vector<double>> parse(std::string_view line, std::size_t columns) {
  std::vector<double> row;
  const char *at = line.data(), *end = line.data() + line.size();
  while (row.size() < columns) {
    double value = 0;
    const auto [next, problem] = std::from_chars(at, end, value);
    if (problem != std::errc{}) return std::nullopt;
    row.push_back(value);
    at = next;
    if (row.size() == columns) break;
    if (at == end || *at != ',') return std::nullopt;
    ++at;
  }
  if (at != end) return std::nullopt;
  return row;
}

}  // namespace

TextTableWriter::TextTableWriter(std::filesystem::path file, const std::vector<std::string>& header)
    : path_(std::move(file)), stream_(path_, std::ios::binary | std::ios::trunc) {
  std::string line;
  for (const std::string& title : header) {
    if (!line.empty()) line += ',';
    line += csv_field(title);
  }
  write(line);
}

TextTableWriter::TextTableWriter(std::filesystem::path file, std::uint64_t size) : path_(std::move(file)) {
  cut_off(path_, size);
  stream_.open(path_, std::ios::binary | std::ios::app);
}

void TextTableWriter::add(const std::vector<double>& row) { write(csv_line(row)); }

void TextTableWriter::write(const std::string& line) {
  stream_ << line + '\n' << std::flush;
  if (!stream_) throw WriteError(path_);
}

std::vector<std::vector<double>> read_text_table(const std::filesystem::path& file, std::size_t columns) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(stream, line);
  for (int number = 2; std::getline(stream, line); ++number) {
    if (stream.eof()) break;  // no line break: torn
    if (auto row = parse(line, columns)) {
      rows.push_back(std::move(*row));
    } else {
      throw InputError(file.string() + ": line " + std::to_string(number),
                       "has not " + std::to_string(columns) + " numbers: the file is damaged",
                       "mend the line or remove it, or solve the project again");
    }
  }
  return rows;
}

std::optional<std::vector<double>> last_row(const std::filesystem::path& file, std::size_t columns) {
  const std::streamoff longest = 64 + 32 * static_cast<std::streamoff>(columns);  // of two lines, one torn
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return std::nullopt;
  const std::streamoff size = stream.tellg(), begin = std::max<std::streamoff>(0, size - 2 * longest);
  std::string end(static_cast<std::size_t>(size - begin), '\0');
  stream.seekg(begin);
  if (!stream.read(end.data(), size - begin)) return std::nullopt;
  end.resize(end.rfind('\n') + 1);  // what follows is torn; without a line break nothing is left
  if (end.empty()) return std::nullopt;
  const std::size_t before = end.rfind('\n', end.size() - 2);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return parse(std::string_view(end).substr(first, end.size() - 1 - first), columns);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted(1, '"');
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  quoted += '"';
  return quoted;
}

std::string csv_line(const std::vector<double>& row) {
  std::string line;
  char text[32];
  for (const double value : row) {
    if (!line.empty()) line += ',';
    line.append(text, std::to_chars(text, text + sizeof text, value).ptr);
  }
  return line;
}

}  // namespace talus
