// SPDX-License-Identifier: LGPL-3.0-or-later
#include "validate.h"

#include "Counted_form.h"

#include <corral/algebra/Integer_polynomial.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace corral::certificate {
namespace {

template <std::size_t D>
bool contains_point(const Rational_box<D>& cell, const Rational_point<D>& point)
{
  for (std::size_t axis = 0; axis < D; ++axis)
    if (point[axis] < cell[axis].lower() || point[axis] > cell[axis].upper()) return false;
  return true;
}

/// The strict sign of all Bernstein coefficients on the box, 0 if they have none.
template <std::size_t D>
int strict_sign(const Polynomial<Rational, D>& f, const Rational_box<D>& box, double& work)
{
  const auto form = counted_form(integer_primitive(f), box, work).form;
  const int sign = sgn(form.values.front());
  return std::all_of(form.values.begin(), form.values.end(), [&](const Integer& b) { return sgn(b) == sign; }) ? sign
                                                                                                               : 0;
}

template <std::size_t D>
bool changes_sign_along(const Polynomial<Rational, D>& f, std::size_t axis, const Rational_box<D>& box, double& work)
{
  auto lower = box;
  auto upper = box;
  lower[axis] = Rational_interval(box[axis].lower());
  upper[axis] = Rational_interval(box[axis].upper());
  return strict_sign(f, lower, work) * strict_sign(f, upper, work) < 0;
}

/// Whether `f` has no variable of the axes `later` and is monic in that of `axis`.
template <std::size_t D>
bool is_monic(const Polynomial<Rational, D>& f, std::size_t axis, std::span<const std::size_t> later)
{
  const unsigned degree = f.degree(axis);
  if (degree == 0) return false;
  Exponents<D> lead{};
  lead[axis] = static_cast<std::uint16_t>(degree);
  return std::all_of(f.terms().begin(), f.terms().end(), [&](const auto& term) {
    const bool is_lead = term.exponents[axis] == degree;
    return (!is_lead || (term.exponents == lead && term.coefficient == 1))
           && std::all_of(later.begin(), later.end(), [&](std::size_t k) { return term.exponents[k] == 0; });
  });
}

/// A sum that counts what a checker counts for it, and gives up beyond `max_work`.
template <std::size_t D>
class Counted_sum
{
public:
  explicit Counted_sum(double& work) : work_(work) {}
  Counted_sum(const Polynomial<Rational, D>& start, double& work) : work_(work)
  {
    for (const auto& term : start.terms()) terms_.emplace(term.exponents, term.coefficient);
  }

  [[nodiscard]] std::map<Exponents<D>, Rational>& terms() { return terms_; }
  [[nodiscard]] Polynomial<Rational, D> polynomial() const
  {
    std::vector<typename Polynomial<Rational, D>::Term> terms;
    for (const auto& [exponents, coefficient] : terms_) terms.push_back({exponents, coefficient});
    return collect<Rational, D>(std::move(terms));
  }
  [[nodiscard]] bool is_hopeless() const { return work_ > max_work || held_ > max_held; }

