// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bernstein.h"

#include <algorithm>

namespace corral_check {
namespace {

/// A side as integers: [lower / denominator, upper / denominator].
struct Integer_side
{
  mpz_class lower, upper, denominator;
};

Integer_side to_integers(const Side& side)
{
  Integer_side result;
  result.denominator = lcm(side.lower.get_den(), side.upper.get_den());
  result.lower = side.lower.get_num() * (result.denominator / side.lower.get_den());
  result.upper = side.upper.get_num() * (result.denominator / side.upper.get_den());
  return result;
}

std::size_t stride_of(const std::vector<std::size_t>& sizes, std::size_t axis)
{
  std::size_t stride = 1;
  for (std::size_t later = axis + 1; later < sizes.size(); ++later) stride *= sizes[later];
  return stride;
}

/// Calls `visit(first)` with the position of the first entry of each line along the axis.
template <class Visitor>
void for_each_line(const std::vector<std::size_t>& sizes, std::size_t axis, std::size_t total, Visitor&& visit)
{
  const std::size_t stride = stride_of(sizes, axis);
  for (std::size_t outer = 0; outer < total; outer += stride * sizes[axis])
    for (std::size_t inner = 0; inner < stride; ++inner) visit(outer + inner);
}

double count(const Bernstein_form& form) { return static_cast<double>(form.coefficients.size()); }

/// The coefficients on the grid of all exponents, times their common denominator; sets the bound of their bits.
void fill_dense(Bernstein_form& form, const Polynomial& f, Budget& budget)
{
  mpz_class common = 1;
  double longest = 0;
  for (const auto& [exponents, coefficient] : f) {
    budget.fractions(words(bits(common)) + length(coefficient));
    common = lcm(common, coefficient.get_den());
    longest = std::max(longest, bits(coefficient.get_num()));
  }
  form.bit_bound = longest + bits(common) + bits(mpz_class(static_cast<unsigned long>(f.size())));
  Budget::require_form_words(form.held());
  for (const auto& [exponents, coefficient] : f) {
    budget.fractions(words(bits(common)) + length(coefficient));
    std::size_t position = 0;
    for (std::size_t axis = 0; axis < form.sizes.size(); ++axis)
      position = position * form.sizes[axis] + exponents[axis];
    form.coefficients[position] = coefficient.get_num() * (common / coefficient.get_den());
  }
}

/// \brief Replaces the coefficients a_j of x^j by those of v^i in sum_j a_j (p + q v)^j (r (1 + v))^(n-j), where the
/// side is [p/r, q/r]: the substitution u = v / (1 + v), times r^n.
void substitute_side(std::vector<mpz_class>& line, const Integer_side& side)
{
  const std::size_t n = line.size() - 1;
  std::vector<mpz_class> sum{line[n]};
  std::vector<mpz_class> rest{1}; // (r (1 + v))^(n-j)
  for (std::size_t j = n; j-- > 0;) {
    sum.emplace_back();
    rest.emplace_back();
    for (std::size_t i = sum.size(); i-- > 0;) {
      sum[i] = i > 0 ? mpz_class(sum[i] * side.lower + sum[i - 1] * side.upper) : mpz_class(sum[i] * side.lower);
      rest[i] = i > 0 ? mpz_class((rest[i] + rest[i - 1]) * side.denominator) : mpz_class(rest[i] * side.denominator);
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += line[j] * rest[i];
  }
  line = std::move(sum);
}

/// The factors that turn coefficients of v^i into Bernstein coefficients: lcm(binomials) / binomial(n, i).
std::vector<mpz_class> bernstein_weights(std::size_t n)
{
  std::vector<mpz_class> binomials(n + 1);
  mpz_class common = 1;
  for (std::size_t i = 0; i <= n; ++i) {
    mpz_bin_uiui(binomials[i].get_mpz_t(), n, i);
    common = lcm(common, binomials[i]);
  }
  for (mpz_class& binomial : binomials) binomial = common / binomial;
  return binomials;
}

/// Divides all coefficients by the largest common power of two.
void shorten(std::vector<mpz_class>& values)
{
  mp_bitcnt_t common = ~mp_bitcnt_t{0};
  for (const mpz_class& value : values)
    if (value != 0) common = std::min(common, mpz_scan1(value.get_mpz_t(), 0));
  if (common == 0) return;
  for (mpz_class& value : values)
    if (value != 0) value >>= common;
}

/// Calls `visit(sign)` for each corner coefficient.
template <class Visitor>
void for_each_corner(const Bernstein_form& form, Visitor&& visit)
{
  for (unsigned corner = 0; corner < 1U << form.sizes.size(); ++corner) {
    std::size_t position = 0;
    for (std::size_t axis = 0; axis < form.sizes.size(); ++axis)
      position = position * form.sizes[axis] + ((corner >> axis & 1) != 0 ? form.sizes[axis] - 1 : 0);
    visit(sgn(form.coefficients[position]));
  }
}

} // namespace

double Bernstein_form::held() const { return count(*this) * (words(bit_bound) + 5); }

Bernstein_form bernstein(const Polynomial& f, const Box& box, Budget& budget)
{
  Bernstein_form result;
  std::size_t total = 1;
  const Exponents highest = degrees(f);
  for (std::size_t axis = 0; axis < box.size(); ++axis) {
    result.sizes.push_back(highest[axis] + 1);
    total *= result.sizes.back();
  }
  result.coefficients.resize(total);
  fill_dense(result, f, budget);
  for (std::size_t axis = 0; axis < box.size(); ++axis) {
    const std::size_t size = result.sizes[axis];
    if (size == 1) continue;
    const Integer_side side = to_integers(box[axis]);
    const double side_bits = std::max({bits(side.lower), bits(side.upper), bits(side.denominator)});
    const auto n = static_cast<double>(size - 1);
    result.bit_bound += n * (side_bits + 3);
    Budget::require_form_words(result.held());
    budget.work(count(result) * (n + 1) * words(result.bit_bound) * words(side_bits));
    const std::vector<mpz_class> weights = bernstein_weights(size - 1);
    const std::size_t stride = stride_of(result.sizes, axis);
    std::vector<mpz_class> line(size);
    for_each_line(result.sizes, axis, total, [&](std::size_t first) {
      for (std::size_t i = 0; i < size; ++i) line[i] = result.coefficients[first + i * stride];
      substitute_side(line, side);
      for (std::size_t i = 0; i < size; ++i) result.coefficients[first + i * stride] = line[i] * weights[i];
    });
  }
  shorten(result.coefficients);
  return result;
}

std::pair<Bernstein_form, Bernstein_form> halve(const Bernstein_form& form, std::size_t axis, Budget& budget)
{
  std::pair<Bernstein_form, Bernstein_form> result;
  const std::size_t n = form.sizes[axis] - 1;
  for (Bernstein_form* half : {&result.first, &result.second}) {
    half->sizes = form.sizes;
    half->bit_bound = form.bit_bound + static_cast<double>(n);
    half->coefficients.resize(form.coefficients.size());
  }
  budget.work(count(form) * static_cast<double>(n + 1) * words(result.first.bit_bound));
  auto& low = result.first.coefficients;
  auto& high = result.second.coefficients;
  const std::size_t stride = stride_of(form.sizes, axis);
  std::vector<mpz_class> row(n + 1);
  for_each_line(form.sizes, axis, low.size(), [&](std::size_t first) {
    for (std::size_t i = 0; i <= n; ++i) row[i] = form.coefficients[first + i * stride];
    for (std::size_t step = 0; step <= n; ++step) { // de Casteljau's sums without their factors 1/2: all times 2^n
      if (step > 0)
        for (std::size_t i = 0; i <= n - step; ++i) row[i] += row[i + 1];
      low[first + step * stride] = row[0] << (n - step);
      high[first + (n - step) * stride] = row[n - step] << (n - step);
    }
  });
  shorten(low);
  shorten(high);
  return result;
}

Bernstein_form facet(const Bernstein_form& form, std::size_t axis, bool is_upper, Budget& budget)
{
  Bernstein_form result;
  result.sizes = form.sizes;
  result.sizes[axis] = 1;
  result.bit_bound = form.bit_bound;
  budget.work(count(form));
  const std::size_t offset = is_upper ? stride_of(form.sizes, axis) * (form.sizes[axis] - 1) : 0;
  for_each_line(form.sizes, axis, form.coefficients.size(),
                [&](std::size_t first) { result.coefficients.push_back(form.coefficients[first + offset]); });
  return result;
}

bool excludes_zero(const Bernstein_form& form)
{
  const int sign = sgn(form.coefficients.front()); // the first coefficient belongs to a corner
  bool corners = sign != 0;
  for_each_corner(form, [&](int corner) { corners = corners && corner == sign; });
  return corners && std::all_of(form.coefficients.begin(), form.coefficients.end(), [&](const mpz_class& value) {
           return sgn(value) != -sign;
         });
}

bool corners_show_zero(const Bernstein_form& form)
{
  const int sign = sgn(form.coefficients.front());
  bool same = sign != 0;
  for_each_corner(form, [&](int corner) { same = same && corner == sign; });
  return !same;
}

int strict_sign(Polynomial f, const Box& box, Budget& budget)
{
  for (std::size_t axis = 0; axis < box.size(); ++axis)
    if (box[axis].is_flat()) f = restrict_to(f, axis, box[axis].lower, budget);
  if (f.empty()) return 0;
  const Bernstein_form form = bernstein(f, box, budget);
  const int sign = sgn(form.coefficients.front());
  return std::all_of(form.coefficients.begin(), form.coefficients.end(),
                     [&](const mpz_class& value) { return sgn(value) == sign; })
             ? sign
             : 0;
}

} // namespace corral_check
