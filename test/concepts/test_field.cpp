// SPDX-License-Identifier: LGPL-3.0-or-later
#include "algebra/Extension.h"
#include "algebra/Field_polynomial.h"

#include <gtest/gtest.h>

namespace {

using namespace corral::exact;

/// The integers modulo 7, with what the concept says and nothing else.
struct Archetype
{
  class Element
  {
  public:
    Element() = default;
    [[nodiscard]] bool empty() const { return value_ == 0; }
    friend bool operator==(const Element&, const Element&) = default;

  private:
    friend struct Archetype;
    unsigned value_ = 0;
  };

  [[nodiscard]] static Element of(unsigned long value)
  {
    Element result;
    result.value_ = static_cast<unsigned>(value % 7);
    return result;
  }
  [[nodiscard]] Element one() const { return of(1); }
  [[nodiscard]] Element negative(const Element& a) const { return of(7 - a.value_); }
  [[nodiscard]] Element times(const Element& a, unsigned long n) const { return of(a.value_ * (n % 7)); }
  [[nodiscard]] Element multiply(const Element& a, const Element& b) const { return of(a.value_ * b.value_); }
  [[nodiscard]] Element inverse(const Element& a) const
  {
    Element result = one(); // a^5
    for (int k = 0; k < 5; ++k) result = multiply(result, a);
    return result;
  }
  void subtract(Element& a, const Element& b) const { a = of(a.value_ + 7 - b.value_); }
};
static_assert(Field<Archetype>);
static_assert(Field<Extension>);
static_assert(Field<Tower>);

struct Without_inverse
{
  using Element = Archetype::Element;
  Element one() const;
  Element negative(const Element&) const;
  Element times(const Element&, unsigned long) const;
  Element multiply(const Element&, const Element&) const;
  void subtract(Element&, const Element&) const;
};
struct Of_numbers_that_cannot_be_empty : Archetype
{
  using Element = double;
};
struct Without_elements
{
};
struct Multiplies_only_when_it_may_change : Archetype
{
  Element multiply(const Element&, const Element&);
};
static_assert(!Field<Without_inverse>);
static_assert(!Field<Of_numbers_that_cannot_be_empty>);
static_assert(!Field<Without_elements>);
static_assert(!Field<Multiplies_only_when_it_may_change>);

TEST(Concepts, polynomials_over_a_field_that_offers_no_more)
{
  const Archetype field;
  const auto polynomial = [](std::initializer_list<unsigned long> coefficients) {
    Polynomial_over<Archetype> p;
    for (const auto c : coefficients) p.push_back(Archetype::of(c));
    return p;
  };
  const auto a = polynomial({1, 1}); // x + 1
  const auto b = polynomial({3, 1}); // x + 3
  const auto c = polynomial({2, 5}); // 5 x + 2
  const auto square = product(field, product(field, a, a), b);
  EXPECT_EQ(square, polynomial({3, 0, 5, 1}));
  EXPECT_EQ(square_free_over(field, square), product(field, a, b));
  EXPECT_EQ(gcd_over(field, product(field, c, a), product(field, b, a)), a);
  auto rest = square;
  EXPECT_EQ(divide(field, rest, b), product(field, a, a));
  EXPECT_TRUE(rest.empty());
}

} // namespace
