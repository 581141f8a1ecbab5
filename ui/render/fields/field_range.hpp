#pragma once

#include <span>
#include <string>

#include "fields/field_values.hpp"
#include "render/paint/value_range.hpp"

namespace talus {

/// Range of a field in one frame over the movable blocks: fixed rock is not coloured and does not count, but for the
/// walls of joints, of whose stresses the outer hundredths are left out. Unite the ranges of all frames for a legend
/// that holds over a whole run.
ValueRange field_range(const FieldValues& fields, const Frame& frame, const Field& field);
/// The same from values that are at hand.
ValueRange field_range(const BlockSystem& system, std::span<const double> values, const Field& field);

/// Whether a field has a sign that matters: shown with vik, symmetric about zero. Others are shown with batlow from
/// zero.
bool is_signed(const Field& field);

/// The range of a legend that shows `values`: from zero or symmetric about it, ended at a round number, never of no
/// length. That of normal stress on joints reaches from the largest tension to the largest compression.
ValueRange legend_range(const Field& field, const ValueRange& values);

}  // namespace talus
