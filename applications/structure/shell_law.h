// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_shell_law_h
#define mortar_contact_structure_shell_law_h

#include <array>

namespace Structure
{
  /// Hardening curve of steel: flow stress over equivalent plastic strain a,
  ///   sigma_y(a) = Y + H a + (S - Y) (1 - exp(-delta a)).
  struct Hardening
  {
    double yield_stress = 0.; ///< Y [Pa]; 0: no yielding.
    double modulus      = 0.; ///< H [Pa]
    double saturation   = 0.; ///< S [Pa]; 0: no such part.
    double exponent     = 0.; ///< delta [-]

    double
    stress(const double plastic_strain) const;

    double
    slope(const double plastic_strain) const;
  };

  /// Thickness and material of a shell in plane stress: St. Venant-Kirchhoff,
  /// neo-Hookean, or elastic-plastic steel.
  struct ShellSection
  {
    double    youngs_modulus = 0.; ///< [Pa]
    double    poissons_ratio = 0.; ///< [-]
    double    thickness      = 0.; ///< [m]
    double    density        = 0.; ///< [kg/m^3]
    bool      is_neo_hookean = false;
    Hardening hardening      = {};
    /// Points across the thickness, for what is not linear (Gauss-Legendre).
    unsigned int n_layers = 5;

    /// Whether stresses are integrated across the thickness.
    bool
    has_layers() const
    {
      return is_neo_hookean || hardening.yield_stress > 0.;
    }
  };

  /// Strains or stresses 11, 22, 12 in the plane of a shell, engineering shear.
  using PlaneVector = std::array<double, 3>;
  using PlaneMatrix = std::array<PlaneVector, 3>;

  /// What a point across the thickness remembers.
  struct PlasticState
  {
    PlaneVector strain     = {{0., 0., 0.}}; ///< Plastic part, 11, 22, 12.
    double      equivalent = 0.;             ///< Equivalent plastic strain.
  };

  /// Second Piola-Kirchhoff stress over Green-Lagrange strain at a point.
  struct PlaneResponse
  {
    PlaneVector  stress;
    PlaneMatrix  tangent;
    double       energy = 0.; ///< Elastic [J/m^3].
    PlasticState state;
    bool         is_valid = true; ///< False: pressed to nothing.
  };

  /**
   * Plane-stress law of a shell: strain in, stress out.
   *   elasto-plastic: J2 flow with isotropic hardening for small strains in the
   *     shell's own axes (they turn with it), implicit return mapping with
   *     consistent tangent after J.C. Simo and T.J.R. Hughes, Computational
   *     Inelasticity (1998), section 3.4;
   *   neo-Hookean: W = mu/2 (tr C - 3 - 2 ln J) + lambda/2 (ln J)^2 with C_33
   *     such that the stress across vanishes.
   * @param before The state at the end of the last step.
   */
  PlaneResponse
  evaluate_plane_stress(const ShellSection &section,
                        const PlaneVector  &strain,
                        const PlasticState &before);

  /// Von Mises' stress in the plane.
  double
  von_mises(const PlaneVector &stress);
} // namespace Structure

#endif
