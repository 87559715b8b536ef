// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Paper_subjects.h"

#include "../arguments.h"
#include "../reproduce/examples.h"

namespace corral::program {

template <std::size_t D>
Paper_subjects<D> paper_subjects()
{
  Paper_subjects<D> result;
  for (const Example& example : examples()) {
    if (example.dimension != D) continue;
    const std::vector<Formula> text{std::string(example.polynomial)};
    const Space space = read_space(std::string(example.box()), D == 2 ? "x,y" : "x,y,z", text);
    result.subjects.push_back({polynomials_of<D>(space, text).front(), box_of<D>(space), example.resolution()});
    result.numbers.push_back(example.number);
  }
  return result;
}

template <>
Paper_subjects<1> paper_subjects()
{
  return {};
}

template Paper_subjects<2> paper_subjects();
template Paper_subjects<3> paper_subjects();

} // namespace corral::program
