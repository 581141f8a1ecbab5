#pragma once

#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace talus {

/// A piece of a longer work: its 0…1 are [begin, begin + share] of the whole, and its name goes before its words.
class PartOfProgress final : public Progress {
 public:
  PartOfProgress(Progress& whole, double begin, double share, std::string name)
      : whole_(whole), begin_(begin), share_(share), name_(std::move(name)) {}

  void report(double fraction, std::string_view what) override {
    std::string words = name_;
    if (!what.empty() && what != name_) (words += words.empty() ? "" : ": ") += what;
    whole_.report(begin_ + share_ * fraction, words);
  }
  bool cancelled() const override { return whole_.cancelled(); }

 private:
  Progress& whole_;
  double begin_, share_;
  std::string name_;
};

}  // namespace talus
