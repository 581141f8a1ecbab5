extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}
#include <gif_lib.h>
#include <gtest/gtest.h>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/error.hpp"
#include "images/compare.hpp"
#include "images/test_scenes.hpp"
#include "render/film/movie.hpp"
#include "render/scene/offscreen.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

struct Decoded {
  int width = 0, height = 0, frames = 0;
  double fps = 0;
  AVCodecID codec = AV_CODEC_ID_NONE;
  AVPixelFormat format = AV_PIX_FMT_NONE;
};

/// Decodes every picture of a film.
Decoded decode(const fs::path& path) {
  AVFormatContext* file = nullptr;
  if (avformat_open_input(&file, path.c_str(), nullptr, nullptr) < 0) throw std::runtime_error("not a film");
  avformat_find_stream_info(file, nullptr);
  const AVStream* stream = file->streams[0];
  const AVCodec* codec = avcodec_find_decoder(stream->codecpar->codec_id);
  AVCodecContext* decoder = avcodec_alloc_context3(codec);
  avcodec_parameters_to_context(decoder, stream->codecpar);
  avcodec_open2(decoder, codec, nullptr);
  Decoded result{.codec = stream->codecpar->codec_id};
  result.fps = av_q2d(stream->avg_frame_rate);
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  const auto drain = [&] {
    while (avcodec_receive_frame(decoder, frame) >= 0) {
      ++result.frames;
      result.width = frame->width;
      result.height = frame->height;
      result.format = static_cast<AVPixelFormat>(frame->format);
    }
  };
  while (av_read_frame(file, packet) >= 0) {
    avcodec_send_packet(decoder, packet);
    av_packet_unref(packet);
    drain();
  }
  avcodec_send_packet(decoder, nullptr);
  drain();
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&decoder);
  avformat_close_input(&file);
  return result;
}

Image plain(int width, int height, Rgb colour) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    image.rgb[i] = colour.red;
    image.rgb[i + 1] = colour.green;
    image.rgb[i + 2] = colour.blue;
  }
  return image;
}

std::string bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Film : public testing::Test {
 protected:
  Film() : folder(fs::temp_directory_path() / ("talus_film_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~Film() override { fs::remove_all(folder); }
  fs::path folder;
};

class Recorder final : public Progress {
 public:
  explicit Recorder(int cancel_after = 1 << 30) : cancel_after_(cancel_after) {}
  void report(double fraction, std::string_view) override { fractions.push_back(fraction); }
  bool cancelled() const override { return static_cast<int>(fractions.size()) >= cancel_after_; }
  std::vector<double> fractions;

 private:
  int cancel_after_;
};

TEST_F(Film, Mp4HasEveryPictureInEvenSize) {
  const fs::path path = folder / "a.mp4";
  MovieWriter writer(path, 161, 91, 25);
  for (int i = 0; i < 12; ++i) writer.add_frame(plain(161, 91, rgb(static_cast<unsigned>(0x102030 + i * 0x050505))));
  EXPECT_FALSE(fs::exists(path)) << "appears when it is finished";
  writer.finish();
  const Decoded film = decode(path);
  EXPECT_EQ(film.frames, 12);
  EXPECT_EQ(film.width, 160);
  EXPECT_EQ(film.height, 90);
  EXPECT_DOUBLE_EQ(film.fps, 25);
  EXPECT_EQ(film.codec, AV_CODEC_ID_H264);
  EXPECT_EQ(film.format, AV_PIX_FMT_YUV420P);
}

TEST_F(Film, IsTheSameFileTwice) {
  for (const char* name : {"a.mp4", "b.mp4"}) {
    MovieWriter writer(folder / name, 64, 48, 10);
    for (int i = 0; i < 5; ++i) writer.add_frame(plain(64, 48, rgb(static_cast<unsigned>(0x400000 + i * 20))));
    writer.finish();
  }
  EXPECT_EQ(decode(folder / "a.mp4").frames, 5);
  EXPECT_EQ(bytes(folder / "a.mp4"), bytes(folder / "b.mp4"));
}

TEST_F(Film, GifHasEveryPictureAndItsColours) {
  const fs::path path = folder / "a.gif";
  MovieWriter writer(path, 61, 41, 20);
  for (int i = 0; i < 7; ++i) writer.add_frame(plain(61, 41, i == 6 ? rgb(0xd2580a) : rgb(0x0068a8)));
  writer.finish();
  int error = 0;
  GifFileType* gif = DGifOpenFileName(path.c_str(), &error);
  ASSERT_NE(gif, nullptr);
  ASSERT_EQ(DGifSlurp(gif), GIF_OK);
  EXPECT_EQ(gif->ImageCount, 7);
  EXPECT_EQ(gif->SWidth, 61);
  EXPECT_EQ(gif->SHeight, 41);
  GraphicsControlBlock control;
  DGifSavedExtensionToGCB(gif, 0, &control);
  EXPECT_EQ(control.DelayTime, 5);  // hundredths of a second
  const SavedImage& last = gif->SavedImages[6];
  const GifColorType& colour = last.ImageDesc.ColorMap->Colors[last.RasterBits[100]];
  EXPECT_NEAR(colour.Red, 0xd2, 8);
  EXPECT_NEAR(colour.Green, 0x58, 8);
  DGifCloseFile(gif, &error);
}

TEST_F(Film, LeavesNothingWhenItIsNotFinished) {
  for (const char* name : {"a.mp4", "a.gif"}) {
    { MovieWriter(folder / name, 64, 48, 10).add_frame(plain(64, 48, rgb(0))); }
    EXPECT_TRUE(fs::is_empty(folder)) << name;
  }
}

TEST_F(Film, RefusesWhatCannotBeAFilm) {
  EXPECT_THROW(MovieWriter(folder / "a.avi", 64, 48, 10), InputError);
  EXPECT_THROW(MovieWriter(folder / "a.mp4", 8, 8, 10), InputError);
  EXPECT_THROW(MovieWriter(folder / "a.mp4", 64, 48, 0), InputError);
  EXPECT_THROW(MovieWriter(folder / "no" / "a.mp4", 64, 48, 10), InputError);
  EXPECT_THROW(MovieWriter(folder / "no" / "a.gif", 64, 48, 10), InputError);
  MovieWriter writer(folder / "a.mp4", 64, 48, 10);
  EXPECT_THROW(writer.add_frame(plain(32, 48, rgb(0))), std::invalid_argument);
}

TEST_F(Film, OfASlideShowsEveryFrame) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings;
  settings.field = field_named("displacement");
  settings.range = ValueRange{0, 20};
  Scene scene(slope, settings);
  const auto frame = [&](int i) { return slid(slope, 2.5 * i, i); };
  Recorder progress;
  const std::vector<double> times{0, 0.2, 0.4, 0.6, 0.8, 1};
  const FilmOptions options{.width = 320, .height = 200, .fps = 5};
  EXPECT_EQ(render_film({{scene, slope, times, frame}}, options, folder / "slide.mp4", progress), 6);
  EXPECT_EQ(decode(folder / "slide.mp4").frames, 6);
  ASSERT_EQ(progress.fractions.size(), 6u);
  EXPECT_DOUBLE_EQ(progress.fractions.back(), 1);
}

TEST_F(Film, OfFewFramesInRealTimeDrawsEachPictureOnce) {
  const BlockSystem boxes = two_boxes();
  Scene scene(boxes);
  int drawn = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&drawn);
  count->SetCallback([](vtkObject*, unsigned long, void* number, void*) { ++*static_cast<int*>(number); });
  scene.renderer()->AddObserver(vtkCommand::EndEvent, count);
  const auto frame = [&](int i) { return slid(boxes, 0.5 * i, i); };
  NoProgress progress;
  const FilmOptions options{.width = 64, .height = 48, .fps = 25};
  EXPECT_EQ(render_film({{scene, boxes, {0, 1, 2}, frame}}, options, folder / "few.mp4", progress), 51);
  EXPECT_EQ(drawn, 3);
  EXPECT_EQ(decode(folder / "few.mp4").frames, 51);
}

