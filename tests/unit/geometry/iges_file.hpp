#pragma once

#include <array>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "base/vector.hpp"

/// An IGES file as tests write it.
namespace talus::rock {

/// Lines of a section of an IGES file: 72 columns, its letter and a number.
class IgesSection {
 public:
  explicit IgesSection(char letter) : letter_(letter) {}
  void add(const std::string& text) {
    std::ostringstream line;
    line << std::left << std::setw(72) << text << letter_ << std::right << std::setw(7) << ++count_ << "\n";
    text_ += line.str();
  }
  int count() const { return count_; }
  const std::string& text() const { return text_; }

 private:
  char letter_;
  int count_ = 0;
  std::string text_;
};

inline std::string fields(const std::vector<std::string>& entries) {
  std::ostringstream line;
  for (const std::string& entry : entries) line << std::setw(8) << entry;
  return line.str();
}

/// Loose bilinear patches (entity 128), each by its four corners in order around it. `unit`: IGES's flag and name.
inline std::string iges_of(const std::vector<std::array<Vec3, 4>>& patches, const std::string& unit) {
  IgesSection start('S'), global('G'), directory('D'), parameters('P');
  start.add("loose faces");
  global.add("1H,,1H;,5Htalus,5Htalus,5Htalus,5Htalus,32,38,6,308,15,5Htalus,1.0,");
  global.add(unit + ",1,0.01,15H20260101.000000,1E-7,100.0,5Htalus,5Htalus,11,0;");
  for (const auto& patch : patches) {
    const int pointer = parameters.count() + 1, entry = directory.count() + 1;
    std::vector<std::string> lines{"128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,"};
    for (const int corner : {0, 1, 3, 2}) {
      std::ostringstream point;
      point << std::fixed << std::setprecision(6);
      for (int k = 0; k < 3; ++k) point << patch[corner][k] << ",";
      lines.push_back(point.str());
    }
    lines.push_back("0.,1.,0.,1.;");
    for (const std::string& line : lines) {
      std::ostringstream text;
      text << std::left << std::setw(64) << line << std::right << std::setw(8) << entry;
      parameters.add(text.str());
    }
    directory.add(fields({"128", std::to_string(pointer), "0", "0", "0", "0", "0", "0"}) + "00000000");
    directory.add(fields({"128", "0", "0", std::to_string(lines.size()), "0", "", "", "", "0"}).substr(0, 72));
  }
  IgesSection end('T');
  std::ostringstream counts;
  for (const IgesSection* section : {&start, &global, &directory, &parameters})
    counts << "SGDP"[counts.str().size() / 8] << std::setw(7) << section->count();
  end.add(counts.str());
  return start.text() + global.text() + directory.text() + parameters.text() + end.text();
}

inline std::vector<std::array<Vec3, 4>> faces_of_box(const Vec3& size) {
  const auto at = [&](int x, int y, int z) { return Vec3(x * size.x(), y * size.y(), z * size.z()); };
  return {{at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}, {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
          {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, {at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)},
          {at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)}, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}};
}

}  // namespace talus::rock
