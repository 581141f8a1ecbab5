// Lines of blocks and of their meshes, as the window draws them: one sample a pixel.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "images/test_scenes.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/scene.hpp"

namespace talus {
namespace {

using Pixel = Eigen::Vector2d;

/// A line of the mesh on the screen.
struct SeenLine {
  Pixel from, to;
  Vec3 normal;  ///< of a face on its one side
  double length() const { return (to - from).norm(); }
  Pixel at(double along) const { return from + along / length() * (to - from); }
  bool is_nearer(const Pixel& p, double distance) const {
    const auto outside = [distance](double at, double one, double other) {
      return at < std::min(one, other) - distance || at > std::max(one, other) + distance;
    };
    if (outside(p.x(), from.x(), to.x()) || outside(p.y(), from.y(), to.y())) return false;
    const double along = std::clamp((p - from).dot(to - from) / length(), 0.0, length());
    return (p - at(along)).norm() < distance;
  }
};

/// Those on the faces of a convex block that look at the viewer; twice where both faces beside them do.
std::vector<SeenLine> seen_lines(const Scene& scene, const Block& block) {
  const CameraPose pose = scene.pose();
  std::vector<SeenLine> lines;
  for (const SurfaceTriangle& triangle : block.surface) {
    const auto corner = [&](int i) -> const Vec3& {
      return block.mesh.nodes[static_cast<std::size_t>(triangle.nodes[static_cast<std::size_t>(i % 3)])];
    };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (normal.dot(pose.position - pose.focal_point) <= 0) continue;
    for (int i = 0; i < 3; ++i) {
      const auto from = *scene.pixel_of(corner(i)), to = *scene.pixel_of(corner(i + 1));
      lines.push_back({{from[0], from[1]}, {to[0], to[1]}, normal.normalized()});
    }
  }
  return lines;
}

/// Those within a flat face, each once: what is on their two sides is equally bright.
std::vector<SeenLine> inner(const std::vector<SeenLine>& lines) {
  std::vector<SeenLine> found;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const SeenLine &one = lines[i], &other = lines[k];
      const double apart = (one.from - other.to).norm() + (one.to - other.from).norm();
      if (apart < 1e-6 && one.normal.dot(other.normal) > 0.999) found.push_back(one);
    }
  return found;
}

/// How much darker a pixel is with lines than without, of 255.
class Ink {
 public:
  Ink(const Image& with, const Image& without) : with_(with), without_(without) {}
  double at(int x, int y) const { return grey(without_.at(x, y)) - grey(with_.at(x, y)); }
  /// Of the pixels around a place.
  double most(const Pixel& place) const {
    const int x = static_cast<int>(std::floor(place.x())), y = static_cast<int>(std::floor(place.y()));
    return std::max({at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)});
  }

 private:
  static double grey(Rgb c) { return (c.red + c.green + c.blue) / 3.0; }
  const Image &with_, &without_;
};

/// A cube whose top and one of whose sides are seen at flat angles: the mesh of its picture, with and without lines.
class LinesImage : public testing::TestWithParam<std::array<double, 2>> {
 protected:
  void SetUp() override {
    SceneSettings settings;
    settings.legend = settings.triad = settings.scale_bar = false;
    settings.parallel_projection = true;
    settings.edges = Edges::none;
    settings.smooth_outlines = false;
    cube_.blocks = {box("B", {0, 0, 0}, {1, 1, 1}, 4, BodyKind::tetrahedra)};
    Scene scene(cube_, settings);
    scene.look(GetParam()[0], GetParam()[1]);
    OffscreenView view(scene, 800, 500, Sampling::fast);
    without_ = view.draw();
    settings.edges = Edges::mesh;
    scene.set_settings(settings);
    with_ = view.draw();
    lines_ = seen_lines(scene, cube_.blocks.front());
  }

  BlockSystem cube_;
  Image with_, without_;
  std::vector<SeenLine> lines_;
};

