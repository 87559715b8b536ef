// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_POLYNOMIAL_NAMES_H
#define CORRAL_SRC_POLYNOMIAL_NAMES_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// What a name may mean.
namespace corral::detail {

/// \brief The ways to read `name` as a product of `variables`, two at most: the ends of the factors, the first factor
/// last. A name that is a variable is read as that one only. \par Complexity  One comparison a letter and variable.
[[nodiscard]] std::vector<std::vector<std::size_t>> readings_of(std::string_view name,
                                                                const std::vector<std::string>& variables);

/// The factors with * between them, shortened.
[[nodiscard]] std::string product_text(std::string_view name, const std::vector<std::size_t>& ends);

/// Whether `name` is a function that people write in formulas and that is no polynomial, such as sin.
[[nodiscard]] bool is_function_name(std::string_view name);

/// Why a formula with this function is no polynomial, and what to write.
[[nodiscard]] std::string why_no_polynomial(std::string_view function);

/// What may be meant by a name that is none of the variables; empty, or begins with "; ".
[[nodiscard]] std::string what_may_be_meant(std::string_view name, const std::vector<std::string>& variables);

} // namespace corral::detail

#endif
