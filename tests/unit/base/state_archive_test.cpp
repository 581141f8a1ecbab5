#include "base/state_archive.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace talus {
namespace {

enum class Kind { first, second };

struct Inner {
  int number = 0;
  Vec3 vector = Vec3::Zero();
  void archive(auto& state) { state(number, vector); }
};

/// One of each kind that a state may hold.
struct Everything {
  double real = 0;
  bool flag = false;
  Kind kind = Kind::first;
  std::string text;
  std::vector<Inner> inner;
  std::vector<std::vector<int>> lists;
  std::vector<bool> flags;
  std::optional<Inner> maybe, never;
  std::map<std::pair<int, int>, std::vector<double>> map;
  std::array<int, 2> pair{};
  int plain[2] = {0, 0};
  Eigen::VectorXd vector;
  Mat3 matrix = Mat3::Zero();

  void archive(auto& state) {
    state(real, flag, kind, text, inner, lists, flags, maybe, never, map, pair, plain, vector, matrix);
  }
};

Everything filled() {
  Everything all;
  all.real = -0.0;
  all.flag = true;
  all.kind = Kind::second;
  all.text = "joint\0set";
  all.inner = {{7, Vec3(1, 2, std::numeric_limits<double>::denorm_min())}, {8, Vec3(0.1, 0.2, 0.3)}};
  all.lists = {{1, 2, 3}, {}, {4}};
  all.flags = {true, false, true};
  all.maybe = Inner{9, Vec3::Ones()};
  all.map = {{{1, 2}, {0.5}}, {{0, 3}, {}}};
  all.pair = {5, 6};
  all.plain[1] = 3;
  all.vector = Eigen::VectorXd::LinSpaced(5, 0, 1);
  all.matrix = Mat3::Identity() / 3;
  return all;
}

std::string written(Everything all) {
  StateArchive state;
  state(all);
  return state.bytes();
}

TEST(StateArchive, ReadsBackToTheLastBit) {
  const std::string bytes = written(filled());
  Everything read;
  read.never = Inner{};
  StateArchive state(bytes);
  state(read);
  EXPECT_TRUE(state.all_read());
  EXPECT_FALSE(read.never);
  EXPECT_EQ(written(read), bytes);
  EXPECT_TRUE(std::signbit(read.real));
  ASSERT_EQ(read.inner.size(), 2u);
  EXPECT_EQ(read.inner[0].vector.z(), std::numeric_limits<double>::denorm_min());
  EXPECT_THAT(read.map, testing::UnorderedElementsAre(testing::Pair(std::pair(1, 2), testing::ElementsAre(0.5)),
                                                      testing::Pair(std::pair(0, 3), testing::IsEmpty())));
}

TEST(StateArchive, PassesTheSameBytesOnPieceByPiece) {
  Everything all = filled();
  all.vector = Eigen::VectorXd::LinSpaced(400000, 0, 1);  // 3.2 MB
  const std::string bytes = written(all);
  std::vector<std::size_t> sizes;
  std::string passed_on;
  StateArchive state([&](std::string_view piece) {
    sizes.push_back(piece.size());
    passed_on += piece;
  });
  state(all);
  state.pass_on();
  EXPECT_EQ(passed_on, bytes);
  ASSERT_EQ(sizes.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(sizes[i], StateArchive::piece);
  EXPECT_TRUE(state.bytes().empty());
}

TEST(StateArchive, RefusesAStateThatEndsTooEarly) {
  const std::string bytes = written(filled());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Everything read;
    StateArchive state(std::string_view(bytes).substr(0, size));
    EXPECT_THROW(state(read), std::runtime_error) << size;
  }
}

TEST(StateArchive, RefusesAListThatIsLongerThanAllThatIsLeft) {
  std::size_t size = std::size_t{1} << 60;
  StateArchive writing;
  writing(size);
  StateArchive reading(writing.bytes());
  std::vector<double> list;
  EXPECT_THROW(reading(list), std::runtime_error);
}

}  // namespace
}  // namespace talus
