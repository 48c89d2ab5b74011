// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_pair_block_h
#define mortar_contact_mortar_pair_block_h

#include <mortar_contact/mortar/secondary_frame.h>

#include <algorithm>
#include <limits>

namespace MortarContact
{
  /// What one pair contributes. Vectors: see PairVector.
  template <int dim>
  struct PairBlock
  {
    /// Minus the contact forces: gradient of the contact energy, and friction
    /// [N].
    PairVector<dim> residual = {};
    /// Derivative of the residual, symmetrised on request [N/m]. Rows.
    std::array<PairVector<dim>, max_pair_components<dim>> tangent = {};

    double energy             = 0.; ///< Stored in the contact springs [J].
    double area               = 0.; ///< Overlap, reference area [m^2].
    double active_area        = 0.; ///< Of it where d > 0.
    double slip_area          = 0.; ///< Of that where friction slips.
    double dissipation        = 0.; ///< By friction, this step [J].
    double pressure           = 0.; ///< Largest, per undeformed area [Pa].
    double elastic_slip       = 0.; ///< Largest [m].
    double penetration_volume = 0.; ///< Integral of d over the active area.
    /// Largest d and d/l with its position, smallest gap; lengths [m].
    double penetration          = 0.;
    double relative_penetration = 0.; ///< d / l
    /// Where that is [m].
    Tensor<1, dim> deepest_position;
    /// Largest overlap of the two meshes: d plus what the treatment of initial
    /// penetrations takes off [m].
    double overlap = 0.;
    /// Of points in front of the primary [m].
    double smallest_gap = std::numeric_limits<double>::max();
    /// Of all points; below 0 where all penetrate [m].
    double largest_gap = std::numeric_limits<double>::lowest();
    /// Contact points of the pair,
    unsigned int n_points = 0;
    /// and those of them that penetrate.
    unsigned int n_active      = 0;
    unsigned int n_beyond      = 0;     ///< Points deeper than the ceiling.
    bool         is_degenerate = false; ///< A facet without a usable shape.

    /// Whether there is a force.
    bool
    is_active() const
    {
      return n_active > 0;
    }
  };

  /// Small loops over pair vectors.
  namespace PairAlgebra
  {
    /// sum += factor v
    template <std::size_t n>
    inline void
    add(const double                 factor,
        const std::array<double, n> &v,
        std::array<double, n>       &sum)
    {
      for (std::size_t i = 0; i < n; ++i)
        sum[i] += factor * v[i];
    }

    /// sum += factor_v v + factor_w w
    template <std::size_t n>
    inline void
    add(const double                 factor_v,
        const std::array<double, n> &v,
        const double                 factor_w,
        const std::array<double, n> &w,
        std::array<double, n>       &sum)
    {
      for (std::size_t i = 0; i < n; ++i)
        sum[i] += factor_v * v[i] + factor_w * w[i];
    }

    /// factor v
    template <std::size_t n>
    inline std::array<double, n>
    scaled(const double factor, const std::array<double, n> &v)
    {
      std::array<double, n> result;
      for (std::size_t i = 0; i < n; ++i)
        result[i] = factor * v[i];
      return result;
    }

    /// sum += factor v, for v that is zero on the primary.
    template <std::size_t n>
    inline void
    add_secondary(const double                 factor,
                  const std::array<double, n> &v,
                  std::array<double, n>       &sum)
    {
      for (std::size_t i = 0; i < n / 2; ++i)
        sum[i] += factor * v[i];
    }

    /// sum += left right^T
    template <std::size_t n>
    inline void
    add_outer(const std::array<double, n>          &left,
              const std::array<double, n>          &right,
              std::array<std::array<double, n>, n> &sum)
    {
      for (std::size_t i = 0; i < n; ++i)
        if (left[i] != 0.)
          add(left[i], right, sum[i]);
    }

    /// Replace a matrix by its symmetric part.
    template <std::size_t n>
    inline void
    symmetrise(std::array<std::array<double, n>, n> &matrix)
    {
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j)
          matrix[i][j] = matrix[j][i] = 0.5 * (matrix[i][j] + matrix[j][i]);
    }

    /// Value at a point of shape values and vertex values.
    template <int dim>
    inline double
    dot(const VertexValues<dim> &a, const VertexValues<dim> &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < max_vertices<dim>; ++i)
        sum += a[i] * b[i];
      return sum;
    }
  } // namespace PairAlgebra
} // namespace MortarContact

#endif
