// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Shadows.h"

#include "multivariate.h"

#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/substitution.h>

#include <utility>

namespace corral::exact {

namespace {

/// g with the variables y and z exchanged.
Polynomial<Integer, 3> exchange(const Polynomial<Integer, 3>& g)
{
  std::vector<Polynomial<Integer, 3>::Term> terms;
  for (auto term : g.terms()) {
    std::swap(term.exponents[1], term.exponents[2]);
    terms.push_back(std::move(term));
  }
  return collect<Integer, 3>(std::move(terms));
}

} // namespace

template <std::size_t D>
Bernstein_form<D> bernstein_form(const Polynomial<Integer, D>& f, const Rational_box<D>& box)
{
  std::array<Rational, D> offset;
  std::array<Rational, D> scale;
  for (std::size_t k = 0; k < D; ++k) {
    offset[k] = box[k].lower();
    scale[k] = box[k].upper() - box[k].lower();
  }
  auto form = dense_power_form(integer_primitive(
      affine_substitution(transform<Rational>(f, [](const Integer& c) { return Rational(c); }), offset, scale)));
  to_bernstein(form);
  return form;
}

template Bernstein_form<2> bernstein_form(const Polynomial<Integer, 2>&, const Rational_box<2>&);
template Bernstein_form<3> bernstein_form(const Polynomial<Integer, 3>&, const Rational_box<3>&);

Shadows::Shadows(const Polynomial<Integer, 3>& g, const Checkpoint& checkpoint)
{
  for (const std::size_t which : {0U, 1U}) {
    // Factors without the variable are cylinders along it, which cross the boundary of every box they meet.
    const auto turned = which == 0 ? g : exchange(g);
    const auto slope = derivative(turned, 2);
    if (slope.is_zero()) {
      nothing_inside_ = true;
      return;
    }
    const auto free = common_factor(turned, slope).f;
    const auto free_slope = derivative(free, 2);
    if (checkpoint) checkpoint();
    const auto outline = projection(free, free_slope);
    if (!outline || outline->is_zero()) continue;
    outline_[which] = *outline;
    plane_[which] = std::make_unique<Zero_set<2>>([f = *outline] { return f; }, checkpoint, Witnesses::simple);
  }
}

bool Shadows::exclude(const Rational_box<3>& box)
{
  if (nothing_inside_) return true;
  for (const std::size_t which : {0U, 1U}) {
    if (!plane_[which]) continue;
    const Rational_box<2> side = {box[0], box[which == 0 ? 1 : 2]};
    if (plane_[which]->decide(bernstein_form(outline_[which], side), side).verdict == Verdict::empty) return true;
  }
  return false;
}

} // namespace corral::exact
