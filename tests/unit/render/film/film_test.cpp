#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "mesh/structured_mesh.hpp"
#include "render/film/camera_path.hpp"
#include "render/film/film_pictures.hpp"
#include "unit/results/example_results.hpp"

// Which frame a film shows when, and from where.
namespace talus {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

std::vector<int> frames_of(const std::vector<double>& times, double speed, int rate) {
  if (times.empty()) return frames_of_pictures(times, {});
  return frames_of_pictures(times, {times.front(), times.back(), speed, rate});
}

TEST(FilmPictures, LastAsLongAsTheMotionInRealTime) {
  const std::vector<double> times{0, 0.1, 0.2, 0.3, 0.4, 0.5};
  EXPECT_THAT(frames_of(times, 1, 10), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(frames_of(times, 1, 20), SizeIs(11)) << "half a second and the first";
  EXPECT_THAT(frames_of(times, 2, 10), ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(frames_of(times, 0.5, 10), SizeIs(11));
}

TEST(FilmPictures, ShowTheFrameThatIsNearest) {
  const std::vector<double> times{0, 1, 1.1, 4};  // seconds are not as long as each other
  EXPECT_THAT(frames_of(times, 1, 1), ElementsAre(0, 1, 2, 3, 3));
  const std::vector<double> one{2};
  EXPECT_THAT(frames_of(one, 1, 25), ElementsAre(0));
  EXPECT_THAT(frames_of({}, 1, 25), SizeIs(0));
}

TEST(FilmPictures, OfSeveralResultsHaveOneClock) {
  const std::vector<double> longer{0, 1, 2, 3}, later{1, 2};
  const FilmClock clock{0, 3, 1, 2};
  EXPECT_THAT(frames_of_pictures(longer, clock), ElementsAre(0, 1, 1, 2, 2, 3, 3));
  EXPECT_THAT(frames_of_pictures(later, clock), ElementsAre(0, 0, 0, 1, 1, 1, 1));
}

TEST(FilmPictures, RefuseASpeedThatIsNone) {
  const std::vector<double> times{0, 1};
  for (const double speed : {0.0, -1.0, std::nan(""), 1e-9}) EXPECT_THROW(frames_of(times, speed, 25), InputError);
}

BlockSystem one_box() {
  Block block;
  block.mesh = box_mesh({0, 0, 0}, {2, 2, 2}, 1, 1, 1);
  return {.blocks = {block}, .joint_names = {}};
}

Frame moved(const Vec3& by, double time = 0) {
  Frame frame;
  frame.time = time;
  frame.displacement.assign(8, by);
  return frame;
}

CameraPose held() {
  CameraPose pose;
  pose.position = Vec3(0, -100, 0);
  pose.focal_point = Vec3::Zero();
  pose.view_up = Vec3::UnitZ();
  return pose;
}

TEST(CameraPath, OfNothingStandsStill) {
  const CameraPath path({}, one_box(), held());
  EXPECT_TRUE(path.stands_still());
  EXPECT_EQ(path.pose(moved({5, 5, 5}), 1).position, held().position);
}

TEST(CameraPath, TurnsAboutWhatItLooksAt) {
  CameraMoves moves;
  moves.turn = 180;
  const CameraPath path(moves, one_box(), held());
  EXPECT_FALSE(path.stands_still());
  EXPECT_NEAR((path.pose(moved({0, 0, 0}), 0.5).position - Vec3(100, 0, 0)).norm(), 0, 1e-9) << "90° from south";
  EXPECT_NEAR((path.pose(moved({0, 0, 0}), 1).position - Vec3(0, 100, 0)).norm(), 0, 1e-9);
}

TEST(CameraPath, KeepsABlockInTheMiddle) {
  CameraMoves moves;
  moves.follow = 0;
  const CameraPath path(moves, one_box(), held());
  EXPECT_NEAR((path.pose(moved({0, 0, 0}), 0).focal_point - Vec3(1, 1, 1)).norm(), 0, 1e-9);
  const CameraPose later = path.pose(moved({10, 0, -20}), 1);
  EXPECT_NEAR((later.focal_point - Vec3(11, 1, -19)).norm(), 0, 1e-9);
  EXPECT_NEAR((later.position - later.focal_point).normalized().dot(-Vec3::UnitY()), 1, 1e-9) << "from the same side";
  EXPECT_LT((later.position - later.focal_point).norm(), 100) << "nearer";
}

TEST(CameraPath, GoesThroughItsKeys) {
  CameraMoves moves;
  moves.keys = {{0, {0, -10, 0}, {0, 0, 0}}, {1, {10, -10, 0}, {0, 0, 0}}, {3, {30, -10, 0}, {0, 0, 6}}};
  const CameraPath path(moves, one_box(), held());
  for (const CameraKey& key : moves.keys) {
    EXPECT_NEAR((path.pose(moved({0, 0, 0}, key.time), 0).position - key.position).norm(), 0, 1e-9) << key.time;
    EXPECT_NEAR((path.pose(moved({0, 0, 0}, key.time), 0).focal_point - key.focal_point).norm(), 0, 1e-9);
  }
  EXPECT_NEAR((path.pose(moved({0, 0, 0}, 0.5), 0).position - Vec3(5, -10, 0)).norm(), 0, 1.3) << "in between";
  EXPECT_EQ(path.pose(moved({0, 0, 0}, 9), 1).position, Vec3(30, -10, 0)) << "stays at the last";
}

TEST(CameraKeys, AreReadFromATable) {
  const TemporaryFolder folder;
  const auto file = folder.path / "keys.csv";
  const auto write = [&](const std::string& rows) { std::ofstream(file) << "time,x,y,z,to x,to y,to z\n" << rows; };
  write("0,1,2,3,4,5,6\n2.5,1,2,3,4,5,7\n");
  const std::vector<CameraKey> keys = read_camera_keys(file);
  ASSERT_THAT(keys, SizeIs(2));
  EXPECT_EQ(keys[1].time, 2.5);
  EXPECT_EQ(keys[1].focal_point, Vec3(4, 5, 7));
  write(camera_keys_csv(keys).substr(camera_keys_csv(keys).find('\n') + 1));
  EXPECT_EQ(read_camera_keys(file)[1].focal_point, keys[1].focal_point) << "written back";
  for (const char* wrong : {"", "0,1,2,3\n", "1,0,0,0,1,1,1\n1,0,0,0,1,1,1\n", "0,1,1,1,1,1,1\n"}) {
    write(wrong);
    EXPECT_THROW(read_camera_keys(file), InputError) << wrong;
  }
  EXPECT_THROW(read_camera_keys(folder.path / "none.csv"), InputError);
}

}  // namespace
}  // namespace talus