  void add(const Polynomial<Rational, D>& f, const Rational& factor, const Exponents<D>& shift)
  {
    const double factor_length = length(factor);
    for (const auto& term : f.terms()) {
      work_ += fraction_cost(factor_length + length(term.coefficient));
      auto exponents = shift;
      for (std::size_t axis = 0; axis < D; ++axis)
        exponents[axis] = static_cast<std::uint16_t>(exponents[axis] + term.exponents[axis]);
      const auto sum = terms_.try_emplace(exponents).first;
      sum->second += factor * term.coefficient;
      const double sum_length = length(sum->second);
      work_ += fraction_cost(sum_length);
      longest_ = std::max(longest_, sum_length);
      if (sum->second == 0) terms_.erase(sum);
    }
    held_ = static_cast<double>(terms_.size()) * (longest_ + 20);
  }

private:
  static constexpr double max_held = 8388608; ///< words: half of what the format allows
  double& work_;
  std::map<Exponents<D>, Rational> terms_;
  double longest_ = 2;
  double held_ = 0;
};

/// Whether f reduces to zero; replaces it by its remainder on division by `divisor`, monic in the variable of `axis`.
template <std::size_t D>
[[nodiscard]] bool reduce(Polynomial<Rational, D>& f, const Polynomial<Rational, D>& divisor, std::size_t axis,
                          double& work)
{
  const unsigned degree = divisor.degree(axis);
  const unsigned highest = f.degree(axis);
  Counted_sum<D> rest(f, work);
  for (unsigned current = highest; current >= degree; --current) {
    std::vector<std::pair<Exponents<D>, Rational>> top;
    for (const auto& term : rest.terms())
      if (term.first[axis] == current) top.push_back(term);
    for (auto& [exponents, coefficient] : top) {
      exponents[axis] = static_cast<std::uint16_t>(current - degree);
      rest.add(divisor, -coefficient, exponents);
      if (rest.is_hopeless()) return false;
    }
  }
  f = rest.polynomial();
  return true;
}

/// The remainder on division in the lexicographic order; nothing if it takes too much.
template <std::size_t D>
std::optional<Polynomial<Rational, D>> remainder(const Polynomial<Rational, D>& f,
                                                 const Polynomial<Rational, D>& divisor, double& work)
{
  const auto& lead = divisor.terms().back();
  Counted_sum<D> rest(f, work);
  auto end = rest.terms().end();
  while (end != rest.terms().begin()) {
    const auto top = std::prev(end);
    Exponents<D> shift;
    bool is_multiple = true;
    for (std::size_t axis = 0; axis < D; ++axis) {
      is_multiple = is_multiple && top->first[axis] >= lead.exponents[axis];
      shift[axis] = static_cast<std::uint16_t>(top->first[axis] - lead.exponents[axis]);
    }
    if (!is_multiple) {
      end = top;
      continue;
    }
    const Rational factor = top->second / lead.coefficient;
    work += fraction_cost(length(factor));
    rest.add(divisor, -factor, shift);
    if (rest.is_hopeless()) return std::nullopt;
  }
  return rest.polynomial();
}

template <std::size_t D>
bool fixes(const Polynomial<Rational, D>& f, std::size_t axis, const Rational& value)
{
  return f == variable<Rational, D>(axis) - constant<Rational, D>(value);
}

template <std::size_t D>
bool proves(const Sign_change<D>& change, const Polynomial<Rational, D>& g, const Rational_box<D>& cell, double& work)
{
  if (!contains_point<D>(cell, change.first) || !contains_point<D>(cell, change.second)) return false;
  for (const auto* point : {&change.first, &change.second}) {
    double word_count = longest(g);
    for (std::size_t axis = 0; axis < D; ++axis) word_count += 2 * g.degree(axis) * length((*point)[axis]);
    work += static_cast<double>(g.terms().size()) * fraction_cost(2 * word_count);
  }
  if (work > max_work) return false;
  const int first = sgn(evaluate(g, change.first));
  return change.first == change.second ? first == 0 : first * sgn(evaluate(g, change.second)) < 0;
}

template <std::size_t D>
bool fits(const Polynomial<Rational, D>& t)
{
  constexpr double max_dense = 65536;
  constexpr double digits_of_a_word = 19.3;
  double dense = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    dense *= t.degree(axis) + 1;
    if (t.degree(axis) > 1000) return false;
  }
  return dense <= max_dense && longest(t) * digits_of_a_word < 100000;
}

template <std::size_t D>
bool proves(const Triangular_zero<D>& zero, Polynomial<Rational, D> g, const Rational_box<D>& cell, double& work)
{
  for (std::size_t k = 0; k < D; ++k) {
    const std::size_t axis = zero.order[k];
    const auto& side = zero.box[axis];
    const auto& t = zero.chain[k];
    if (!fits(t) || side.lower() < cell[axis].lower() || side.upper() > cell[axis].upper()) return false;
    if (!is_monic<D>(t, axis, std::span(zero.order).subspan(k + 1))) return false;
    const bool is_flat = side.lower() == side.upper();
    if (is_flat ? !fixes(t, axis, side.lower()) : !changes_sign_along(t, axis, zero.box, work)) return false;
  }
  for (std::size_t k = D; k-- > 0;)
    if (!reduce(g, zero.chain[k], zero.order[k], work)) return false;
  return g.is_zero();
}