TEST_F(Film, OfResultsBesideEachOtherHasAPanelForEach) {
  const BlockSystem boxes = two_boxes(), slope = jointed_slope();
  SceneSettings left, right;
  left.title = "left";
  right.title = "right";
  Scene one(boxes, left), other(slope, right);
  const auto first = [&](int i) { return slid(boxes, 0.5 * i, i); };
  const auto second = [&](int i) { return slid(slope, 0.5 * i, i); };
  NoProgress progress;
  const FilmOptions options{.width = 640, .height = 240, .fps = 5};
  EXPECT_EQ(render_film({{one, boxes, {0, 1}, first}, {other, slope, {0.5, 2}, second}}, options, folder / "two.mp4",
                        progress),
            11)
      << "from the first moment of one to the last of the other";
  const Decoded film = decode(folder / "two.mp4");
  EXPECT_EQ(film.frames, 11);
  EXPECT_EQ(film.width, 640);
  EXPECT_EQ(one.pose().position, other.pose().position) << "seen from the same place";
}

/// Letters of ever other sizes, on both threads: fonts that VTK keeps are thrown away and read again all the time.
TEST_F(Film, IsWrittenWhileAnotherThreadDraws) {
  constexpr int pictures = 60;
  const BlockSystem boxes = two_boxes();
  const auto write = [](Scene& scene, const std::string& title, int picture) {
    SceneSettings settings = scene.settings();
    settings.title = title + " " + std::to_string(picture);
    settings.text_height = 10 + picture % 17;
    scene.set_settings(settings);
  };
  std::atomic<bool> is_filmed = false;
  std::jthread film([&] {
    Scene scene(boxes);
    const auto frame = [&](int i) {
      write(scene, "film", i);
      return slid(boxes, 0.01 * i, i);
    };
    NoProgress progress;
    std::vector<double> times;
    for (int i = 0; i < pictures; ++i) times.push_back(0.2 * i);
    const FilmOptions options{.width = 320, .height = 200, .fps = 5};
    render_film({{scene, boxes, times, frame}}, options, folder / "beside.mp4", progress);
    is_filmed = true;
  });
  Scene scene(boxes);
  OffscreenView view(scene, 320, 200, Sampling::fast);
  int drawn = 0;
  for (; !is_filmed; ++drawn) {
    write(scene, "view", drawn);
    view.draw();
  }
  film.join();
  EXPECT_EQ(decode(folder / "beside.mp4").frames, pictures);
  EXPECT_GT(drawn, pictures / 4);
}

TEST_F(Film, CanBeCancelled) {
  const BlockSystem boxes = two_boxes();
  Scene scene(boxes);
  Recorder progress(2);
  const auto frame = [&](int i) { return slid(boxes, 0.01 * i, i); };
  const std::vector<double> times{0, 1, 2, 3, 4, 5, 6, 7, 8};
  const FilmOptions options{.width = 64, .height = 48, .fps = 5};
  EXPECT_THROW(render_film({{scene, boxes, times, frame}}, options, folder / "a.gif", progress), Cancelled);
  EXPECT_EQ(progress.fractions.size(), 2u);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace talus
