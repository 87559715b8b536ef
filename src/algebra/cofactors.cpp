// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cofactors.h"

#include "../number/Prime_field.h"
#include "../polynomial/Flint_ring.h"
#include "../polynomial/to_exponent.h"
#include "Interpolation.h"
#include "multivariate.h"

#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/arithmetic.h>

#include <flint/fmpz_mpoly_factor.h>
#include <flint/nmod_poly.h>

#include <algorithm>
#include <array>
#include <string>

namespace corral::exact {
namespace {

using Residues = Interpolation::Residues;

/// Owner of a FLINT polynomial in one variable modulo a prime.
class Line
{
public:
  explicit Line(const nmod_t& modulus) { nmod_poly_init_mod(value_, modulus); }
  Line(const nmod_t& modulus, const Residues& coefficients) : Line(modulus)
  {
    for (std::size_t i = coefficients.size(); i-- > 0;)
      nmod_poly_set_coeff_ui(value_, static_cast<slong>(i), coefficients[i]);
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line() { nmod_poly_clear(value_); }

  [[nodiscard]] nmod_poly_struct* get() { return value_; }
  [[nodiscard]] std::uint64_t operator[](std::size_t i) const
  {
    return nmod_poly_get_coeff_ui(value_, static_cast<slong>(i));
  }

private:
  nmod_poly_t value_;
};

/// The cofactors and the resultant at points of the other variables, modulo one prime.
///
/// Polynomials are dense, the variables in the order of `parameters`, then the eliminated one, the last running
/// fastest.
template <std::size_t D>
class Sampler
{
public:
  static constexpr std::size_t parameter_count = D - 1;

  Sampler(std::size_t axis, std::array<std::size_t, D - 1> points, const Checkpoint& checkpoint)
      : axis_(axis), points_(points), checkpoint_(checkpoint)
  {
    for (std::size_t k = 0, to = 0; k < D; ++k)
      if (k != axis) parameters_[to++] = k;
  }

  void set_prime(std::uint64_t prime) { nmod_init(&modulus_, prime); }

  [[nodiscard]] Residues image(const Polynomial<Integer, D>& f) const
  {
    std::size_t count = f.degree(axis_) + 1U;
    for (const std::size_t k : parameters_) count *= f.degree(k) + 1U;
    Residues result(count);
    for (const auto& term : f.terms()) {
      std::size_t index = 0;
      for (const std::size_t k : parameters_) index = index * (f.degree(k) + 1U) + term.exponents[k];
      result[index * (f.degree(axis_) + 1U) + term.exponents[axis_]] =
          mpz_fdiv_ui(term.coefficient.get_mpz_t(), modulus_.n);
    }
    return result;
  }

  /// \brief The residues of all coefficients: one after the other for a_0, ..., b_0, ..., and the resultant, each dense
  /// in the parameters with `points` coefficients. Nothing if too few points are good.
  [[nodiscard]] std::optional<Residues> sample(const Residues& f, std::size_t f_size, const Residues& g,
                                               std::size_t g_size, std::size_t parameter = 0)
  {
    if (parameter == parameter_count) return at_point(f, f_size, g, g_size);
    const std::size_t count = points_[parameter];
    const std::uint64_t patience = 2 * count + 20;
    Residues places;
    std::vector<Residues> values;
    for (std::uint64_t t = 1; places.size() < count; ++t) {
      if (t > patience) return std::nullopt;
      if (checkpoint_) checkpoint_();
      auto value = sample(substituted(f, f_size, parameter, t, f_degrees), f_size,
                          substituted(g, g_size, parameter, t, g_degrees), g_size, parameter + 1);
      if (!value) continue;
      places.push_back(t);
      values.push_back(std::move(*value));
    }
    return interpolated(places, values, f_size + g_size - 1);
  }

  std::array<std::size_t, D - 1> f_degrees{}; ///< in the parameters
  std::array<std::size_t, D - 1> g_degrees{};

  [[nodiscard]] const std::array<std::size_t, D - 1>& parameters() const { return parameters_; }

private:
  /// Sets the first parameter that is left to t, by Horner's rule over blocks.
  [[nodiscard]] Residues substituted(const Residues& f, std::size_t size, std::size_t parameter, std::uint64_t t,
                                     const std::array<std::size_t, D - 1>& degrees) const
  {
    std::size_t block = size;
    for (std::size_t k = parameter + 1; k < parameter_count; ++k) block *= degrees[k] + 1;
    Residues result(block);
    for (std::size_t i = degrees[parameter] + 1; i-- > 0;)
      for (std::size_t j = 0; j < block; ++j)
        result[j] = nmod_add(nmod_mul(result[j], t, modulus_), f[i * block + j], modulus_);
    return result;
  }

