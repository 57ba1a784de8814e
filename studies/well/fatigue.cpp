#include "studies/well/fatigue.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace bitrock::studies {

double bending_magnification(double tension, double bending_stiffness, double half_distance) {
  const double kl = std::sqrt(std::fabs(tension) / bending_stiffness) * half_distance;
  if (kl < 1e-4) return 1.0;  // 1 +- (K L)^2 / 3
  return kl / (tension > 0.0 ? std::tanh(kl) : std::tan(kl));
}

double goodman_range(double range, double mean, double tensile_strength) {
  if (mean <= 0.0) return range;
  if (mean >= tensile_strength) return std::numeric_limits<double>::infinity();
  return range / (1.0 - mean / tensile_strength);
}

double fibre_stress(const FatigueSection& section, const SectionLoad& load, double psi) {
  return load.tension / section.area +
         section.magnification / section.section_modulus * (load.m2 * std::sin(psi) - load.m3 * std::cos(psi));
}

void FibreDamage::Count::operator()(double range, double mean, double cycles) const {
  *damage += cycles / cycles_to_failure(owner->curve_, goodman_range(range, mean, owner->section_.tensile_strength));
}

FibreDamage::FibreDamage(const FatigueSection& section, const SnCurve& curve, int fibres)
    : section_(section), curve_(curve), damage_(static_cast<std::size_t>(fibres)) {
  cycles_.reserve(damage_.size());
  for (std::size_t k = 0; k < damage_.size(); ++k) {
    const double psi = 2.0 * std::numbers::pi * static_cast<double>(k) / fibres;
    cosine_.push_back(std::cos(psi));
    sine_.push_back(std::sin(psi));
    cycles_.emplace_back(Count{this, &damage_[k]});
  }
}

void FibreDamage::add(const SectionLoad& load) {
  const double along = load.tension / section_.area, per_moment = section_.magnification / section_.section_modulus;
  for (std::size_t k = 0; k < cycles_.size(); ++k)
    cycles_[k].add(along + per_moment * (load.m2 * sine_[k] - load.m3 * cosine_[k]));
}

void FibreDamage::finish() {
  for (peaks::Rainflow<Count>& cycles : cycles_) cycles.finish();
}

}  // namespace bitrock::studies
