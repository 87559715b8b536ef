// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Evaluates Rump's polynomial, on which doubles lose every digit, with one source over five number types.
#include <corral/number/all.h>
#include <corral/number/format.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include <iomanip>
#include <iostream>

using namespace corral;

template <IntervalNumber I>
void print_value(const Polynomial<Rational, 2>& f, const std::string& label)
{
  const typename Interval_traits<I>::Scope scope; // arithmetic with I is valid while it lives
  const auto over_I = transform<I>(f, [](const Rational& coefficient) { return enclose<I>(coefficient); });
  const I value = evaluate(over_I, std::array<I, 2>{I(77617), I(33096)});
  std::cout << std::left << std::setw(18) << label << decimal_text(value, 17)
            << (Interval_traits<I>::is_guaranteed ? "" : "  not guaranteed") << '\n';
}

int main()
{
  // Rump's expression times 2*y; its value at (77617, 33096) is -54767.
  const auto f =
      parse_polynomial<2>("2*y*(333.75*y^6 + x^2*(11*x^2*y^2 - y^6 - 121*y^4 - 2) + 5.5*y^8) + x", {"x", "y"});
  print_value<Nearest_interval>(f, "double_nearest");
  print_value<Outward_interval>(f, "double_outward");
  print_value<Cgal_interval>(f, "cgal_interval");
  for (const long bits : {64L, 128L, 256L}) {
    const Mpfr_precision_scope precision(bits);
    print_value<Mpfr_interval>(f, "mpfr, " + std::to_string(bits) + " bits");
  }
  print_value<Rational_interval>(f, "rational");
}
