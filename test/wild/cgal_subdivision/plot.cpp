// SPDX-License-Identifier: LGPL-3.0-or-later
// CGAL::Subdivision_2, an undocumented header that CGAL installs, over doubles; prints the pixels it draws.
// It uses names of libraries that CGAL no longer has; the first part of this file says what they mean.
// usage: plot X_LOW X_HIGH Y_LOW Y_HIGH COLUMNS ROWS   with the polynomial EXPRESSION in x and y
#include <CGAL/Interval_nt.h>
#include <CGAL/Polynomial.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

using Univariate = CGAL::Polynomial<double>;
using Bivariate = CGAL::Polynomial<Univariate>;

// Prints the centre of each pixel that is drawn.
struct QPainter
{
  double box[4]; // of x, then y
  int columns, rows;
  void drawPoint(int x, int y)
  {
    std::printf("point %.17g,%.17g\n", box[0] + (box[1] - box[0]) * (x + 0.5) / columns,
                box[2] + (box[3] - box[2]) * (rows - y + 0.5) / rows);
  }
};

namespace NiX {

Univariate substitute_x(const Bivariate& f, double x)
{
  std::vector<double> values;
  for (const Univariate& coefficient : f) values.push_back(coefficient.evaluate(x));
  return Univariate(values.begin(), values.end());
}

double substitute_xy(const Bivariate& f, double x, double y) { return substitute_x(f, x).evaluate(y); }

Bivariate diff_x(const Bivariate& f)
{
  std::vector<Univariate> coefficients(f.begin(), f.end());
  for (Univariate& coefficient : coefficients) coefficient.diff();
  return Bivariate(coefficients.begin(), coefficients.end());
}

} // namespace NiX

namespace SoX {

template <class NT>
struct Curve_renderer_traits
{
  struct Same
  {
    NT operator()(const NT& value) const { return value; }
  };
  struct Nothing
  {
    void operator()(NT&) const {}
  };
  using Integer = int;
  using To_integer = Same;
  using To_machine_int = Same;
  using From_rational = Same;
  using Make_exact = Nothing;
};

// A range of values. (The affine forms were of another library.)
template <class NT>
struct Affine_form : CGAL::Interval_nt<>
{
  Affine_form() = default;
  Affine_form(NT value) : CGAL::Interval_nt<>(value) {}
  Affine_form(NT lower, NT upper) : CGAL::Interval_nt<>(std::min(lower, upper), std::max(lower, upper)) {}
  Affine_form(const CGAL::Interval_nt<>& range) : CGAL::Interval_nt<>(range) {}
  void convert(NT& lower, NT& upper) const { lower = this->inf(), upper = this->sup(); }
};

} // namespace SoX

namespace CGAL {

constexpr int X_RANGE = 0;

inline Bivariate transpose_bivariate_polynomial(const Bivariate& f)
{
  return Polynomial_traits_d<Bivariate>::Swap()(f, 0, 1);
}

namespace Intern {

template <class NT>
struct Range_templ
{
};

template <class Coefficient>
struct Max_coeff
{
  template <class Polynomial>
  Coefficient operator()(const Polynomial&) const
  {
    return 1;
  }
};

template <class Result, class Coefficient, class Rational, class Convert, class Make_exact>
struct Transform
{
  Rational max;
  Result operator()(const Result& f) const { return f; }
};

} // namespace Intern
} // namespace CGAL

#define CGAL_CKVA_CURVE_RENDERER_INTERNALS_H // of another renderer
#include <CGAL/Curved_kernel_via_analysis_2/gfx/Subdivision_2.h>

struct Curve
{
  using Rational = double;
  using Poly_d = Bivariate;
};

int main(int, char** arguments)
{
  QPainter painter;
  for (int i = 0; i < 4; ++i) painter.box[i] = std::atof(arguments[i + 1]);
  painter.columns = std::atoi(arguments[5]);
  painter.rows = std::atoi(arguments[6]);

  const Bivariate x(Univariate(0.0, 1.0)), y(Univariate(0.0), Univariate(1.0));
  const auto& box = painter.box;
  CGAL::Subdivision_2<double, Curve> subdivision;
  subdivision.setup(box[0], box[2], box[1], box[3], painter.columns, painter.rows);
  subdivision.set_polynomial(EXPRESSION);
  subdivision.draw(&painter);
}
