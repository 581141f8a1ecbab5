#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "iges_file.hpp"
#include "solid_files.hpp"

namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

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

TEST_F(CadFiles, WithoutEndAreRefused) {
  // Found by tests/fuzz: gmsh meshed an edge of 1e300 m for ever, and OpenCASCADE read for ever where a number is
  // missing.
  std::ifstream stream(std::string(TALUS_SOURCE_DIR) + "/tests/gui/box.brep");
  const std::string sound(std::istreambuf_iterator<char>(stream), {});
  const auto damaged = [&](const std::string& what, const std::string& by) {
    const std::size_t at = sound.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    write("box.brep", std::string(sound).replace(at, what.size(), by));
    return error_in("box.brep");
  };
  EXPECT_THAT(damaged("1  2 0 0 8", "1  2 0 -1e+300 8"),
              StartsWith("box.brep: is damaged: an edge of its solid has no "));
  EXPECT_THAT(damaged("Ve\n1e-07\n0 0 0\n", "Ve\n1e-07\n0  0\n"), HasSubstr("crashed while reading"));
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
