#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/temporary_folder.hpp"
#include "geometry/mesher_job.hpp"
#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;

Project cube() {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  return p;
}

/// Sets TALUS_MESHER for one test.
class MesherAt {
 public:
  explicit MesherAt(const std::string& path) { setenv("TALUS_MESHER", path.c_str(), 1); }
  ~MesherAt() { unsetenv("TALUS_MESHER"); }
  MesherAt(const MesherAt&) = delete;
  MesherAt& operator=(const MesherAt&) = delete;
};

TEST(MesherProcess, ACrashOfTheMesherIsAMessage) {
  const MesherAt dying("/bin/false");
  EXPECT_THAT(error_of(cube()), AllOf(HasSubstr("the mesher crashed while starting"), HasSubstr("mesh_size")));
}

TEST(MesherProcess, WhatIsWrongWhileAFileIsReadIsSaidOfTheFile) {
  // A mesher that says that it reads, as talus-mesher does, and then dies or fails.
  const TemporaryFolder folder;
  const auto message = [](MessageKind kind, const std::string& bytes) {
    const MessageHeader header = header_of(kind, bytes);
    return std::string(reinterpret_cast<const char*>(&header), sizeof header) + bytes;
  };
  const std::string reads = message(MessageKind::progress, to_bytes(MesherProgress{0.1, "reading rock"}));
  const std::string fails = message(MessageKind::fault, to_bytes(MesherFault{"Standard_Failure"}));
  std::ofstream(folder.path() / "mesher") << "#!/bin/sh\ncat \"$0.says\" >&0\n";
  std::filesystem::permissions(folder.path() / "mesher", std::filesystem::perms::owner_all);
  const MesherAt mesher((folder.path() / "mesher").string());
  for (const auto& [says, problem] : {std::pair(reads, "crashed while reading rock"),
                                      std::pair(reads + fails, "failed while reading rock: Standard_Failure")}) {
    std::ofstream(folder.path() / "mesher.says", std::ios::binary) << says;
    EXPECT_THAT(error_of(cube()), AllOf(HasSubstr(problem), HasSubstr("export the file again")));
  }
}

TEST(MesherProcess, OfAnotherVersionIsNotUnderstoodAndSaysSo) {
  const TemporaryFolder folder;
  const std::string bytes = to_bytes(MesherEnd{});
  MessageHeader header = header_of(MessageKind::end, bytes);
  ++header.layout;
  std::ofstream(folder.path() / "mesher.says", std::ios::binary)
      .write(reinterpret_cast<const char*>(&header), sizeof header);
  std::ofstream(folder.path() / "mesher") << "#!/bin/sh\ncat \"$0.says\" >&0\n";
  std::filesystem::permissions(folder.path() / "mesher", std::filesystem::perms::owner_all);
  const MesherAt mesher((folder.path() / "mesher").string());
  EXPECT_EQ(error_of(cube()), (folder.path() / "mesher").string() +
                                  ": is the mesher of another version of Talus; unset TALUS_MESHER, or set it to the "
                                  "mesher of this version");
}

TEST(MesherProcess, LayoutOfMessagesIsThatOfTheirFields) {
  const auto layout_of = [](auto... fields) {
    ByteLayout layout;
    layout(fields...);
    return layout.hash();
  };
  EXPECT_EQ(layout_of(1, 2.0), layout_of(3, 4.0));
  EXPECT_NE(layout_of(1, 2.0), layout_of(2.0, 1));
  EXPECT_NE(layout_of(1, 2.0), layout_of(1, 2.0f));
  EXPECT_NE(layout_of(MesherSize()), layout_of(MesherSizes()));
  EXPECT_NE(layout_of(std::vector<int>()), layout_of(std::optional<int>()));
  EXPECT_NE(layout_of(std::array<int, 3>()), layout_of(std::array<int, 4>()));
}

TEST(MesherProcess, OfEachVersionTheMessagesAreOthers) {
  EXPECT_EQ(layout_of_messages("0.1.0"), layout_of_messages("0.1.0"));
  EXPECT_NE(layout_of_messages("0.1.0"), layout_of_messages("0.1.1"));
  EXPECT_NE(layout_of_messages("0.1.0"), layout_of_messages("0.10"));
  EXPECT_TRUE(is_understood(header_of(MessageKind::end, {})));
}

TEST(MesherProcess, AMissingMesherIsNotTheUsersFault) {
  const MesherAt nowhere("/nonexistent/talus-mesher");
  EXPECT_THROW(build(cube()), std::runtime_error);
}

/// Cancels once the work has said so many things.
class Impatient : public Progress {
 public:
  explicit Impatient(int patience) : patience_(patience) {}
  void report(double fraction, std::string_view what) override {
    EXPECT_GE(fraction, last_);
    EXPECT_LE(fraction, 1);
    EXPECT_FALSE(what.empty());
    last_ = fraction;
    ++said_;
  }
  bool cancelled() const override { return said_ >= patience_; }

 private:
  double last_ = 0;
  int patience_, said_ = 0;
};

TEST(MesherProcess, CancellingEndsTheMesherAtOnce) {
  Project p = cube();
  p.solids[0].mesh_size = 0.1;  // would take minutes
  Impatient user(3);            // importing, cutting, meshing
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(build_blocks(p, ".", user), Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(MesherProcess, ProgressRunsToOne) {
  Impatient user(1000);
  Project p = cube();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  EXPECT_EQ(build_blocks(p, ".", user).blocks.size(), 2u);
}

}  // namespace
}  // namespace talus
