// SPDX-License-Identifier: LGPL-3.0-or-later
#include "commands.h"

#include <corral/bounders/all.h>
#include <corral/number/all.h>
#include <corral/output/all.h>

#include <iomanip>
#include <iostream>

namespace corral::program {

namespace {

void line(std::string_view name, std::string_view what)
{
  std::cout << "  " << std::left << std::setw(20) << name << what << '\n';
}

template <std::size_t D>
void list_writers(const char* title)
{
  std::cout << "\nOutput files " << title << " (localize --output):\n";
  for (const auto& writer : writers<D>()) line(writer.ending, writer.what);
}

void list_command()
{
  std::cout << "Bounders (--bounder), each as much guaranteed as the number type:\n";
  Bounders::for_each<Rational_interval, 1>(
      [](auto bounder) { std::cout << "  " << decltype(bounder)::type::name << '\n'; });
  std::cout << "\nNumber types (--number):\n";
  Number_types::for_each([]<class I>(std::type_identity<I>) {
    line(Interval_traits<I>::name,
         Interval_traits<I>::is_guaranteed ? "guaranteed" : "not guaranteed: rounds to nearest");
  });
  list_writers<2>("of curves");
  list_writers<3>("of surfaces");
  list_writers<1>("in other dimensions");
}

} // namespace

void add_list(CLI::App& app)
{
  app.add_subcommand("list", "List bounders, number types and kinds of output files")->callback(list_command);
}

} // namespace corral::program
