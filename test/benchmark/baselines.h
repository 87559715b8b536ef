// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_BENCHMARK_BASELINES_H
#define CORRAL_TEST_BENCHMARK_BASELINES_H

#include <corral/internal/localization/Subdivision.h>
#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

/// \file
/// What a user would write with an interval library: Horner's rule or the mean-value form in each node of the tree.
namespace corral::benchmark {

/// How a baseline talks to an interval library: `number`, `span`, `zero_inside`.
template <class I>
struct Interval_access;

/// A polynomial over intervals, evaluated by Horner's rule nested by variables, zero terms left out.
template <class I, std::size_t D>
class Nested_horner
{
public:
  explicit Nested_horner(const Polynomial<Rational, D>& f)
  {
    if constexpr (D == 0) return;
    for (const auto& term : f.terms()) {
      const auto power = static_cast<std::size_t>(term.exponents[0]);
      if (parts_.size() <= power) parts_.resize(power + 1);
      if constexpr (D == 1) {
        parts_[power] = {true, Interval_access<I>::number(term.coefficient)};
      } else {
        Exponents<D - 1> rest;
        std::copy(term.exponents.begin() + 1, term.exponents.end(), rest.begin());
        inner_.resize(parts_.size());
        inner_[power].push_back({rest, term.coefficient});
        parts_[power].present = true;
      }
    }
    if constexpr (D > 1)
      for (const auto& terms : inner_) nested_.emplace_back(Polynomial<Rational, D - 1>(terms));
  }
  [[nodiscard]] I operator()(const I* x) const
  {
    if (parts_.empty()) return Interval_access<I>::number(0);
    I value = part(parts_.size() - 1, x);
    for (std::size_t k = parts_.size() - 1; k-- > 0;) {
      value = value * x[0];
      if (parts_[k].present) value = value + part(k, x);
    }
    return value;
  }

private:
  struct Part
  {
    bool present = false;
    I constant{};
  };
  [[nodiscard]] I part(std::size_t k, const I* x) const
  {
    if constexpr (D == 1)
      return parts_[k].constant;
    else
      return nested_[k](x + 1);
  }
  using Lower = Polynomial<Rational, (D > 1 ? D - 1 : 1)>;
  std::vector<Part> parts_;
  std::vector<std::vector<typename Lower::Term>> inner_;
  std::vector<Nested_horner<I, (D > 1 ? D - 1 : 1)>> nested_;
};

template <class I, std::size_t D>
struct Natural_bound
{
  explicit Natural_bound(const Polynomial<Rational, D>& f) : horner(f) {}
  [[nodiscard]] I operator()(const std::array<I, D>& box, const std::array<I, D>&) const { return horner(box.data()); }
  Nested_horner<I, D> horner;
};

/// f(c) + sum_i f_i(X) (X_i - c_i).
template <class I, std::size_t D>
struct Mean_value_bound
{
  explicit Mean_value_bound(const Polynomial<Rational, D>& f) : horner(f)
  {
    for (std::size_t axis = 0; axis < D; ++axis) gradient.emplace_back(derivative(f, axis));
  }
  [[nodiscard]] I operator()(const std::array<I, D>& box, const std::array<I, D>& centre) const
  {
    I sum = horner(centre.data());
    for (std::size_t axis = 0; axis < D; ++axis) sum = sum + gradient[axis](box.data()) * (box[axis] - centre[axis]);
    return sum;
  }
  Nested_horner<I, D> horner;
  std::vector<Nested_horner<I, D>> gradient;
};

/// \brief Form of the subdivision loop that bounds every node afresh and counts the cells that it cannot drop.
/// \pre The box is [lower, 1]^D and the resolution a power of two, so that all coordinates are exact doubles.
template <class I, std::size_t D, class Bound>
class Plain_form
{
public:
  Plain_form(const Polynomial<Rational, D>& f, int lower, const Resolution<D>& resolution)
      : bound_(f), tree_(resolution), lower_(lower), step_((1.0 - lower) / resolution[0])
  {}
  bool begin(const Subdivision_node<D>& root) { return may_vanish(root); }
  bool decides(const Subdivision_node<D>& node) const { return node.level == 0; }
  void decide(const Subdivision_node<D>&) { ++cells_; }
  unsigned split(const Subdivision_node<D>& node, unsigned mask)
  {
    unsigned kept = 0;
    for (unsigned child = 0; child < 1U << D; ++child)
      if ((mask >> child & 1) != 0 && may_vanish(tree_.child(node, child))) kept |= 1U << child;
    return kept;
  }
  void descend(const Subdivision_node<D>&, unsigned) {}
  [[nodiscard]] std::uint64_t cells() const { return cells_; }
  [[nodiscard]] const Subdivision_tree<D>& tree() const { return tree_; }

private:
  bool may_vanish(const Subdivision_node<D>& node)
  {
    std::array<I, D> box;
    std::array<I, D> centre;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double low = lower_ + step_ * node.corner[axis];
      const double width = step_ * tree_.span(node.level, axis);
      box[axis] = Interval_access<I>::span(low, low + width);
      centre[axis] = Interval_access<I>::span(low + width / 2, low + width / 2);
    }
    return Interval_access<I>::zero_inside(bound_(box, centre));
  }
  Bound bound_;
  Subdivision_tree<D> tree_;
  double lower_;
  double step_;
  std::uint64_t cells_ = 0;
};

/// The cells that the baseline plots.
template <class I, std::size_t D, template <class, std::size_t> class Bound>
std::uint64_t plain_cells(const Polynomial<Rational, D>& f, int lower, std::uint32_t n)
{
  Resolution<D> resolution;
  resolution.fill(n);
  Plain_form<I, D, Bound<I, D>> form(f, lower, resolution);
  subdivide(form.tree(), form);
  return form.cells();
}

} // namespace corral::benchmark

#endif
