#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/error.hpp"
#include "base/temporary_folder.hpp"

// What libFuzzer gives, as text or as a file. Bad input must end in an InputError; anything else is a finding.
namespace talus::fuzz {

inline std::string_view text_of(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// A file of that name in a folder that stays for all inputs.
inline std::filesystem::path file_of(std::string_view bytes, const char* name) {
  static const TemporaryFolder folder;
  std::filesystem::path file = folder.path() / name;
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

/// Input may be refused in one line.
void allow_refusal(auto read) {
  try {
    read();
  } catch (const InputError&) {
  }
}

}  // namespace talus::fuzz
