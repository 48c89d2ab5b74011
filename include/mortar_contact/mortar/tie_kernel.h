// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_tie_kernel_h
#define mortar_contact_mortar_tie_kernel_h

#include <mortar_contact/laws/tie_law.h>
#include <mortar_contact/mortar/pair_block.h>

namespace MortarContact
{
  /// Two material points that are tied for good, found once at the start.
  template <int dim>
  struct TiePoint
  {
    PlanePoint<dim> xi, eta;        ///< On the secondary, on the primary.
    double          weight    = 0.; ///< Undeformed area [m^2]
    double          stiffness = 0.; ///< Contact stiffness [Pa/m]
    Tensor<1, dim>  apart;          ///< Components of x_s - x_p at the start
    TieHistory      history;        ///< in the secondary's basis [m].

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &xi &eta &weight &stiffness &apart &history;
    }
  };

  /// Components of x_s - x_p in the secondary's basis, normal last.
  template <int dim>
  Tensor<1, dim>
  apart(const SecondaryFrame<dim> &frame,
        const Facet<dim>          &primary,
        const PlanePoint<dim>     &xi,
        const PlanePoint<dim>     &eta);

  /**
   * Add one tie. With the components c_a = E_a . (x_s - x_p) in the basis E_a
   * that turns with the secondary, and the law's tractions T_a of the jump
   * c - c(0) (the normal one with the opposite sign: an opening is positive),
   *   f = W T_a dc_a/dx,   K = W (dc_a dT_a/dc_b dc_b + T_a d2c_a/dx2).
   * The components do not change under rigid motion: forces and moments balance
   * to round-off, also across a gap. The tangent is symmetric where dT/dc is.
   *
   * @return What the law says.
   */
  template <int dim>
  TieResponse<dim>
  add_tie(const SecondaryFrame<dim> &frame,
          const Facet<dim>          &primary,
          const TiePoint<dim>       &tie,
          const TieLaw<dim>         &law,
          const bool                 with_tangent,
          PairBlock<dim>            &block);
} // namespace MortarContact

#endif
