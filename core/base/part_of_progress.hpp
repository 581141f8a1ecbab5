#pragma once

#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace talus {

/// A piece of a longer work: its 0…1 are [begin, begin + length] of the whole, and its name goes before its words.
class PartOfProgress final : public Progress {
 public:
  PartOfProgress(Progress& whole, double begin, double length, std::string name)
      : whole_(whole), begin_(begin), length_(length), name_(std::move(name)) {}

  void report(double fraction, std::string_view what) override {
    std::string words = name_;
    if (!what.empty() && what != name_) (words += words.empty() ? "" : ": ") += what;
    whole_.report(begin_ + length_ * fraction, words);
  }
  bool cancelled() const override { return whole_.cancelled(); }

 private:
  Progress& whole_;
  double begin_, length_;
  std::string name_;
};

}  // namespace talus
