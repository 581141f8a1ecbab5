extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <array>
#include <stdexcept>
#include <string>

#include "render/film/mp4_encoder.hpp"

namespace talus {
namespace {

/// Calls a C function that frees what a pointer points to.
template <auto free_function>
struct Freed {
  template <class T>
  void operator()(T* thing) const {
    if constexpr (requires { free_function(&thing); })
      free_function(&thing);
    else
      free_function(thing);
  }
};

void free_format(AVFormatContext* format) {
  if (format->pb) avio_closep(&format->pb);
  avformat_free_context(format);
}

/// Passes on a result of FFmpeg's libraries; negative ones become exceptions.
int checked(int code, const char* what) {
  if (code >= 0) return code;
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  throw std::runtime_error(std::string(what) + ": " + text.data());
}

class Mp4Encoder final : public MovieEncoder {
 public:
  Mp4Encoder(const std::filesystem::path& path, int width, int height, int fps) {
    av_log_set_level(AV_LOG_ERROR);
    AVFormatContext* format = nullptr;
    checked(avformat_alloc_output_context2(&format, nullptr, "mp4", path.c_str()), "mp4 cannot be written");
    format_.reset(format);
    format_->flags |= AVFMT_FLAG_BITEXACT;  // no dates and no versions: the same film is the same file
    open_codec(width, height, fps);
    stream_ = avformat_new_stream(format_.get(), nullptr);
    stream_->time_base = codec_->time_base;
    stream_->avg_frame_rate = codec_->framerate;
    checked(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), "mp4 stream");
    checked(avio_open(&format_->pb, path.c_str(), AVIO_FLAG_WRITE), "the film cannot be opened for writing");
    AVDictionary* options = nullptr;
    av_dict_set(&options, "movflags", "+faststart", 0);  // index first: plays while it is still being loaded
    const int header = avformat_write_header(format_.get(), &options);
    av_dict_free(&options);
    checked(header, "mp4 header");
    make_frame(width, height);
  }

  void add(const Image& image) override {
    checked(av_frame_make_writable(frame_.get()), "film frame");
    const std::uint8_t* rows[] = {image.rgb.data()};
    const int stride[] = {image.width * 3};
    sws_scale(scaler_.get(), rows, stride, 0, codec_->height, frame_->data, frame_->linesize);
    frame_->pts = next_++;
    checked(avcodec_send_frame(codec_.get(), frame_.get()), "encoding the film");
    write_packets();
  }

  void finish() override {
    checked(avcodec_send_frame(codec_.get(), nullptr), "encoding the film's end");
    write_packets();
    checked(av_write_trailer(format_.get()), "writing the film's end");
    checked(avio_closep(&format_->pb), "closing the film");
  }

 private:
  void open_codec(int width, int height, int fps) {
    const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
    if (!codec) codec = avcodec_find_encoder(AV_CODEC_ID_MPEG4);
    if (!codec) throw std::runtime_error("FFmpeg has no encoder for mp4: install libavcodec-extra59");
    codec_.reset(avcodec_alloc_context3(codec));
    codec_->width = width;
    codec_->height = height;
    codec_->time_base = {1, fps};
    codec_->framerate = {fps, 1};
    codec_->pix_fmt = AV_PIX_FMT_YUV420P;  // the one that every player knows
    codec_->colorspace = AVCOL_SPC_BT709;
    codec_->color_primaries = AVCOL_PRI_BT709;
    codec_->color_trc = AVCOL_TRC_BT709;
    codec_->color_range = AVCOL_RANGE_MPEG;
    codec_->gop_size = 2 * fps;
    codec_->thread_count = 2;
    codec_->flags |= AV_CODEC_FLAG_BITEXACT;
    if (format_->oformat->flags & AVFMT_GLOBALHEADER) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (codec->id == AV_CODEC_ID_H264) {
      av_opt_set_int(codec_->priv_data, "crf", 18, 0);  // thin edges and small print stay clean
      av_opt_set(codec_->priv_data, "preset", "veryfast", 0);
    } else {
      codec_->bit_rate = static_cast<std::int64_t>(width) * height * fps / 8;
    }
    checked(avcodec_open2(codec_.get(), codec, nullptr), "the film's encoder");
  }

  void make_frame(int width, int height) {
    frame_.reset(av_frame_alloc());
    frame_->format = codec_->pix_fmt;
    frame_->width = width;
    frame_->height = height;
    checked(av_frame_get_buffer(frame_.get(), 0), "film frame");
    packet_.reset(av_packet_alloc());
    scaler_.reset(sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, codec_->pix_fmt,
                                 SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT, nullptr, nullptr, nullptr));
    if (!scaler_) throw std::runtime_error("film colours cannot be converted");
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler_.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
  }

  void write_packets() {
    while (true) {
      const int code = avcodec_receive_packet(codec_.get(), packet_.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      checked(code, "encoding the film");
      av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
      packet_->stream_index = stream_->index;
      checked(av_interleaved_write_frame(format_.get(), packet_.get()), "writing the film");
    }
  }

  std::unique_ptr<AVFormatContext, Freed<free_format>> format_;
  std::unique_ptr<AVCodecContext, Freed<avcodec_free_context>> codec_;
  std::unique_ptr<AVFrame, Freed<av_frame_free>> frame_;
  std::unique_ptr<AVPacket, Freed<av_packet_free>> packet_;
  std::unique_ptr<SwsContext, Freed<sws_freeContext>> scaler_;
  AVStream* stream_ = nullptr;  // the format's
  std::int64_t next_ = 0;
};

}  // namespace
}  // namespace talus

talus::MovieEncoder* talus_new_mp4_encoder(const std::filesystem::path& path, int width, int height, int fps) {
  return new talus::Mp4Encoder(path, width, height, fps);
}
