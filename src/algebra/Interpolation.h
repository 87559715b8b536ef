// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_INTERPOLATION_H
#define CORRAL_SRC_ALGEBRA_INTERPOLATION_H

#include <flint/nmod_poly.h>

#include <cstdint>
#include <vector>

namespace corral::exact {

/// The polynomials with given values at some points modulo one prime: FLINT's subproduct tree, made once for all.
class Interpolation
{
public:
  using Residues = std::vector<std::uint64_t>;

  Interpolation(std::uint64_t prime, const Residues& points)
      : length_(static_cast<slong>(points.size())), tree_(_nmod_poly_tree_alloc(length_)), weights_(points.size())
  {
    nmod_init(&modulus_, prime);
    _nmod_poly_tree_build(tree_, points.data(), length_, modulus_);
    _nmod_poly_interpolation_weights(weights_.data(), tree_, length_, modulus_);
  }
  Interpolation(const Interpolation&) = delete;
  Interpolation& operator=(const Interpolation&) = delete;
  ~Interpolation() { _nmod_poly_tree_free(tree_, length_); }

  /// The coefficients. \pre One value for each point.
  [[nodiscard]] Residues operator()(const Residues& values) const
  {
    Residues result(values.size());
    _nmod_poly_interpolate_nmod_vec_fast_precomp(result.data(), values.data(), tree_, weights_.data(), length_,
                                                 modulus_);
    return result;
  }

private:
  slong length_;
  nmod_t modulus_{};
  mp_ptr* tree_;
  Residues weights_;
};

} // namespace corral::exact

#endif
