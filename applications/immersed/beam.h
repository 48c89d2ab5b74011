// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_immersed_beam_h
#define mortar_contact_immersed_beam_h

#include <deal.II/base/tensor.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>

namespace Immersed
{
  using namespace dealii;

  /// Strip of a sheet that does not stretch out of its plane.
  struct BeamMaterial
  {
    double youngs_modulus = 1.; ///< [Pa]
    double poissons_ratio = 0.; ///< [-]
    double thickness      = 1.; ///< [m]
    double density        = 0.; ///< [kg/m^3]
  };

  /**
   * A line element with two nodes, the shell of applications/structure in the
   * plane: x(s, z) = r(s) + z d(s), both linear in s, z the distance from the
   * middle. Strains of Green and Lagrange, linear in z:
   *   E_11 = (r'.r' - 1)/2 + z (r'.d' - R'.D'),
   *   2 E_13 = r'.d - R'.D in the middle (no shear locking),
   *   E_33 = (d.d - D.D)/2 at the nodes.
   * Plane strain, St. Venant-Kirchhoff; E_33 has ten times Young's modulus, to
   * keep the thickness. Rotations may be large; there is no rotation to be
   * parametrised. All per unit of depth.
   */
  class BeamElement
  {
  public:
    static constexpr unsigned int n_nodes = 4; ///< r_1, r_2, d_1, d_2
    using Nodes                           = std::array<Tensor<1, 2>, n_nodes>;

    /// @param reference Undeformed places and directors.
    BeamElement(const BeamMaterial &material, const Nodes &reference);

    /// Energy [J/m] of the element at @p current.
    double
    energy(const Nodes &current) const;

    /**
     * Derivatives of the energy by the nodes: component 2 i + c is of
     * component c of node i. @p tangent may be null.
     * @param update Of the nodes, in the last Newton iteration: the tangent
     * then has the stresses that a linear extrapolation from before predicts,
     * which keeps Newton's method from following the stretch that a rotation
     * pretends (D. Magisano, L. Leonetti, G. Garcea, Int. J. Numer. Methods
     * Eng. 109 (2017) 1237). Zero: the exact tangent.
     */
    void
    differentiate(const Nodes        &current,
                  const Nodes        &update,
                  Vector<double>     &forces,
                  FullMatrix<double> *tangent) const;

    /// Mass between nodes @p i and @p j, the same for both components [kg/m].
    double
    mass(const unsigned int i, const unsigned int j) const;

    const double length; ///< Undeformed [m].

  private:
    /// c (a.b - reference), a = sum_i ca_i x_i, b = sum_i cb_i x_i.
    struct Form
    {
      double                      c;
      std::array<double, n_nodes> ca, cb;
      double                      reference = 0.;
    };
    static constexpr unsigned int n_forms = 5;

    std::array<double, n_forms>
    strains(const Nodes &current) const;

    BeamMaterial                                     material;
    std::array<Form, n_forms>                        forms;
    std::array<std::array<double, n_forms>, n_forms> Q;
  };
} // namespace Immersed

#endif
