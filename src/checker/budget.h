// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_BUDGET_H
#define CORRAL_CHECKER_BUDGET_H

#include "fault.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

namespace corral_check {

/// The bits of an integer; 1 for zero.
inline double bits(const mpz_class& value) { return static_cast<double>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

/// w(b) of section 7: the words that b bits are counted as.
inline double words(double bit_count) { return 1 + std::floor(bit_count / 64); }

/// |q| of section 7.
inline double length(const mpq_class& value) { return words(bits(value.get_num())) + words(bits(value.get_den())); }

/// \brief Counts work and memory as section 7 of the specification does, so that every checker stops at the same files.
///
/// The counts are integers; doubles hold them exactly as far as the limits reach.
class Budget
{
public:
  static constexpr double max_work = 1e11;
  static constexpr double max_form_words = 67108864;       ///< 2^26
  static constexpr double max_polynomial_words = 16777216; ///< 2^24

  void work(double operations)
  {
    work_ += operations;
    if (work_ > max_work) throw Stopped("work", "the proofs take more than 10^11 operations on words", {});
  }
  /// One operation on fractions of so many words in all.
  void fractions(double word_count) { work(20 * word_count * (1 + std::floor(word_count / 256))); }

  [[nodiscard]] double spent() const { return work_; }

  static void require_form_words(double held)
  {
    if (held > max_form_words) throw Stopped("memory", "the boxes of a branch take more than 2^26 words", {});
  }
  static void require_polynomial_words(double held)
  {
    if (held > max_polynomial_words) throw Stopped("memory", "a polynomial takes more than 2^24 words", {});
  }

private:
  double work_ = 0;
};

} // namespace corral_check

#endif
