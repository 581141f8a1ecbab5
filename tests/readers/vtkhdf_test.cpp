// Results as VTK 9.1 reads them, the one of Debian 12: it knows VTKHDF 1.0, which has no time, and shows the first
// frame.
#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include "results/result_folder.hpp"
#include "unit/results/example_results.hpp"

namespace talus {
namespace {

/// Frames 3, 4 and 5: the first one has moved.
class Vtkhdf : public testing::Test {
 protected:
  Vtkhdf() {
    vtkObject::GlobalWarningDisplayOff();  // "File version: 2.0 is higher than this reader supports"
    ResultWriter writer(folder_.path, example_project(), system_, "{}");
    for (int i = 3; i < 6; ++i) writer.add_frame(example_frame(system_, i));
    writer.finish({});
  }

  vtkUnstructuredGrid* read(const char* name) {
    reader_->SetFileName((folder_.path / name).c_str());
    if (!reader_->CanReadFile(reader_->GetFileName())) return nullptr;
    reader_->Update();
    return vtkUnstructuredGrid::SafeDownCast(reader_->GetOutput());
  }

  TemporaryFolder folder_;
  BlockSystem system_ = example_system();
  vtkNew<vtkHDFReader> reader_;
};

void expect_row(vtkDataArray* array, vtkIdType row, const auto& expected) {
  ASSERT_NE(array, nullptr);
  ASSERT_EQ(array->GetNumberOfComponents(), expected.size());
  for (int i = 0; i < expected.size(); ++i) EXPECT_EQ(array->GetComponent(row, i), expected[i]);
}

void expect_first_frame(vtkUnstructuredGrid* grid, const BlockSystem& system) {
  ASSERT_NE(grid, nullptr);
  const Frame frame = example_frame(system, 3);
  ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(frame.displacement.size()));
  ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(frame.stress.size()));
  std::size_t node = 0;
  for (const Block& block : system.blocks)
    for (const Vec3& rest : block.mesh.nodes) {
      const auto row = static_cast<vtkIdType>(node);
      const Vec3 moved = rest + frame.displacement[node];
      for (int k = 0; k < 3; ++k) EXPECT_EQ(grid->GetPoint(row)[k], moved[k]);
      expect_row(grid->GetPointData()->GetArray("displacement"), row, frame.displacement[node]);
      expect_row(grid->GetPointData()->GetArray("velocity"), row, frame.velocity[node]);
      ++node;
    }
  for (std::size_t i = 0; i < frame.stress.size(); ++i)
    expect_row(grid->GetCellData()->GetArray("stress"), static_cast<vtkIdType>(i), frame.stress[i]);
  EXPECT_EQ(grid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(grid->GetCellData()->GetArray("block")->GetComponent(4, 0), 1);
}

TEST_F(Vtkhdf, OfResultsIsReadByDebiansVtkUpToItsFirstFrame) { expect_first_frame(read("results.h5"), system_); }

TEST_F(Vtkhdf, IsThereByTheNameThatParaViewKnowsWhereverTheFolderGoes) {
  expect_first_frame(read("results.vtkhdf"), system_);
  EXPECT_LT(std::filesystem::file_size(folder_.path / "results.vtkhdf"), 4096u) << "a link";
  const std::filesystem::path moved = folder_.path / "elsewhere";
  std::filesystem::create_directory(moved);
  for (const char* name : {"results.h5", "results.vtkhdf"}) std::filesystem::rename(folder_.path / name, moved / name);
  expect_first_frame(read("elsewhere/results.vtkhdf"), system_);
}

}  // namespace
}  // namespace talus
