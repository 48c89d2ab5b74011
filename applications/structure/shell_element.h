// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_shell_element_h
#define mortar_contact_structure_shell_element_h

#include "shell_law.h"

#include <deal.II/base/tensor.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /**
   * Shell with extensible directors: quadrilateral (4 nodes) or triangle (3
   * nodes). A point of the shell is x = r + z d, z in [-t/2, t/2], with the
   * middle surface r = R + v and the director d = D + q/s interpolated from the
   * nodes; v and q are the unknowns, s a length that makes both alike. There
   * are no rotations: unknowns live in a vector space, and the outer surfaces
   * r +- (t/2) d are linear in them.
   *
   * Green-Lagrange strains E = a + z b (the quadratic part in z is left out).
   * All strains are taken at tying points, as *forms* c (x . y - X . Y) of
   * vectors x, y that are linear in the nodal (r, d):
   *   membrane  MITC4+ (Ko, Lee & Bathe 2017,
   * doi:10.1016/j.compstruc.2016.11.004), without membrane locking on warped
   * quadrilaterals shear     at the middles of the edges (Dvorkin & Bathe
   * 1984), MITC3 (Lee & Bathe 2004) on triangles thickness at the nodes (Betsch
   * & Stein 1995) bending   at the integration points, and on quadrilaterals
   * four enhanced membrane modes (Simo & Rifai 1990), condensed once. The law
   * is linear, hence the energy is 1/2 f^T Q f with a constant matrix Q and f
   * the forms' values: exactly objective. Other laws are integrated across the
   * thickness; then the enhanced modes are found anew in each evaluation.
   *
   * The thickness strain is not coupled with those in the plane (its stiffness
   * is 10 E, so that directors keep their length); the plane is in plane
   * stress.
   *
   * Order of the dofs: by node v_x v_y v_z q_x q_y q_z, as FESystem has them.
   */
  class ShellElement
  {
  public:
    using Vec = Tensor<1, 3>;

    /**
     * @param R Nodes: deal.II's order, (r, s) = (-,-), (+,-), (-,+), (+,+).
     * @param D Directors at the nodes, out of the shell's top; of length 1
     *          where the shell is smooth.
     * @param director_scale s [m].
     * @throw ExcMessage if the element has no area.
     */
    ShellElement(const std::vector<Vec> &R,
                 const std::vector<Vec> &D,
                 const ShellSection     &section,
                 const double            director_scale);

    /**
     * Internal forces and tangent.
     * @param u        Values of the dofs.
     * @return Nothing is valid if this is false: a layered element finds no
     *         equilibrium of its enhanced modes.
     * @param previous Null, or the values at the iterate before: then the
     *                 stresses of the geometric stiffness are those
     * extrapolated from there (mixed integration point, Magisano, Leonetti &
     *                 Garcea 2017): far fewer iterations in large steps.
     */
    bool
    evaluate(const Vector<double> &u,
             const bool            with_tangent,
             const Vector<double> *previous,
             Vector<double>       &forces,
             FullMatrix<double>   &tangent) const;

    /**
     * Internal forces over a step from @p u_n to @p u, B((u_n + u)/2)^T Q (f_n
     * + f)/2, and their derivative by u. Since f is quadratic in u, they do
     * exactly the work by which the strain energy changes, and have no
     * resultant and no moment: with the midpoint rule for the inertia a motion
     * keeps energy, momentum and angular momentum (J. Simo, N. Tarnow, Int. J.
     * Numer. Methods Eng. 37 (1994) 2527-2549, doi:10.1002/nme.1620371503). For
     * the linear law only. @p previous as for evaluate(); the tangent is not
     * symmetric.
     */
    void
    evaluate_step(const Vector<double> &u_n,
                  const Vector<double> &u,
                  const bool            with_tangent,
                  const Vector<double> *previous,
                  Vector<double>       &forces,
                  FullMatrix<double>   &tangent) const;

    /// Strain energy [J].
    double
    energy(const Vector<double> &u) const;

    /// Accept what the last evaluate() found as the end of a step.
    void
    commit();

    /// By integration point, then across the thickness; empty: nothing to
    /// remember.
    std::vector<PlasticState> states;

    /// Enhanced modes at the end of the last step, of layered elements.
    std::vector<double> modes;

    /// Largest equivalent plastic strain.
    double
    plastic_strain() const;

    /// Consistent mass matrix: rho t for v, rho t^3/12/s^2 for q; constant.
    void
    mass(FullMatrix<double> &M) const;

    /**
     * Second Piola-Kirchhoff stresses [Pa] in the plane, in the Cartesian axes
     * of the middle (e_1 along the first edge), at z = height * t/2:
     * 11, 22, 12.
     */
    PlaneVector
    stress(const Vector<double> &u, const double height) const;

    unsigned int
    n_dofs() const
    {
      return 6 * R.size();
    }

  private:
    /// Motion of (r_1.., d_1..).
    std::vector<Vec>
    motion(const Vector<double> &u) const;

    /// The forms' values for a motion.
    std::vector<double>
    values(const std::vector<Vec> &motion) const;

    /// Number of the dof of component @p c of number @p k of (r_1.., d_1..).
    unsigned int
    dof(const unsigned int k, const unsigned int c) const
    {
      const unsigned int n = R.size();
      return (k < n) ? 6 * k + c : 6 * (k - n) + 3 + c;
    }

    /// B(form, dof), derivatives of the forms at the places @p z.
    FullMatrix<double>
    derivatives(const std::vector<Vec> &z) const;

    /// Make the stresses of the geometric stiffness those extrapolated from the
    /// iterate before: take off @p factor times the part that is quadratic in
    /// the step. @p C is dS/df.
    void
    extrapolate(const Vector<double>     &u,
                const Vector<double>     &previous,
                const FullMatrix<double> &C,
                const double              factor,
                std::vector<double>      &S) const;

    /// Add the part of the tangent that stresses of the forms make.
    void
    add_geometric(const std::vector<double> &S,
                  FullMatrix<double>        &tangent) const;

    const std::vector<Vec> R, D;
    const ShellSection     section;
    const double           scale;
    std::vector<Vec>       at_rest; ///< (R_1.., D_1..)
    FullMatrix<double>     Q;
    /// Cartesian strains in the middle by forms: membrane and bending, 3 rows.
    FullMatrix<double> membrane_at_middle, bending_at_middle;
    FullMatrix<double> shape_products; ///< int N_i N_j dA

    /// For laws that are not linear: Q then holds shear and thickness only.
    struct LayeredPoint
    {
      double             weight; ///< Area.
      FullMatrix<double> A, M;   ///< Strains in the plane by forms, by modes,
      FullMatrix<double> B;      ///< and bending by its own three forms.
    };
    std::vector<LayeredPoint> layered;
    FullMatrix<double>        of_modes, mixed; ///< Shear and thickness.

    /// Stresses of the forms, and their derivative, of layered shells.
    /// @return Whether the enhanced modes were found.
    bool
    respond(const std::vector<double> &f,
            const bool                 with_tangent,
            std::vector<double>       &S,
            FullMatrix<double>        &D,
            std::vector<PlasticState> &now,
            std::vector<double>       &alpha,
            double                    &energy) const;

    /// Across the thickness: heights over t/2, weights that sum to 1.
    std::vector<std::array<double, 2>> layers;
    // what the last evaluate() found
    mutable std::vector<PlasticState> trial;
    mutable std::vector<double>       trial_modes;
  };
} // namespace Structure

#endif
