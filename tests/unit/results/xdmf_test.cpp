#include "results/xdmf.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/resident_memory.hpp"
#include "example_results.hpp"
#include "results/hdf5.hpp"
#include "results/result_folder.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::vector<double> flat(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  for (const Vec3& vector : vectors) numbers.insert(numbers.end(), vector.data(), vector.data() + 3);
  return numbers;
}

/// In single precision, as it is stored.
std::vector<double> flat(const std::vector<Voigt>& stresses) {
  std::vector<double> numbers;
  for (const Voigt& stress : stresses)
    for (const double number : stress) numbers.push_back(static_cast<float>(number));
  return numbers;
}

/// Of a virtual dataset, which Talus itself reads nothing from.
std::vector<double> numbers_in(hid_t file, const std::string& path) {
  const hdf5::Handle dataset = hdf5::open_dataset(file, path);
  const hdf5::Handle space(H5Dget_space(dataset));
  std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
  return numbers;
}

/// Frames 0, 1 and 2 of a run that is over.
void write_results(const fs::path& folder, const BlockSystem& system) {
  ResultWriter writer(folder, example_project(), system, "{}");
  for (int i = 0; i < 3; ++i) writer.add_frame(example_frame(system, i));
  writer.finish({});
}

TEST(XdmfIndex, HasTheRowsOfEachFrameInADatasetOfTheirOwn) {
  const TemporaryFolder folder;
  const BlockSystem system = example_system();
  write_results(folder.path / "results", system);
  // Where it stands does not matter, as long as results.h5 is beside it.
  fs::rename(folder.path / "results", folder.path / "moved");
  const hdf5::Handle views(H5Fopen((folder.path / "moved" / "frames.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  for (int i = 0; i < 3; ++i) {
    const Frame frame = example_frame(system, i);
    const std::string group = "/" + std::to_string(i);
    EXPECT_EQ(numbers_in(views, group + "/displacement"), flat(frame.displacement));
    EXPECT_EQ(numbers_in(views, group + "/velocity"), flat(frame.velocity));
    EXPECT_EQ(numbers_in(views, group + "/stress"), flat(frame.stress));
    EXPECT_EQ(numbers_in(views, group + "/points").size(), 3 * frame.displacement.size());
  }
}

TEST(XdmfIndex, OfARunThatIsOverHasWholeDatasets) {
  const TemporaryFolder folder;
  const BlockSystem system = example_system();
  write_results(folder.path, system);
  const std::string index = text_of(folder.path / "results.xdmf");
  EXPECT_THAT(index, testing::HasSubstr("frames.h5:/2/stress</DataItem>"));
  EXPECT_THAT(index, testing::Not(testing::HasSubstr("HyperSlab"))) << "ParaView's Xdmf3 readers show nothing of it";
  EXPECT_THAT(index, testing::EndsWith("</Xdmf>\n"));
}

// 60 000 frames are 160 MB of text.
TEST(XdmfIndex, IsNeverHeldWhole) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers hold memory of their own";
#endif
  const TemporaryFolder folder;
  const fs::path file = folder.path / "results.xdmf";
  XdmfIndex index(file, "long", 8, 5);
  constexpr int frames = 8000;
  for (int i = 0; i < frames; ++i) index.add_frame(i);
  ASSERT_TRUE(count_resident_memory_anew());
  const double before = resident_memory().now;
  index.finish();
  EXPECT_GT(fs::file_size(file), 10'000'000u);
  EXPECT_LT(resident_memory().most - before, 10e6);
}

TEST(XdmfIndex, GoesWithTheResultsOfAnEarlierRun) {
  const TemporaryFolder folder;
  const BlockSystem system = example_system();
  write_results(folder.path, system);
  const ResultWriter next(folder.path, example_project(), system, "{}");
  EXPECT_FALSE(fs::exists(folder.path / "frames.h5"));
  EXPECT_THAT(text_of(folder.path / "results.xdmf"), testing::Not(testing::HasSubstr("frames.h5")));
}

}  // namespace
}  // namespace talus
