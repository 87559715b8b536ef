// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_CERTIFICATE_CRITICAL_PROVER_H
#define CORRAL_SRC_CERTIFICATE_CRITICAL_PROVER_H

#include "Counted_form.h"

#include <corral/certificate/certificate.h>
#include <corral/internal/algebra/Checkpoint.h>

#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace corral::certificate {

/// A piece of a certificate: trees with the entries of `critical` that their leaves `c` take.
struct Proof_part
{
  std::string tree;
  std::vector<Critical_proof> entries;
  double work = 0; ///< that a checker counts

  void append(Proof_part other)
  {
    tree += other.tree;
    entries.insert(entries.end(), std::make_move_iterator(other.entries.begin()),
                   std::make_move_iterator(other.entries.end()));
    work += other.work;
  }
};

/// What a proof adds to a file.
struct Proof_size
{
  double work = 0; ///< that a checker counts
  double bytes = 0;
  double values = 0;
};

/// A box, of which some sides may be flat, on which a polynomial is to have no zero.
template <std::size_t D>
struct Face
{
  Counted_form<D> form;
  Rational_box<D> box;
  std::size_t polynomial = 0; ///< by the prover's own numbers; those of the input come first
  double held = 0;            ///< words of the branch
  std::size_t depth = 0;
};

/// A factor of what multipliers make of a polynomial and its derivative.
template <std::size_t D>
struct Critical_factor
{
  std::size_t number = 0; ///< the prover's own
  unsigned exponent = 1;
  std::shared_ptr<const Polynomial<Integer, D>> polynomial;
};

/// Multipliers of a polynomial and one of its derivatives.
template <std::size_t D>
struct Critical_entry
{
  std::size_t of = 0;   ///< number of the polynomial
  std::size_t axis = 0; ///< of the derivative
  Polynomial<Integer, D> a;
  Polynomial<Integer, D> b;
  std::vector<Critical_factor<D>> factors{};
  Proof_size size{};
};

/// By the numbers that proofs refer to.
template <std::size_t D>
using Critical_entries = std::vector<std::shared_ptr<const Critical_entry<D>>>;

/// \brief Proves that boxes hold no zero by critical multipliers (doc/certificate.md, section 6).
///
/// The multipliers are the cofactors of a polynomial and one of its derivatives, made when first needed and shared by
/// all boxes and by copies of the prover, which cost little. A box is cut where they do not do.
template <std::size_t D>
class Critical_prover
{
public:
  /// \param given  the square-free polynomials that the certificate is about.
  Critical_prover(std::vector<Polynomial<Integer, D>> given, Checkpoint checkpoint);

  /// The proof that the box holds no zero of the polynomial, if one is found with at most so many boxes.
  [[nodiscard]] std::optional<Proof_part> prove(Face<D> face, std::size_t boxes);

  /// All multipliers made so far.
  [[nodiscard]] const Critical_entries<D>& entries() const { return entries_; }

private:
  struct Search
  {
    std::size_t boxes;
    double effort; ///< work that may still be tried
  };

  [[nodiscard]] std::optional<Proof_part> prove_tree(Face<D> face, Search& search, bool is_main);
  [[nodiscard]] std::optional<Proof_part> prove_split(Face<D> face, Search& search, std::size_t axes, bool is_main);
  [[nodiscard]] std::optional<Proof_part> prove_critical(const Face<D>& face, std::size_t axis, Search& search);
  [[nodiscard]] std::optional<Proof_part> prove_factors(const Face<D>& face, const Critical_entry<D>& entry,
                                                        Search& search);
  [[nodiscard]] std::optional<Proof_part> prove_facet(const Face<D>& face, std::size_t axis, bool upper,
                                                      Search& search);
  [[nodiscard]] std::optional<std::size_t> entry_for(std::size_t polynomial, std::size_t axis);
  [[nodiscard]] std::optional<std::size_t> make_entry(std::size_t polynomial, std::size_t axis);

  std::vector<std::shared_ptr<const Polynomial<Integer, D>>> polynomials_;
  Checkpoint checkpoint_;
  Critical_entries<D> entries_;
  std::map<std::pair<std::size_t, std::size_t>, std::optional<std::size_t>> known_;
};

/// \brief The parts of one certificate that critical multipliers prove, with the multipliers that they use. It needs no
/// prover to be written down.
template <std::size_t D>
class Critical_record
{
public:
  /// \param given  number of polynomials that the certificate is about.
  explicit Critical_record(std::size_t given) : given_(given) {}

  /// What the part adds to the certificate, with the multipliers that no part added before uses.
  [[nodiscard]] Proof_size size_of(const Proof_part& part, const Critical_entries<D>& entries) const;

  /// Adds a part to the certificate, but for its tree. \param entries  those that the part refers to.
  void add(Proof_part part, const Critical_entries<D>& entries);

  /// Writes the parts that were added.
  void write_to(Certificate<D>& certificate) &&;

private:
  std::size_t given_;
  std::map<std::size_t, std::shared_ptr<const Critical_entry<D>>> used_; ///< by their numbers
  std::vector<Critical_proof> critical_;
};

} // namespace corral::certificate

#endif
