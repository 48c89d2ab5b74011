// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_laws_tie_law_h
#define mortar_contact_laws_tie_law_h

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace MortarContact
{
  using namespace dealii;

  /// History of one tie point.
  struct TieHistory
  {
    double damage = 0.; ///< 0 whole, 1 failed.
    /// Energy that each further damage sets free, at the last accepted state:
    /// minus d(stored energy)/d(damage) [J/m^2].
    double release = 0.;

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &damage &release;
    }
  };

  /// Response of a tie. Components: tangential ones first, normal last.
  template <int dim>
  struct TieResponse
  {
    double         energy = 0.; ///< Stored [J/m^2]
    Tensor<1, dim> traction;    ///< [Pa]
    Tensor<2, dim> tangent;     ///< dt/dj [Pa/m]
    TieHistory     history;     ///< If this state is accepted.
  };

  /// Strengths and energies of a tie that can fail.
  struct TieStrength
  {
    /// How a tie fails.
    enum class Law
    {
      never,    ///< Tied for good.
      strength, ///< OPTION 2: fails at once where the criterion is met.
      dycoss,   ///< OPTION 7: shear strength grows under pressure.
      cohesive  ///< OPTION 9: bilinear, mixed mode.
    };
    /// How the tie fails.
    Law    law           = Law::never;
    double normal        = 0.; ///< NFLS [Pa]
    double shear         = 0.; ///< SFLS [Pa]
    double energy_normal = 0.; ///< ERATEN, mode I [J/m^2]
    double energy_shear  = 0.; ///< ERATES, mode II [J/m^2]
    /// Mixed mode (PARAM): exponent of the power law, or of Benzeggagh and
    /// Kenane's law.
    bool benzeggagh_kenane = false;
    /// Of the mixed mode law [-].
    double exponent         = 1.;
    double friction_angle   = 0.; ///< PARAM of OPTION 7 [rad]
    double normal_stiffness = 0.; ///< CN [Pa/m]; 0: contact stiffness.
    double shear_ratio      = 1.; ///< CT2CN [-]
  };

  /**
   * Traction of a tie over its jump: the relative displacement of two points
   * that were tied, in the secondary's basis.
   *
   * Whole ties and closed ones resist linearly, t = k j, in both directions.
   * The bilinear law (LS-DYNA's *MAT_138; Camanho & Davila 2002, NASA/TM-2002-
   * 211737) is, with the opening j_m = |(j_T, max(j_n, 0))| and the mix
   * B = |j_T|^2/j_m^2,
   *   t = (1 - D) k j,  D = j_F (j_m - j_0) / (j_m (j_F - j_0)),
   *   j_0 = j_I0 j_II0 / sqrt((1-B) j_II0^2 + B j_I0^2),
   *   j_I0 = NFLS/k_n, j_II0 = SFLS/k_t,
   *   power law: j_F = 2/j_0 [((1-B) k_n/G_I)^a + (B k_t/G_II)^a]^(-1/a),
   *   B-K:       j_F = 2/(j_0 k_B) [G_I + (G_II - G_I) (B k_t/k_B)^a],
   *              k_B = (1-B) k_n + B k_t.
   * D never falls; under pressure the normal part is whole.
   */
  template <int dim>
  class TieLaw
  {
  public:
    /// The law with these strengths.
    explicit TieLaw(const TieStrength &strength);

    /**
     * @param jump      j [m].
     * @param stiffness Contact stiffness where CN is zero [Pa/m].
     * @param history   Of the last accepted state.
     */
    TieResponse<dim>
    evaluate(const Tensor<1, dim> &jump,
             const double          stiffness,
             const TieHistory     &history) const;

    /// Elastic energy at the strength over the fracture energy, the larger of
    /// the two modes: from 1 on nothing is left to soften. Zero for laws that
    /// do not soften. @param stiffness Contact stiffness where CN is zero
    /// [Pa/m].
    double
    brittleness(const double stiffness) const;

    /// As given.
    const TieStrength strength;

  private:
    /// D of the bilinear law and its derivatives by the mode I and II parts.
    struct Damage
    {
      double value = 0., by_normal = 0., by_shear = 0.;
    };
    Damage
    damage(const double opening,
           const double sliding,
           const double k_n,
           const double k_t,
           const double shear_strength) const;
  };
} // namespace MortarContact

#endif
