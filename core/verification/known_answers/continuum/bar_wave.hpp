#pragma once

/// Waves along an elastic bar in one dimension, d'Alembert's solution.
namespace talus {

/// A push sin²(πt/T) that begins and ends smoothly.
struct SmoothPulse {
  double peak = 0;                    ///< N
  double duration = 0;                ///< s
  double force(double time) const;    ///< N
  double impulse(double time) const;  ///< N s, of the push until then
};

struct ElasticBar {
  double length = 0, area = 0, young = 0, density = 0;  ///< m, m², Pa, kg/m³
  double wave_speed() const;                            ///< m/s, √(E/ρ)
  double travel_time() const;                           ///< s, from end to end
  /// Displacement of a free end [m] when the other end, free too, is pushed from t = 0 on: the wave that arrives,
  /// v = F/(ρcA), is doubled. Holds until the reflected wave is back from the other end, three travel times.
  double free_end_displacement(const SmoothPulse& push, double time) const;
};

}  // namespace talus
