// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_hex_kernel_h
#define mortar_contact_structure_hex_kernel_h

namespace Structure
{
  /// One number of each of eight cells: what the compiler computes at once.
  using Lanes = double __attribute__((vector_size(64)));

  /**
   * Internal forces and tangent of eight trilinear hexahedra at once, in 2x2x2
   * Gauss points; the same as Element, in spatial form: with the gradients g_a
   * by present positions and Kirchhoff's stress tau,
   *   f_a = sum_q w tau g_a,   K_ab = sum_q w (g_a . tau . g_b 1 + g_a c g_b).
   */
  struct HexKernel
  {
    static constexpr unsigned int width   = 8; ///< Cells at once.
    static constexpr unsigned int n_nodes = 8;
    /// Pairs of nodes a <= b, in the order (0,0), (0,1), ... (1,1), ...
    static constexpr unsigned int n_pairs = 36;

    double mu = 0., bulk = 0.; ///< Moduli at F = 1: shear, K [Pa].

    /**
     * The law, b = F F^T: mu/2 (J^(-2/3) tr b - 3) and a pressure p [Pa,
     * positive in tension] that is the same in the whole cell, of volumes V
     * before and v now, in equilibrium p = K (v/V - 1); else the neo-Hookean
     * mu/2 (tr b - 3 - 2 ln J) + lambda/2 (ln J)^2, lambda = K - 2 mu/3.
     */
    bool has_pressure = false;

    /// What is known of the cells; nodes in deal.II's order.
    struct Cells
    {
      Lanes X[n_nodes][3]; ///< Undeformed positions [m].
      Lanes u[n_nodes][3]; ///< Displacements [m].
      Lanes pressure;      ///< Read if `stored` below.
    };

    struct Result
    {
      Lanes forces[n_nodes][3];
      /// Block [i][j] of node pair a <= b: d f_ai / d u_bj at fixed pressure.
      Lanes tangent[n_pairs][3][3];
      Lanes volume, new_volume; ///< V and v [m^3].
      Lanes dv[n_nodes][3];     ///< Derivative of v [m^2].
      Lanes pressure;           ///< What was used [Pa].
      Lanes smallest_J;         ///< Nothing is valid if not positive.
      Lanes energy;             ///< At the pressure of equilibrium [J].
    };

    /**
     * @param stored The pressure is an unknown of its own, given by the cells;
     *               else it follows from the displacements.
     */
    void
    evaluate(const Cells &cells,
             const bool   stored,
             const bool   with_tangent,
             Result      &result) const;
  };
} // namespace Structure

#endif
