#include <gmock/gmock.h>

#include "solid_files.hpp"

namespace talus {
namespace {

using namespace rock;
using Kind = SurfaceFinding::Kind;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class SurfaceFiles : public SolidFiles {};

TEST_F(SurfaceFiles, OfEveryFormatHaveTheirVolume) {
  const Surface ball = sphere(5, 3);
  write_stl("ball.stl", ball);
  write_binary_stl("binary.STL", ball);
  write_obj("ball.obj", ball);
  const double volume = volume_of(ball);
  for (const char* name : {"ball.stl", "binary.STL", "ball.obj"}) {
    SCOPED_TRACE(name);
    const SolidSurface surface = surface_in(name);
    EXPECT_NEAR(surface.volume, volume, (std::string(name) == "binary.STL" ? 1e-6 : 1e-12) * volume);
    EXPECT_EQ(surface.triangles.size(), 512u);
    EXPECT_EQ(surface.vertices.size(), 258u);
    EXPECT_TRUE(surface.closed);
    EXPECT_THAT(surface.findings, IsEmpty());
    EXPECT_THAT(surface.edges, IsEmpty());
    EXPECT_NEAR(surface.max.z(), 5, 1e-6);
  }
}

TEST_F(SurfaceFiles, OfPolygonsAreReadToo) {
  write("cube.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  EXPECT_DOUBLE_EQ(surface_in("cube.obj", 2).volume, 8);
  write("pyramid.ply",
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 5\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 2\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n");
  EXPECT_NEAR(surface_in("pyramid.ply").volume, 9 * 2 / 3.0, 1e-12);
  write("tet.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 3\n$EndNodes\n"
        "$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n");
  const SolidSurface tet = surface_in("tet.msh");
  EXPECT_NEAR(tet.volume, 0.5, 1e-12);
  EXPECT_THAT(tet.findings, IsEmpty());
}

TEST_F(SurfaceFiles, ThatAreInsideOutAreTurned) {
  write_stl("in.stl", turned(cube_surface()));
  const SolidSurface surface = surface_in("in.stl");
  EXPECT_NEAR(surface.volume, 1000, 1e-9);
  EXPECT_EQ(found(surface, Kind::inside_out), 12);
  Surface mixed = cube_surface();
  std::swap(mixed.triangles[4][0], mixed.triangles[4][1]);
  write_stl("mixed.stl", mixed);
  EXPECT_EQ(found(surface_in("mixed.stl"), Kind::inside_out), 1);
}

TEST_F(SurfaceFiles, WithSmallHolesAreFilled) {
  Surface ball = sphere(5, 4);
  ball.triangles.erase(ball.triangles.begin() + 100);
  write_stl("hole.stl", ball);
  const SolidSurface surface = surface_in("hole.stl");
  EXPECT_EQ(found(surface, Kind::hole), 1);
  EXPECT_TRUE(surface.closed);
  EXPECT_NEAR(surface.volume, volume_of(sphere(5, 4)), 1e-9);
}

TEST_F(SurfaceFiles, WithLargeHolesAreShownAndNotCut) {
  Surface open = cube_surface();
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);  // the lid
  write_stl("open.stl", open);
  const SolidSurface surface = surface_in("open.stl");
  EXPECT_FALSE(surface.closed);
  EXPECT_EQ(surface.triangles.size(), 10u);
  EXPECT_EQ(surface.edges.size(), 12u);
  EXPECT_EQ(found(surface, Kind::hole), -1);
  ASSERT_EQ(surface.findings.size(), 1u);
  EXPECT_TRUE(surface.findings[0].where.isApprox(Vec3(5, 5, 10), 1e-9));
  const Project p = project_of({solid("rock", FileShape{"open.stl"})});
  EXPECT_EQ(error_of(p, folder()),
            "open.stl: its surface has 1 hole, around (5, 5, 10); close the surface where it was made, and export it "
            "again");
  NoProgress nobody;
  const std::vector<InputError> broken = broken_files(p, folder(), nobody);
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_THAT(broken[0].what(), StartsWith("/solids/0/file: open.stl: its surface has 1 hole"));
}

TEST_F(SurfaceFiles, OfTerrainAreToldOfAtTheirSolidOnce) {
  write("land.xyz", "0 0 10\n10 0 10\n0 10 10\n10 10 12\n");
  NoProgress nobody;
  const std::vector<InputError> broken =
      broken_files(project_of({solid("hill", TerrainShape{.path = "land.xyz", .base = 20})}), folder(), nobody);
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_THAT(broken[0].what(), StartsWith("/solids/0/terrain"));
  EXPECT_EQ(broken[0].remedy(), "give a lower base");
  EXPECT_THAT(broken[0].problem(), testing::Not(HasSubstr("solid hill")));
}

TEST_F(SurfaceFiles, ThatCrossThemselvesAreRefusedWithThePlace) {
  write_stl("crossing.stl", together(cube_surface(), cube_surface({5, 5, 5}, {15, 15, 15})));
  const SolidSurface surface = surface_in("crossing.stl");
  EXPECT_LT(found(surface, Kind::self_intersection), 0);
  EXPECT_THAT(error_of(project_of({solid("rock", FileShape{"crossing.stl"})}), folder()),
              AllOf(StartsWith("crossing.stl: its surface has "), HasSubstr("pairs of faces that cross, around (")));
}

TEST_F(SurfaceFiles, WithFaultsOfExportAreMended) {
  Surface rough = cube_surface();
  rough.points.push_back(Vec3(10, 10, 10) + Vec3(2e-6, 0, 0));  // a corner again, a little off
  rough.triangles[2][2] = 8;
  rough.triangles.push_back({0, 1, 1});  // without area
  rough.triangles.push_back({0, 2, 3});  // twice
  write_obj("rough.obj", rough);
  const SolidSurface surface = surface_in("rough.obj");
  EXPECT_NEAR(surface.volume, 1000, 1e-9);
  EXPECT_EQ(surface.vertices.size(), 8u);
  EXPECT_EQ(found(surface, Kind::duplicate_vertex), 1);
  EXPECT_EQ(found(surface, Kind::degenerate_face), 2);
  EXPECT_TRUE(surface.closed);
}

TEST_F(SurfaceFiles, OfFacesWithoutAreaAloneAreRefused) {
  // Found by tests/fuzz: CGAL looked for the outside of no faces at all.
  Surface flat;
  flat.points = {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 1}, {1, 2, 2}, {2, 2, 0}};
  write_stl("flat.stl", flat);
  for (const SolidShape& shape : {SolidShape(FileShape{"flat.stl"}), SolidShape(TerrainShape{"flat.stl", -5, 0})})
    EXPECT_THAT(error_of(project_of({solid("rock", shape)}), folder()),
                StartsWith("flat.stl: all of its faces are without area; "));
}

TEST_F(SurfaceFiles, WithPointsThatNoFaceNeedsAreReadWithoutThem) {
  // Found by tests/fuzz: CGAL asked for the faces of a point that has none, once there were faces without area, too.
  Surface lost = cube_surface();
  lost.points.emplace_back(20, 20, 20);
  lost.points.emplace_back(21, 20, 20);
  lost.triangles.push_back({8, 9, 9});
  Surface split = lost;  // an edge has a point in its middle, and a face without area beside it
  split.points.emplace_back(5, 0, 0);
  split.triangles[1] = {0, 3, 10};
  split.triangles.push_back({10, 3, 1});
  split.triangles.push_back({0, 10, 1});
  for (const Surface& surface : {lost, split}) {
    write_obj("point.obj", surface);
    const SolidSurface read = surface_in("point.obj");
    EXPECT_NEAR(read.volume, 1000, 1e-9);
    EXPECT_LE(read.vertices.size(), 9u);
    EXPECT_TRUE(read.closed);
  }
}

TEST_F(SurfaceFiles, OfAPropertyWithoutAnElementAreRefused) {
  // Found by tests/fuzz: CGAL looked at the last of no elements.
  write("lost.ply",
        "ply\nformat ascii 1.0\nel#ement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_THAT(error_of(project_of({solid("rock", FileShape{"lost.ply"})}), folder()),
              StartsWith("lost.ply: is not a readable PLY file"));
}

TEST_F(SurfaceFiles, MayHoldSeveralBodiesAndCavities) {
  write_stl("two.stl", together(cube_surface(), cube_surface({20, 0, 0}, {21, 1, 1})));
  const SolidSurface two = surface_in("two.stl");
  EXPECT_EQ(found(two, Kind::several_bodies), 2);
  EXPECT_NEAR(two.volume, 1001, 1e-9);
  // The inner cube is a cavity, however it is turned.
  write_stl("hollow.stl", together(cube_surface(), cube_surface({4, 4, 4}, {6, 6, 6})));
  const SolidSurface hollow = surface_in("hollow.stl");
  EXPECT_NEAR(hollow.volume, 992, 1e-9);
  EXPECT_EQ(found(hollow, Kind::several_bodies), 0);
}

TEST_F(SurfaceFiles, OfFewPlanesAreCutAndMeshed) {
  write_stl("cube.stl", cube_surface());
  Project p = project_of({solid("rock", FileShape{"cube.stl"}, 4)});
  p.cuts = {cut("J1", 30, 90, {5, 5, 5})};
  const BlockSystem system = build(p, folder());
  EXPECT_EQ(system.blocks.size(), 2u);
  expect_sound(system, 1000);
}

TEST_F(SurfaceFiles, OfSeveralBodiesAreBlocksEach) {
  write_stl("rock.stl", together(cube_surface(), cube_surface({20, 0, 0}, {22, 2, 2})));
  const BlockSystem system = build(project_of({solid("rock", FileShape{"rock.stl"}, 5)}), folder());
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_EQ(system.blocks[1].name, "rock.2");
  expect_sound(system, 1008);
}

TEST_F(SurfaceFiles, WithCavitiesAreMeshedAroundThem) {
  write_stl("hollow.stl", together(cube_surface(), cube_surface({4, 4, 4}, {6, 6, 6})));
  const BlockSystem system = build(project_of({solid("rock", FileShape{"hollow.stl"}, 5)}), folder());
  ASSERT_EQ(system.blocks.size(), 1u);
  expect_sound(system, 992);
}

TEST_F(SurfaceFiles, AreTurnedAndMoved) {
  write_stl("bar.stl", cube_surface({0, 0, 0}, {4, 2, 1}));
  Solid bar = solid("bar", FileShape{"bar.stl", 0.5});
  bar.turn = Turn{Vec3::UnitZ(), 90, Vec3(1, 0, 0)};
  bar.move = {0, 0, 10};
  const SolidSurface surface = surface_of(bar, Vec3(0, 0, 100));
  EXPECT_TRUE(surface.min.isApprox(Vec3(0, -1, -90), 1e-12)) << surface.min.transpose();
  EXPECT_TRUE(surface.max.isApprox(Vec3(1, 1, -89.5), 1e-12)) << surface.max.transpose();
}

TEST_F(SurfaceFiles, ThatAreNoneAreRefused) {
  for (const char* name : {"a.stl", "a.obj", "a.ply", "a.msh"}) {
    write(name, "this is rubbish\nand more of it\n");
    EXPECT_THAT(error_in(name), StartsWith(std::string(name) + ": is not a readable ")) << name;
    write(name, "");
    EXPECT_THAT(error_in(name), StartsWith(std::string(name) + ": is not a readable ")) << name;
  }
  EXPECT_EQ(error_in("missing.stl"), "missing.stl: there is no such file; correct the path of solid rock");
  write("nowhere.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  EXPECT_THAT(error_in("nowhere.obj"), StartsWith("nowhere.obj: is damaged"));
  write_binary_stl("whole.stl", cube_surface());
  std::filesystem::resize_file(at("whole.stl"), 84 + 50 * 7 + 20);
  EXPECT_THAT(error_in("whole.stl"), StartsWith("whole.stl: is "));
}

}  // namespace
}  // namespace talus