TEST_P(LinesImage, OfAMeshAreWholeHoweverTheirFaceLies) {
  const Ink ink(with_, without_);
  int places = 0, broken = 0;
  for (const SeenLine& line : inner(lines_)) {
    constexpr double corner = 4;  // pixels: other lines meet there
    std::vector<double> along;
    for (double s = corner; s < line.length() - corner; ++s) along.push_back(ink.most(line.at(s)));
    if (along.size() < 8) continue;
    std::vector<double> sorted = along;
    std::ranges::sort(sorted);
    const double usual = sorted[sorted.size() / 2];
    EXPECT_GT(usual, 3) << line.from.transpose() << " to " << line.to.transpose();
    places += static_cast<int>(along.size());
    broken += static_cast<int>(std::ranges::count_if(along, [&](double one) { return one < 0.4 * usual; }));
  }
  EXPECT_GT(places, 3000);
  EXPECT_LT(broken, 0.002 * places);
}

/// Neither through the rock nor over its outline: what lies behind has no lines.
TEST_P(LinesImage, AreDrawnWhereFacesAreSeenAndNowhereElse) {
  const Ink ink(with_, without_);
  constexpr double beside = 2.1;  // pixels
  int stray = 0;
  for (int y = 0; y < with_.height; ++y)
    for (int x = 0; x < with_.width; ++x) {
      if (std::abs(ink.at(x, y)) < 8) continue;
      const Pixel place(x, y);
      stray += std::ranges::none_of(lines_, [&](const SeenLine& line) { return line.is_nearer(place, beside); });
    }
  EXPECT_EQ(stray, 0);
}

/// Drawn all or nothing, a line at half a right angle is one pixel wide here and two there, and looks dashed.
TEST_P(LinesImage, AreAsDarkAllTheWay) {
  const Ink ink(with_, without_);
  for (const SeenLine& line : inner(lines_)) {
    const Pixel along = (line.to - line.from) / line.length();
    if (line.length() < 60 || std::min(std::abs(along.x()), std::abs(along.y())) < 0.3) continue;
    const bool flat = std::abs(along.x()) > std::abs(along.y());
    double least = 1e9, most = 0;
    for (double s = 0.3 * line.length(); s < 0.7 * line.length(); ++s) {  // far from where others meet
      const Pixel place = line.at(s);
      double across = 0;
      for (int i = -2; i <= 2; ++i)
        across += ink.at(static_cast<int>(std::lround(place.x())) + (flat ? 0 : i),
                         static_cast<int>(std::lround(place.y())) + (flat ? i : 0));
      least = std::min(least, across), most = std::max(most, across);
    }
    EXPECT_LT(most, 1.5 * least) << line.from.transpose() << " to " << line.to.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Views, LinesImage,
                         testing::Values(std::array{150.0, 8.0}, std::array{172.0, 30.0}, std::array{96.0, 12.0},
                                         std::array{137.0, 20.0}, std::array{200.0, 5.0}));

/// Of rock whose faces are all left out.
TEST(LinesImage, OfRockThatIsLeftOutAreSeenOnEitherBackground) {
  const BlockSystem slope = jointed_slope();
  const auto frame = slid(slope, 14, 45);
  for (const Theme theme : {Theme::light, Theme::dark}) {
    SceneSettings settings;
    settings.theme = theme;
    settings.field = field_named("displacement");
    settings.only = ValueRange{100, 200};
    settings.legend = settings.triad = settings.scale_bar = settings.time_stamp = false;
    Scene scene(slope, settings);
    scene.set_frame(frame);
    const Image image = draw_image(scene, 640, 400);
    int seen = 0;
    for (int y = 0; y < image.height; ++y) {
      const auto brightness = [&](int x) {
        const auto* pixel = &image.rgb[static_cast<std::size_t>(3 * (y * image.width + x))];
        return (2 * pixel[0] + 5 * pixel[1] + pixel[2]) / 8;
      };
      for (int x = 1; x < image.width; ++x) seen += std::abs(brightness(x) - brightness(0)) > 40;
    }
    EXPECT_GT(seen, 1000) << (theme == Theme::dark ? "dark" : "light");
  }
}

}  // namespace
}  // namespace talus
