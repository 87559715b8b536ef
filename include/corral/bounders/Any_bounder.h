// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_ANY_BOUNDER_H
#define CORRAL_BOUNDERS_ANY_BOUNDER_H

#include <corral/bounders/Bounder_options.h>
#include <corral/bounders/all.h>

#include <concepts>
#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>

namespace corral {

/// \brief A bounder chosen at run time, as a value: a copy costs a reference count, and a virtual call goes before
/// each bound.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
template <IntervalNumber I, std::size_t D>
class Any_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "any";

  /// Holds a given bounder.
  template <class B>
    requires(!std::same_as<B, Any_bounder>)
  && RangeBounder<B>
    && std::same_as<typename B::Interval, I> && (B::dimension == D)
  explicit Any_bounder(B bounder) : held_(std::make_shared<const Held<B>>(std::move(bounder)))
  {}

  /// The first of all bounders, with its default options.
  explicit Any_bounder(const Polynomial& f)
  {
    bool is_first = true;
    Bounders::for_each<I, D>([&](auto bounder) {
      if (std::exchange(is_first, false)) *this = make<typename decltype(bounder)::type>(f, {});
    });
  }

  /// The bounder of this name in the list `Bounders`. \throw Invalid_input if there is none, or as its constructor.
  Any_bounder(std::string_view name_of_method, const Polynomial& f, const Bounder_options& options = {})
  {
    Bounders::visit<I, D>(name_of_method,
                          [&](auto bounder) { *this = make<typename decltype(bounder)::type>(f, options); });
  }

  [[nodiscard]] I bound(const Box& box) const { return held_->bound(box); }

  /// The name of the method that is held.
  [[nodiscard]] std::string_view method() const { return held_->method(); }

private:
  struct Holder
  {
    virtual ~Holder() = default;
    [[nodiscard]] virtual I bound(const Box& box) const = 0;
    [[nodiscard]] virtual std::string_view method() const = 0;
  };

  template <class B>
  struct Held final : Holder
  {
    explicit Held(B b) : bounder(std::move(b)) {}
    [[nodiscard]] I bound(const Box& box) const override { return bounder.bound(box); }
    [[nodiscard]] std::string_view method() const override { return B::name; }
    B bounder;
  };

  template <class B>
  static Any_bounder make(const Polynomial& f, const Bounder_options& options)
  {
    if constexpr (std::constructible_from<B, const Polynomial&, const Bounder_options&>)
      return Any_bounder(B(f, options));
    else
      return Any_bounder(B(f));
  }

  std::shared_ptr<const Holder> held_;
};

} // namespace corral

#endif