  [[nodiscard]] std::optional<Residues> at_point(const Residues& f, std::size_t f_size, const Residues& g,
                                                 std::size_t g_size) const
  {
    if (f.back() == 0 || g.back() == 0) return std::nullopt;
    Line p(modulus_, f);
    Line q(modulus_, g);
    const std::uint64_t resultant = nmod_poly_resultant(p.get(), q.get());
    if (resultant == 0) return std::nullopt;
    Line divisor(modulus_);
    Line a(modulus_);
    Line b(modulus_);
    nmod_poly_xgcd(divisor.get(), a.get(), b.get(), p.get(), q.get());
    Residues result;
    for (std::size_t i = 0; i + 1 < g_size; ++i) result.push_back(nmod_mul(a[i], resultant, modulus_));
    for (std::size_t i = 0; i + 1 < f_size; ++i) result.push_back(nmod_mul(b[i], resultant, modulus_));
    result.push_back(resultant);
    return result;
  }

  /// From the values at points of one parameter to its coefficients, which become the slower index of each slot.
  [[nodiscard]] Residues interpolated(const Residues& places, const std::vector<Residues>& values,
                                      std::size_t slots) const
  {
    const Interpolation interpolation(modulus_.n, places);
    const std::size_t inner = values.front().size() / slots;
    Residues result(values.front().size() * places.size());
    Residues column(places.size());
    for (std::size_t slot = 0; slot < slots; ++slot)
      for (std::size_t j = 0; j < inner; ++j) {
        for (std::size_t i = 0; i < places.size(); ++i) column[i] = values[i][slot * inner + j];
        const Residues coefficients = interpolation(column);
        for (std::size_t i = 0; i < places.size(); ++i)
          result[(slot * places.size() + i) * inner + j] = coefficients[i];
      }
    return result;
  }

