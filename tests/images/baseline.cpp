#include "images/baseline.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <vtkImageData.h>
#include <vtkImageQuantizeRGBToIndex.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <chrono>
#include <stdexcept>

#include "render/paint/picture_difference.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// As a PNG of a few colours: a quarter of the bytes.
void write_small(const Image& image, const fs::path& file, int colours) {
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(image.width, image.height, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(image.rgb.begin(), image.rgb.end(), static_cast<std::uint8_t*>(pixels->GetScalarPointer()));
  vtkNew<vtkImageQuantizeRGBToIndex> quantize;
  quantize->SetInputData(pixels);
  quantize->SetNumberOfColors(colours);
  quantize->Update();
  const auto* indices = static_cast<const unsigned short*>(quantize->GetOutput()->GetScalarPointer());
  const std::vector<std::uint8_t> rows(indices, indices + image.rgb.size() / 3);
  vtkLookupTable* table = quantize->GetLookupTable();
  std::vector<std::uint8_t> palette;
  for (vtkIdType i = 0; i < table->GetNumberOfTableValues(); ++i)
    for (int channel = 0; channel < 3; ++channel) palette.push_back(table->GetPointer(i)[channel]);

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB_COLORMAP;
  png.colormap_entries = static_cast<png_uint_32>(palette.size() / 3);
  if (png_image_write_to_file(&png, file.c_str(), 0, rows.data(), image.width, palette.data()) == 0)
    throw std::runtime_error(file.string() + ": " + png.message);
}

/// Of as few colours as hardly show.
void write_baseline(const Image& image, const fs::path& file) {
  constexpr double hardly_shows = 0.82;
  fs::create_directories(file.parent_path());
  for (const int colours : {64, 256}) {
    write_small(image, file, colours);
    if (compare_pictures(image, read_png(file)).similarity > hardly_shows) return;
  }
  write_png(image, file);
}

/// The newest date of a baseline says that there still is a picture of that name.
void mark_as_used(const fs::path& baseline) { fs::last_write_time(baseline, fs::file_time_type::clock::now()); }

std::string similarity_text(const PictureDifference& found) {
  const PictureTile& worst = found.worst;
  return "similarity " + std::to_string(found.similarity) + " in the tile at " + std::to_string(worst.left) + "," +
         std::to_string(worst.top) + ", at least " + std::to_string(alike_enough) + " is asked for";
}

}  // namespace

std::string held_to_baseline(const Image& image, const std::string& name, const BaselineFolders& folders) {
  const fs::path baseline = folders.baselines / (name + ".png");
  const auto left = [&](const char* what) { return folders.differing / (name + "." + what + ".png"); };
  for (const char* what : {"expected", "actual", "difference"}) fs::remove(left(what));

  std::string differs = "there is no baseline yet";
  Image expected;
  const bool exists = fs::exists(baseline);
  if (exists) {
    expected = read_png(baseline);
    if (expected.width != image.width || expected.height != image.height) {
      differs = "it has another size";
    } else {
      const PictureDifference found = compare_pictures(expected, image);
      differs = found.differing == 0 ? "" : similarity_text(found);
    }
  }
  if (folders.update) {
    if (!differs.empty()) write_baseline(image, baseline);
    mark_as_used(baseline);
    return {};
  }
  if (differs.empty()) return {};
  fs::create_directories(folders.differing);
  write_png(image, left("actual"));
  if (exists) {
    write_png(expected, left("expected"));
    if (expected.width == image.width && expected.height == image.height)
      write_png(difference_picture(expected, image), left("difference"));
  }
  return name + ": " + differs + "; look at " + name + ".*.png in " + folders.differing.string() +
         ", and if it is right, make it the baseline by tools/update_baselines.sh";
}

void expect_baseline(const Image& image, const std::string& name) {
  const std::string differs = held_to_baseline(image, name);
  if (!differs.empty()) ADD_FAILURE() << differs;
}

void expect_baseline(const Image& image) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  expect_baseline(image, std::string(test->test_suite_name()) + "." + test->name());
}

}  // namespace talus
