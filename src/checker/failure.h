// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_FAILURE_H
#define CORRAL_CHECKER_FAILURE_H

#include <gmpxx.h>

#include <cmath>
#include <stdexcept>
#include <string>

/// \file
/// The checker of certificates. It knows doc/certificate.md and nothing of the library, so that an error of the
/// library cannot hide itself here.
namespace corral_check {

/// The certificate breaks a rule of the specification. The message names the place and the rule.
struct Rejected : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void reject(const std::string& where, const std::string& why)
{
  throw Rejected(where + ": " + why);
}

inline void require(bool condition, const std::string& where, const char* why)
{
  if (!condition) reject(where, why);
}

/// The number of machine words of an integer or a fraction, at least 1.
inline double words(const mpz_class& value) { return static_cast<double>(mpz_size(value.get_mpz_t())) + 1; }
inline double words(const mpq_class& value) { return words(value.get_num()) + words(value.get_den()); }

/// Bounds the time and the memory that a hostile file can use. Work is counted in operations on machine words.
class Budget
{
public:
  /// Counts operations on numbers of so many words; a product or a gcd of long numbers costs more than in proportion.
  void work(double operations, double length)
  {
    work_ += operations * length * std::sqrt(1 + length / 32);
    if (work_ > max_work) reject("budget", "the proofs need more than 10^11 word operations");
  }
  /// Refuses to hold so many words at once.
  static void memory(double words_held)
  {
    if (words_held > max_words) reject("budget", "the proofs need more than 2^27 words of memory");
  }
  static constexpr double max_work = 1e11;
  static constexpr double max_words = 134217728;

private:
  double work_ = 0;
};

} // namespace corral_check

#endif