template <std::size_t D>
bool proves(const Miranda_zero<D>& zero, const std::vector<Polynomial<Rational, D>>& polynomials,
            const Rational_box<D>& cell, double& work)
{
  const std::size_t m = polynomials.size();
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto& side = zero.box[axis];
    if (side.lower() < cell[axis].lower() || side.upper() > cell[axis].upper()) return false;
    if (side.lower() != side.upper()) axes.push_back(axis);
  }
  if (axes.size() != m || zero.matrix.size() != m) return false;
  double word_count = 0;
  for (const auto& row : zero.matrix)
    for (const Rational& entry : row) word_count += length(entry);
  work += static_cast<double>(m * m * m) * fraction_cost(word_count);
  for (std::size_t r = 0; r < m; ++r) {
    Counted_sum<D> sum(work);
    for (std::size_t j = 0; j < m; ++j)
      if (zero.matrix[r][j] != 0) sum.add(polynomials[j], zero.matrix[r][j], Exponents<D>{});
    if (sum.is_hopeless() || !changes_sign_along(sum.polynomial(), axes[r], zero.box, work)) return false;
  }
  return true;
}

} // namespace

template <std::size_t D>
bool is_acceptable(const Cell_proof<D>& proof, const std::vector<Polynomial<Rational, D>>& polynomials,
                   const Rational_box<D>& cell, double& work)
{
  if (const auto* zero = std::get_if<Miranda_zero<D>>(&proof)) return proves(*zero, polynomials, cell, work);
  const auto* change = std::get_if<Sign_change<D>>(&proof);
  if (change != nullptr && change->first != change->second && polynomials.size() > 1) return false;
  return std::all_of(polynomials.begin(), polynomials.end(), [&](const Polynomial<Rational, D>& g) {
    return change != nullptr ? proves(*change, g, cell, work)
                             : proves(std::get<Triangular_zero<D>>(proof), g, cell, work);
  });
}

template <std::size_t D>
double square_free_work(const Polynomial<Rational, D>& f, const Polynomial<Rational, D>& g, unsigned power)
{
  double work = 0;
  (void)remainder(f, g, work);
  auto rest = constant<Rational, D>(1);
  for (unsigned k = 0; k < std::min(power, f.total_degree()); ++k) {
    Counted_sum<D> product(work);
    for (const auto& term : rest.terms()) product.add(g, term.coefficient, term.exponents);
    auto next = remainder(product.polynomial(), f, work);
    if (!next || product.is_hopeless()) return 2 * max_work;
    rest = std::move(*next);
  }
  return work;
}

/// On a line through the origin in a direction where the form of highest degree does not vanish, no factor becomes
/// constant, so that none loses its multiplicity.
template <std::size_t D>
unsigned highest_multiplicity(const Polynomial<Rational, D>& f)
{
  const unsigned degree = f.total_degree();
  if (degree <= 1) return 1;
  const auto integer = integer_primitive(f);
  for (unsigned long slope = 1;; ++slope) {
    std::vector<Integer> line(degree + 1);
    for (const auto& term : integer.terms()) {
      unsigned long exponent = 0; // of `slope`: the direction is (1, slope, slope^2, ...)
      for (std::size_t axis = 0; axis < D; ++axis) exponent += axis * term.exponents[axis];
      Integer factor;
      mpz_ui_pow_ui(factor.get_mpz_t(), slope, exponent);
      line[std::accumulate(term.exponents.begin(), term.exponents.end(), std::size_t{0})] += term.coefficient * factor;
    }
    if (line.back() == 0) continue;
    return static_cast<unsigned>(square_free_decomposition(Integer_polynomial(std::move(line))).size());
  }
}

template bool is_acceptable(const Cell_proof<1>&, const std::vector<Polynomial<Rational, 1>>&, const Rational_box<1>&,
                            double&);
template bool is_acceptable(const Cell_proof<2>&, const std::vector<Polynomial<Rational, 2>>&, const Rational_box<2>&,
                            double&);
template bool is_acceptable(const Cell_proof<3>&, const std::vector<Polynomial<Rational, 3>>&, const Rational_box<3>&,
                            double&);
template double square_free_work(const Polynomial<Rational, 1>&, const Polynomial<Rational, 1>&, unsigned);
template double square_free_work(const Polynomial<Rational, 2>&, const Polynomial<Rational, 2>&, unsigned);
template double square_free_work(const Polynomial<Rational, 3>&, const Polynomial<Rational, 3>&, unsigned);
template unsigned highest_multiplicity(const Polynomial<Rational, 1>&);
template unsigned highest_multiplicity(const Polynomial<Rational, 2>&);
template unsigned highest_multiplicity(const Polynomial<Rational, 3>&);

} // namespace corral::certificate
