// Results that earlier versions have written open, and say what they do not hold.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>

#include "example_results.hpp"
#include "results/result_file.hpp"

namespace talus {
namespace {

/// The type of a row as it was before contacts told of their strength: without the last three members.
hid_t earlier_type(hid_t type) {
  const int members = H5Tget_nmembers(type) - 3;
  const hid_t earlier = H5Tcreate(H5T_COMPOUND, H5Tget_member_offset(type, static_cast<unsigned>(members)));
  for (unsigned i = 0; i < static_cast<unsigned>(members); ++i) {
    char* name = H5Tget_member_name(type, i);
    const hid_t member = H5Tget_member_type(type, i);
    H5Tinsert(earlier, name, H5Tget_member_offset(type, i), member);
    H5Tclose(member);
    H5free_memory(name);
  }
  return earlier;
}

/// Gives the table of contacts the rows of an earlier version.
void make_earlier(const std::filesystem::path& file) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(opened, 0);
  const hid_t table = H5Dopen2(opened, "/Talus/contacts", H5P_DEFAULT);
  const hid_t type = H5Dget_type(table), space = H5Dget_space(table), layout = H5Dget_create_plist(table);
  const hid_t earlier = earlier_type(type);
  std::vector<char> rows(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * H5Tget_size(earlier));
  ASSERT_GE(H5Dread(table, earlier, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
  ASSERT_GE(H5Ldelete(opened, "/Talus/contacts", H5P_DEFAULT), 0);
  const hid_t anew = H5Dcreate2(opened, "/Talus/contacts", earlier, space, H5P_DEFAULT, layout, H5P_DEFAULT);
  ASSERT_GE(H5Dwrite(anew, earlier, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
  H5Dclose(anew);
  H5Dclose(table);
  for (const hid_t each : {type, earlier}) H5Tclose(each);
  H5Sclose(space);
  H5Pclose(layout);
  H5Fclose(opened);
}

/// The example's results as they are written now.
std::filesystem::path write_example(const std::filesystem::path& folder, const BlockSystem& system, int frames) {
  const std::filesystem::path file = folder / "results.h5";
  ResultFileWriter writer(file, example_project(), system);
  for (int i = 0; i < frames; ++i) writer.add_frame(example_frame(system, i));
  return file;
}

TEST(EarlierResults, OpenWithoutTheStrengthOfContacts) {
  const TemporaryFolder folder;
  const BlockSystem system = example_system();
  const std::filesystem::path file = write_example(folder.path, system, 5);
  make_earlier(file);
  const ResultFileReader reader(file);
  for (int i = 0; i < 5; ++i) {
    const Frame written = example_frame(system, i);
    Frame read = reader.frame(i);
    ASSERT_EQ(read.contacts.size(), written.contacts.size());
    for (std::size_t c = 0; c < read.contacts.size(); ++c) {
      ContactSample& contact = read.contacts[c];
      EXPECT_TRUE(std::isnan(contact.friction));
      EXPECT_TRUE(std::isnan(contact.cohesion));
      EXPECT_EQ(contact.bond, Bond::none);
      contact.friction = written.contacts[c].friction;
      contact.cohesion = written.contacts[c].cohesion;
      contact.bond = written.contacts[c].bond;
    }
    EXPECT_TRUE(same(read, written));
  }
}

TEST(EarlierResults, OpenWithoutSleepersAndStrengths) {
  const TemporaryFolder folder;
  const BlockSystem system = example_system();
  const std::filesystem::path file = write_example(folder.path, system, 3);
  EXPECT_EQ(ResultFileReader(file).system.strengths, system.strengths);
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(opened, 0);
  for (const char* name : {"/Talus/asleep", "/Talus/material_strengths"})
    ASSERT_GE(H5Ldelete(opened, name, H5P_DEFAULT), 0) << name;
  H5Fclose(opened);
  const ResultFileReader reader(file);
  EXPECT_TRUE(reader.system.strengths.empty());
  for (int i = 0; i < 3; ++i) {
    Frame written = example_frame(system, i);
    written.asleep.clear();
    EXPECT_TRUE(same(reader.frame(i), written)) << i;
  }
}

}  // namespace
}  // namespace talus
