#include <gmock/gmock.h>

#include <sstream>

#include "solid_files.hpp"

namespace talus {
namespace {

using namespace rock;
using testing::IsEmpty;
using testing::StartsWith;

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

std::string fields(const std::vector<std::string>& entries) {
  std::ostringstream line;
  for (const std::string& entry : entries) line << std::setw(8) << entry;
  return line.str();
}

/// Loose bilinear patches (entity 128), each by its four corners in order around it. `unit`: IGES's flag and name.
std::string iges_of(const std::vector<std::array<Vec3, 4>>& patches, const std::string& unit) {
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

std::vector<std::array<Vec3, 4>> faces_of_box(const Vec3& size) {
  const auto at = [&](int x, int y, int z) { return Vec3(x * size.x(), y * size.y(), z * size.z()); };
  return {{at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}, {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
          {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, {at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)},
          {at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)}, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}};
}

class CadFiles : public SolidFiles {};

TEST_F(CadFiles, OfLooseFacesAreSewnInTheirOwnUnit) {
  write("metres.igs", iges_of(faces_of_box({10, 8, 6}), "6,1HM"));
  const SolidSurface surface = surface_in("metres.igs");
  EXPECT_NEAR(surface.volume, 480, 1e-6);
  EXPECT_TRUE(surface.closed);
  EXPECT_TRUE(surface.max.isApprox(Vec3(10, 8, 6), 1e-6));
  write("millimetres.iges", iges_of(faces_of_box({10000, 8000, 6000}), "2,2HMM"));
  EXPECT_NEAR(surface_in("millimetres.iges").volume, 480, 1e-6);
}

TEST_F(CadFiles, OfSeveralFormatsKeepTheirUnitsInOneProject) {
  std::filesystem::copy_file(std::string(TALUS_SOURCE_DIR) + "/samples/step_slope/slope.step", at("slope.step"));
  write("box.igs", iges_of(faces_of_box({10, 8, 6}), "6,1HM"));
  NoProgress nobody;
  const auto surfaces = solid_surfaces(
      project_of({solid("slope", FileShape{"slope.step"}), solid("box", FileShape{"box.igs"})}), folder(), nobody);
  EXPECT_NEAR(surfaces[0].max.z() - surfaces[0].min.z(), 100, 1e-6);
  EXPECT_NEAR(surfaces[1].volume, 480, 1e-6);
}

TEST_F(CadFiles, AreTurnedMovedAndLessTheOrigin) {
  write("box.igs", iges_of(faces_of_box({4, 2, 1}), "6,1HM"));
  Solid turned = solid("box", FileShape{"box.igs", 1});
  turned.turn = Turn{Vec3::UnitZ(), 90, Vec3::Zero()};
  turned.move = {0, 0, 5};
  const SolidSurface surface = surface_of(turned, Vec3(1, 0, 0));
  EXPECT_TRUE(surface.min.isApprox(Vec3(-2, -1, 5), 1e-6)) << surface.min.transpose();
  EXPECT_TRUE(surface.max.isApprox(Vec3(0, 3, 6), 1e-6)) << surface.max.transpose();
  EXPECT_NEAR(surface.volume, 8, 1e-6);
}

TEST_F(CadFiles, OfFacesThatDoNotCloseAreRefused) {
  auto faces = faces_of_box({10, 8, 6});
  faces.pop_back();
  write("open.igs", iges_of(faces, "6,1HM"));
  EXPECT_EQ(error_in("open.igs"), "open.igs: holds surfaces but no closed solid; export a closed solid");
}

TEST_F(CadFiles, ThatAreNoneAreRefused) {
  for (const auto& [name, format] : {std::pair("a.brep", "BREP"), {"a.igs", "IGES"}, {"a.stp", "STEP"}}) {
    write(name, "this is rubbish\n");
    EXPECT_EQ(error_in(name),
              std::string(name) + ": is not a readable " + format + " file; export the solid again as " + format);
  }
}

/// A slope with a pit whose wall is curved.
TEST_F(CadFiles, OfCurvedFacesAreShownByTriangles) {
  std::filesystem::copy_file(std::string(TALUS_SOURCE_DIR) + "/samples/step_slope/slope.step", at("slope.step"));
  const SolidSurface surface = surface_in("slope.step");
  EXPECT_TRUE(surface.closed);
  EXPECT_THAT(surface.findings, IsEmpty());
  double within = 0;
  for (const auto& [a, b, c] : surface.triangles)
    within += surface.vertices[a].dot(surface.vertices[b].cross(surface.vertices[c])) / 6;
  EXPECT_NEAR(within, surface.volume, 2e-3 * surface.volume);
  EXPECT_LT(surface.triangles.size(), 20000u);
}

}  // namespace
}  // namespace talus
