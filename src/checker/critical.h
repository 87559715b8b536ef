// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_CRITICAL_H
#define CORRAL_CHECKER_CRITICAL_H

#include "bernstein.h"
#include "certificate.h"

#include <string_view>

namespace corral_check {

/// A box in x coordinates on which a polynomial is to have no zero, on a branch of the tree.
struct Face
{
  Bernstein_form form; ///< of the polynomial; its free axes are those of the face
  Box box;
  std::size_t polynomial = 0; ///< an index of `Contents::proved`
  std::size_t depth = 0;      ///< nodes from the root of the tree to this one
  double held = 0;            ///< words that section 7 counts for them
};

/// Section 6: the proofs of the leaves `c`, one after the other.
class Critical_proofs
{
public:
  Critical_proofs(const Contents& contents, Budget& budget);

  /// Takes the next entry of `critical` and checks that it proves that none of the boxes holds a zero.
  /// \param faces  one box with each of the g_j; the entry says which one is meant.
  void prove(const std::vector<Face>& faces, const Place& leaf);

  /// Whether no entry is left.
  [[nodiscard]] bool all_used();

private:
  void prove(const Face& face, const Value& entry, const std::string& where);
  void prove_tree(Face root, const std::string& tree, std::size_t& position, const Place& place);
  [[nodiscard]] Value next(const Place& leaf);
  [[nodiscard]] const Multipliers& multipliers(const Value& entry, const std::string& where) const;
  [[nodiscard]] Face face_of(std::size_t polynomial, const Face& face);

  const Contents& contents_;
  Budget& budget_;
  std::optional<Items> entries_;
  std::size_t used_ = 0;
};

constexpr std::size_t max_nodes_of_branch = 1100;

/// Section 7: what a node adds to the words of its branch.
[[nodiscard]] inline double held_by(const Bernstein_form& form)
{
  return static_cast<double>(form.sizes.size() + 1) * form.held();
}

/// Keeps to the limits of a branch (section 7).
void require_branch(std::size_t depth, double held, const Place& place);

} // namespace corral_check

#endif
