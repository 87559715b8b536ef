// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../commands.h"

#include <corral/bounders/all.h>
#include <corral/number/all.h>
#include <corral/output/all.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <string>
#include <string_view>

namespace corral::program {

namespace {

struct Explanation
{
  std::string_view name;
  std::string_view what;
};

constexpr std::array<Explanation, 9> bounders{{
    {"rt", "recursive Taylor method of any --order, as in the paper"},
    {"maa", "modified affine arithmetic: centred form with the even/odd rule"},
    {"natural", "each term by itself"},
    {"horner", "Horner's scheme, variable by variable"},
    {"centred", "Taylor form about the midpoint, without the even/odd rule"},
    {"affine", "affine arithmetic on Horner's scheme"},
    {"bernstein", "least and greatest Bernstein coefficient"},
    {"mean_value", "mean-value form with bounded gradients"},
    {"intersection", "what several of them have in common"},
}};

constexpr std::array<Explanation, 6> number_types{{
    {"double_nearest", "doubles that round to nearest, as in the paper"},
    {"double_outward", "doubles that step outward, without a rounding mode"},
    {"cgal_interval", "CGAL::Interval_nt, doubles with directed rounding"},
    {"mpfr", "MPFR intervals of --precision bits"},
    {"rational", "exact fractions"},
    {"counted", "double_outward, its additions and multiplications counted"},
}};

void line(std::ostream& out, std::string_view name, std::string_view what)
{
  out << "  " << std::left << std::setw(20) << name << what << '\n';
}

// A line on a method or number type; one that is not explained here is listed all the same.
template <std::size_t n>
void line(std::ostream& out, std::string_view name, const std::array<Explanation, n>& explanations,
          const std::string& before = {})
{
  const auto known =
      std::find_if(explanations.begin(), explanations.end(), [&](const auto& e) { return e.name == name; });
  line(out, name, before + std::string(known == explanations.end() ? std::string_view() : known->what));
}

template <std::size_t D>
void list_writers(std::ostream& out, const char* title)
{
  out << "\nOutput files " << title << " (localize --output):\n";
  for (const auto& writer : writers<D>()) line(out, writer.ending, writer.what);
}

void print_lists(std::ostream& out)
{
  out << "Bounders (--bounder), each as much guaranteed as the number type:\n";
  Bounders::for_each<Rational_interval, 1>([&](auto bounder) { line(out, decltype(bounder)::type::name, bounders); });
  out << "\nNumber types (--number):\n";
  Number_types::for_each([&]<class I>(std::type_identity<I>) {
    line(out, Interval_traits<I>::name, number_types,
         Interval_traits<I>::is_guaranteed ? "guaranteed: " : "not guaranteed: ");
  });
  list_writers<2>(out, "of curves");
  list_writers<3>(out, "of surfaces");
  list_writers<1>(out, "in other dimensions");
}

} // namespace

void add_list(CLI::App& app)
{
  CLI::App* const command = app.add_subcommand("list", "List bounders, number types and kinds of output files");
  command->footer("The names are values of --bounder and --number, the endings those of files for --output.");
  command->callback([] { print_lists(std::cout); });
}

} // namespace corral::program
