// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECK_CHECK_H
#define CORRAL_CHECK_CHECK_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// \file
/// Reads and checks certificates as doc/certificate.md specifies them. This library knows that page and nothing of
/// Corral: it links neither the library that writes certificates nor anything that it uses but GMP and zlib.
namespace corral_check {

/// The number of cells of each verdict.
struct Counts
{
  std::uint64_t empty = 0;
  std::uint64_t hit = 0;
  std::uint64_t unknown = 0;
};

/// What a file says that it proves.
struct Claims
{
  std::size_t dimension = 0;
  std::vector<std::string> variables;   ///< one name for each axis
  std::vector<std::string> polynomials; ///< such as `-1 + 1/3*x*y^2`
  std::vector<std::string> box;         ///< for each axis lower and upper end, one after the other, exact
  std::vector<std::uint64_t> resolution;
  Counts counts;
};

/// A box of cells with one verdict: those with corner[k] <= index < corner[k] + size[k].
struct Region
{
  std::vector<std::uint64_t> corner;
  std::vector<std::uint64_t> size; ///< within the grid
  char verdict = 'u';              ///< 'e' empty, 'h' hit, 'u' unknown
};

/// Why a file is not accepted, and where.
struct Refusal : std::runtime_error
{
  Refusal(std::string where, std::string why, std::optional<std::size_t> at)
      : std::runtime_error(where + ": " + why), place(std::move(where)), reason(std::move(why)), byte(at)
  {}
  std::string place;               ///< in words
  std::string reason;              ///< the rule that is broken
  std::optional<std::size_t> byte; ///< offset in the JSON text, where there is one
};

/// The file breaks a rule of the specification.
struct Rejected : Refusal
{
  using Refusal::Refusal;
};

/// \brief The file is beyond the limits of work, memory or size that the specification states. Nothing is said of what
/// it claims.
struct Stopped : Refusal
{
  using Refusal::Refusal;
};

/// \brief A file that has been read: it has the form of section 1, and its polynomials are what section 2 asks for.
/// What it claims is not proved before `check` returns.
class Certificate
{
public:
  /// \param bytes  the whole file, JSON or gzip; given away, they are not held twice.
  /// \throw Rejected, Stopped.
  explicit Certificate(std::string bytes);
  Certificate(Certificate&&) noexcept;
  Certificate& operator=(Certificate&&) noexcept;
  ~Certificate();

  [[nodiscard]] const Claims& claims() const;

  /// \brief Checks every proof.
  /// \param visit  called for each region as soon as it is proved, or found to be called unknown; the regions cover the
  /// grid once. They are worth nothing if the call ends with an exception.
  /// \throw Rejected, Stopped.
  /// \par Complexity  at most the work and the memory of section 7, whatever the file contains.
  void check(const std::function<void(const Region&)>& visit = {}) const;

private:
  struct State;
  std::unique_ptr<const State> state_;
};

/// Reads and checks a file and returns what it proves. \throw Rejected, Stopped.
[[nodiscard]] Claims check(std::string bytes);

} // namespace corral_check

#endif
