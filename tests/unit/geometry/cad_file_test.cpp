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

/// The box of tests/gui/box.brep with one piece of its text changed, and what is said of it.
class DamagedBrep : public CadFiles {
 protected:
  DamagedBrep() {
    std::ifstream stream(std::string(TALUS_SOURCE_DIR) + "/tests/gui/box.brep");
    sound_.assign(std::istreambuf_iterator<char>(stream), {});
  }

  /// The first place only.
  std::string error_with(const std::string& what, const std::string& by) {
    const std::size_t at = sound_.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    write("box.brep", std::string(sound_).replace(at, what.size(), by));
    return error_in("box.brep");
  }

  std::string sound_;
};

// Found by tests/fuzz: gmsh meshed an edge of 1e300 m for ever, and triangulated a face one of whose edges lies 2⁶³ m
// away in the plane of the face.
TEST_F(DamagedBrep, WithEdgesWithoutEndOrBesideTheirFacesIsRefused) {
  EXPECT_EQ(error_with("1 1 0\n1  2 0 0 8", "1 0 0\n1  2 0 -1e+300 8"),
            "box.brep: is damaged: an edge of its solid has no end; export the solid again");
  const std::string beside =
      "box.brep: is damaged: an edge of its solid does not lie on the faces beside it; export the solid again";
  EXPECT_EQ(error_with("1 0 0 1 0", "1 0 -9223372036854775808 1 0"), beside);
  EXPECT_EQ(error_with("1 0 0 1 0", "1 0 1 1 0"), beside);
}

// gmsh divided the edges to a corner that is 10¹⁷ m away, after it had asked whether so large a mesh is meant.
TEST_F(DamagedBrep, WithACornerBesideTheEndsOfItsEdgesIsRefused) {
  const std::string beside =
      "box.brep: is damaged: an edge of its solid does not end at its corners; export the solid again";
  EXPECT_EQ(error_with("Ve\n1e-07\n10 0 0\n", "Ve\n1e-07\n1e+17 0 0\n"), beside);
  EXPECT_EQ(error_with("Ve\n1e-07\n10 0 0\n", "Ve\n1e-07\n10 0 1\n"), beside);
}

// OpenCASCADE goes round for ever where a word is missing or no number: 8 s, until reading was given up.
TEST_F(DamagedBrep, SaysItsLineAtOnce) {
  const std::string again = "; export the solid again as BREP";
  EXPECT_EQ(error_with("Ve\n1e-07\n0 0 0\n", "Ve\n1e-07\n0  0\n"),
            "box.brep: line 67: is damaged: a number from 0 to 3 is expected, not '0101101'" + again);
  EXPECT_EQ(error_with("2  13 6", "2  13$6"),
            "box.brep: line 177: is damaged: a whole number is expected, not '13$6'" + again);
  EXPECT_EQ(error_with("1  12 0 0 10", "1  12 9223372036854775808 0 10"),
            "box.brep: line 239: is damaged: a whole number is expected, not '9223372036854775808'" + again);
  EXPECT_EQ(error_with("1  12 0 0 10", "1  13 0 0 10"),
            "box.brep: line 239: is damaged: a number from 0 to 12 is expected, not '13'" + again);
  EXPECT_EQ(error_with("+34 0 *", "+36 0 *"),
            "box.brep: line 77: is damaged: a shape that is in the file before is expected, not '+36'" + again);
  EXPECT_EQ(error_with("+34 0 *", "+33 0 *"),
            "box.brep: line 77: is damaged: a shape that is in the file before is expected, not '+33'" + again);
  EXPECT_EQ(error_with("-24 0 +34 0 *", std::string(300, '*')),
            "box.brep: line 209: is damaged: a word is too long" + again);
  EXPECT_EQ(error_with("10 8 0\n", "10 8 nan\n"),
            "box.brep: line 169: is damaged: a number is expected, not 'nan'" + again);
  EXPECT_EQ(error_with("Surfaces 6", "Surfaces 7"),
            "box.brep: line 52: is damaged: a whole number is expected, not 'Triangulations'" + again);
  EXPECT_EQ(error_with("2  2 2 0 0 6", "2  2 2 0 0 1180591620717411303424"),
            "box.brep: line 73: is damaged: an edge ends elsewhere on one of its curves" + again);
  sound_.resize(sound_.find("Sh\n"));
  EXPECT_THAT(error_with("", ""), HasSubstr("is damaged: it ends too early"));
}

/// A box with a round hole, turned: seams, circles and places of parts.
TEST_F(CadFiles, OfBrepWithCurvesAndPlacesAreRead) {
  std::filesystem::copy_file(std::string(TALUS_SOURCE_DIR) + "/tests/fuzz/corpus/brep/hole.brep", at("hole.brep"));
  constexpr double pi = 3.14159265358979;
  EXPECT_NEAR(surface_in("hole.brep").volume, 10 * 8 * 6 - pi * 2 * 2 * 6, 1e-6);
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
