#pragma once

#include "render/film/movie_encoder.hpp"

/// What the module talus-mp4 has to offer: make_mp4_encoder by FFmpeg's libraries. The caller owns what it returns.
extern "C" __attribute__((visibility("default"))) talus::MovieEncoder* talus_new_mp4_encoder(
    const std::filesystem::path& path, int width, int height, int fps);
