// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_INTERNAL_POLYNOMIAL_POLYNOMIAL_SUM_H
#define CORRAL_INTERNAL_POLYNOMIAL_POLYNOMIAL_SUM_H

#include <corral/polynomial/arithmetic.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace corral::detail {

/// A sum under construction: adding costs only what is added, however long the sum is.
template <std::size_t D>
class Polynomial_sum
{
public:
  void add(Polynomial<Rational, D> f)
  {
    terms_since_collected_ += f.terms().size();
    parts_.push_back(std::move(f));
    if (terms_since_collected_ > 2 * terms_when_collected_ + 1000) collect_parts();
  }

  [[nodiscard]] Polynomial<Rational, D> take()
  {
    if (parts_.size() > 1) collect_parts();
    return parts_.empty() ? Polynomial<Rational, D>() : std::move(parts_.front());
  }

  /// How many terms were sorted so far, which is what the sum has cost.
  [[nodiscard]] std::size_t terms_sorted() const { return terms_sorted_; }

private:
  void collect_parts()
  {
    std::vector<typename Polynomial<Rational, D>::Term> terms;
    for (const auto& part : parts_) terms.insert(terms.end(), part.terms().begin(), part.terms().end());
    terms_sorted_ += terms.size();
    parts_ = {collect<Rational, D>(std::move(terms))};
    terms_when_collected_ = parts_.front().terms().size();
    terms_since_collected_ = 0;
  }

  std::vector<Polynomial<Rational, D>> parts_;
  std::size_t terms_when_collected_ = 0;
  std::size_t terms_since_collected_ = 0;
  std::size_t terms_sorted_ = 0;
};

} // namespace corral::detail

#endif
