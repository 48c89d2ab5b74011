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
    PlanePoint<dim> xi;             ///< On the secondary [-]
    PlanePoint<dim> eta;            ///< On the primary [-]
    double          weight    = 0.; ///< Undeformed area [m^2]
    double          stiffness = 0.; ///< Contact stiffness [Pa/m]
    Tensor<1, dim>  apart;          ///< Components of x_s - x_p at the start
    TieHistory      history;        ///< in the secondary's basis [m].

    /// For checkpoints and between ranks.
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
   * The ties of one pair of facets. With the components c_a = E_a . (x_s - x_p)
   * in the basis E_a that turns with the secondary, and the law's tractions T_a
   * of the jump c - c(0) (the normal one with the opposite sign: an opening is
   * positive), each tie adds
   *   f = W T_a dc_a/dx,   K = W (dc_a dT_a/dc_b dc_b + T_a d2c_a/dx2).
   * The components do not change under rigid motion: forces and moments balance
   * to round-off, also across a gap. The tangent is symmetric where dT/dc is.
   */
  template <int dim>
  class TiedPair
  {
  public:
    /// @param block What the ties add to; it and @p frame must live as long.
    TiedPair(const SecondaryFrame<dim> &frame,
             const Facet<dim>          &primary,
             const TieLaw<dim>         &law,
             const bool                 with_tangent,
             PairBlock<dim>            &block);

    /// Add one tie. The tangent is complete after finish().
    /// @return What the law says.
    TieResponse<dim>
    add(const TiePoint<dim> &tie);

    /// Add the part of the tangent in which the basis turns: it is linear in
    /// sums over the ties.
    void
    finish();

  private:
    static constexpr unsigned int T = dim - 1;

    /// v . d(x_s - x_p) by the vertices.
    PairVector<dim>
    row_of(const VertexValues<dim> &N_s,
           const VertexValues<dim> &N_p,
           const Tensor<1, dim>    &v) const;

    const SecondaryFrame<dim> &frame;
    const Facet<dim>          &primary;
    const TieLaw<dim>         &law;
    const bool                 with_tangent;
    PairBlock<dim>            &block;

    /// The basis turns by
    ///   de_0 = w e_1 - a_0 n,  de_1 = -w e_0 - a_1 n,  dn = a_0 e_0 + a_1 e_1:
    /// a, w.
    std::array<PairVector<dim>, T> tilt;
    PairVector<dim>                spin;

    /// What multiplies them in the tangent, summed over the ties.
    std::array<PairVector<dim>, T> with_tilt = {};
    PairVector<dim>                with_spin = {};
    Tensor<1, dim>                 on_normal, on_tangent;
  };
} // namespace MortarContact

#endif
