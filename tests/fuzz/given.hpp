#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/one_line.hpp"
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

/// What was said of bad input; told when the program ends.
struct Refusals {
  std::uint64_t count = 0;
  std::size_t longest = 0;  // characters

  void add(const std::string& message) {
    ++count;
    longest = std::max(longest, one_line(message).size());
  }
  ~Refusals() { std::cerr << count << " times refused, at most in " << longest << " characters\n"; }
};
inline Refusals refusals;

/// Input may be refused, in one line.
void allow_refusal(auto read) {
  try {
    read();
  } catch (const InputError& error) {
    refusals.add(error.what());
  }
}

}  // namespace talus::fuzz