  std::size_t axis_;
  std::array<std::size_t, D - 1> parameters_{};
  std::array<std::size_t, D - 1> points_;
  const Checkpoint& checkpoint_;
  nmod_t modulus_{};
};

/// Reads the coefficients of one slot of a sample as terms with a given exponent of the eliminated variable.
template <std::size_t D>
void append_terms(std::vector<typename Polynomial<Integer, D>::Term>& terms, const std::vector<Integer>& values,
                  std::size_t slot, const std::array<std::size_t, D - 1>& parameters,
                  const std::array<std::size_t, D - 1>& points, std::size_t axis, std::size_t exponent)
{
  std::size_t count = 1;
  for (const std::size_t n : points) count *= n;
  for (std::size_t i = 0; i < count; ++i) {
    const Integer& value = values[slot * count + i];
    if (value == 0) continue;
    Exponents<D> exponents{};
    exponents[axis] = detail::to_exponent(exponent);
    std::size_t rest = i;
    for (std::size_t k = D - 1; k-- > 0; rest /= points[k])
      exponents[parameters[k]] = detail::to_exponent(rest % points[k]);
    terms.push_back({exponents, value});
  }
}

/// Divides all three by what they have in common.
template <std::size_t D>
void reduce(Cofactors<D>& result, std::size_t axis)
{
  std::vector<std::vector<typename Polynomial<Integer, D>::Term>> parts;
  for (const auto* f : {&result.a, &result.b})
    for (const auto& term : f->terms()) {
      auto exponents = term.exponents;
      const std::size_t power = exponents[axis] + (f == &result.b ? result.a.degree(axis) + 1U : 0U);
      exponents[axis] = 0;
      if (parts.size() <= power) parts.resize(power + 1);
      parts[power].push_back({exponents, term.coefficient});
    }
  auto divisor = result.combination;
  for (auto& part : parts)
    if (!part.empty() && !divisor.is_constant())
      divisor = common_factor(divisor, collect<Integer, D>(std::move(part))).divisor;
  for (auto* f : {&result.a, &result.b, &result.combination})
    if (!f->is_zero() && !divisor.is_constant()) *f = common_factor(*f, divisor).f;
  Integer common = content(result.combination);
  for (const auto* f : {&result.a, &result.b}) common = gcd(common, content(*f));
  for (auto* f : {&result.a, &result.b, &result.combination})
    *f = transform<Integer>(*f, [&](const Integer& c) { return Integer(c / common); });
}

} // namespace

template <std::size_t D>
std::optional<Cofactors<D>> cofactors(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g,
                                      std::size_t axis, const Checkpoint& checkpoint)
{
  constexpr std::size_t max_samples = 6000;
  constexpr std::size_t max_primes = 2000;
  const std::size_t f_size = f.degree(axis) + 1U;
  const std::size_t g_size = g.degree(axis) + 1U;
  if (g_size == 1) return Cofactors<D>{{}, constant<Integer, D>(1), g};
  std::array<std::size_t, D - 1> points{};
  std::size_t count = 1;
  for (std::size_t k = 0, to = 0; k < D; ++k)
    if (k != axis)
      count *= points[to++] = 1
                              + std::min<std::size_t>((g_size - 1) * f.degree(k) + (f_size - 1) * g.degree(k),
                                                      std::size_t{f.total_degree()} * g.total_degree());
  if (count > max_samples) return std::nullopt;
  Sampler<D> sampler(axis, points, checkpoint);
  for (std::size_t k = 0; k < D - 1; ++k) {
    sampler.f_degrees[k] = f.degree(sampler.parameters()[k]);
    sampler.g_degrees[k] = g.degree(sampler.parameters()[k]);
  }
  Chinese_remainder remainder;
  std::vector<Integer> last;
  Large_primes primes;
  for (std::size_t used = 0, failures = 0; used < max_primes && failures < 3; ++used) {
    const std::uint64_t prime = primes.next();
    sampler.set_prime(prime);
    const auto sample = sampler.sample(sampler.image(f), f_size, sampler.image(g), g_size);
    if (!sample) {
      ++failures;
      continue;
    }
    remainder.add(prime, *sample);
    auto values = remainder.symmetric();
    const bool is_stable = values == last;
    last = std::move(values);
    if (!is_stable) continue;
    std::array<std::vector<typename Polynomial<Integer, D>::Term>, 3> terms;
    const auto append = [&](std::size_t which, std::size_t slot, std::size_t exponent) {
      append_terms<D>(terms[which], last, slot, sampler.parameters(), points, axis, exponent);
    };
    for (std::size_t i = 0; i + 1 < g_size; ++i) append(0, i, i);
    for (std::size_t i = 0; i + 1 < f_size; ++i) append(1, g_size - 1 + i, i);
    append(2, f_size + g_size - 2, 0);
    Cofactors<D> result{collect<Integer, D>(std::move(terms[0])), collect<Integer, D>(std::move(terms[1])),
                        collect<Integer, D>(std::move(terms[2]))};
    if (!(result.a * f + result.b * g == result.combination)) continue;
    reduce(result, axis);
    return result;
  }
  return std::nullopt;
}

template <std::size_t D>
std::vector<std::pair<Polynomial<Integer, D>, unsigned>> square_free_factors(const Polynomial<Integer, D>& f)
{
  const detail::Flint_ring ring(D);
  detail::Flint_polynomial whole(ring, detail::flat_terms(f));
  detail::Flint_polynomial base(ring);
  fmpz_mpoly_factor_t factors;
  fmpz_mpoly_factor_init(factors, ring.context());
  const bool is_done = fmpz_mpoly_factor_squarefree(factors, whole.get(), ring.context()) != 0;
  std::vector<std::pair<Polynomial<Integer, D>, unsigned>> result;
  for (slong k = 0; is_done && k < fmpz_mpoly_factor_length(factors, ring.context()); ++k) {
    fmpz_mpoly_factor_get_base(base.get(), factors, k, ring.context());
    result.emplace_back(detail::from_flat_terms<D>(base.terms()),
                        static_cast<unsigned>(fmpz_mpoly_factor_get_exp_si(factors, k, ring.context())));
  }
  fmpz_mpoly_factor_clear(factors, ring.context());
  if (!is_done)
    throw Budget_exceeded("elimination: the square-free factors of a polynomial of " + std::to_string(f.terms().size())
                          + " terms do not fit in memory; expected a smaller one");
  return result;
}

template std::optional<Cofactors<2>> cofactors(const Polynomial<Integer, 2>&, const Polynomial<Integer, 2>&,
                                               std::size_t, const Checkpoint&);
template std::optional<Cofactors<3>> cofactors(const Polynomial<Integer, 3>&, const Polynomial<Integer, 3>&,
                                               std::size_t, const Checkpoint&);
template std::vector<std::pair<Polynomial<Integer, 2>, unsigned>> square_free_factors(const Polynomial<Integer, 2>&);
template std::vector<std::pair<Polynomial<Integer, 3>, unsigned>> square_free_factors(const Polynomial<Integer, 3>&);

} // namespace corral::exact
