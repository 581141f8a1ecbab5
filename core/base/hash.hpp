#pragma once

#include <cstdint>

/// FNV-1a (Fowler, Noll & Vo), a number at a time: a hash that is the same on every machine.
namespace talus {

inline constexpr std::uint64_t hash_of_nothing = 14695981039346656037u;

constexpr std::uint64_t hash_with(std::uint64_t hash, std::uint64_t number) { return (hash ^ number) * 1099511628211u; }

}  // namespace talus
