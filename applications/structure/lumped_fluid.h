// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_lumped_fluid_h
#define mortar_contact_structure_lumped_fluid_h

#include <deal.II/base/parameter_handler.h>

#include <deal.II/lac/full_matrix.h>

#include <string>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// Sizes of the fluid around a valve; any consistent units.
  struct FluidParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    std::string ventricle; ///< Pressure, a formula of t.
    double      density          = 0.;
    double      inlet_resistance = 0., inlet_inertance = 0.;
    double      sinus_resistance = 0., sinus_inertance = 0.;
    double      aortic_area = 0.; ///< 0: that of the tube.
    double      jet_length  = 0.; ///< 0: root of the aortic area.
    double      leak        = 0.; ///< Of the tube's area.
    double      closed_area = 0.; ///< Free edges that touch.
    double aortic_impedance = 0., peripheral_resistance = 0., compliance = 0.;
    double venous_pressure = 0., aortic_pressure = 0.; ///< At first.
  };

  /**
   * An incompressible fluid around the leaflets of a valve in a rigid tube, as
   * lumped equations. Sinuses i behind the leaflets, the lumen before them, the
   * aorta after them:
   *   p_V - p_L = R_i Q_i + L_i dQ_i/dt              inlet,
   *   p_L - p_A = L_o dQ/dt + B Q|Q|                 jet through the orifice,
   *   p_A - p_Si = R_s Q_Si + L_s dQ_Si/dt           mouth of a sinus,
   *   p_A = Z Q_A + p_C,  C dp_C/dt = Q_A - (p_C - p_ven)/R_p   Windkessel,
   * with the orifice's inertance L_o = rho l/A and losses B = rho/2 (1/A -
   * 1/A_A)^2 forward (the jet's pressure is recovered in part), rho/(2 A^2)
   * backward (Bernoulli). A leaflet sweeps Q_Si into its sinus; the lumen loses
   * it, so that Q_i = Q - sum Q_Si, and Q_A = Q_i since nothing is
   * compressible.
   *
   * Backward Euler's method in time. Given what the leaflets sweep and the
   * orifice, the jet is the only unknown, the root of a quadratic.
   */
  class LumpedFluid
  {
  public:
    /// @param n_sinuses Each stands for @p multiplicity equal ones.
    LumpedFluid(const FluidParameters &parameters,
                const double           tube_area,
                const unsigned int     n_sinuses,
                const double           multiplicity);

    /// At the end of a step.
    struct State
    {
      double              jet = 0., inlet = 0.; ///< Q, Q_i = Q_A [m^3/s]
      double              lumen = 0., aorta = 0., compliance = 0.; ///< [Pa]
      std::vector<double> swept;   ///< Q_Si [m^3/s], and
      std::vector<double> sinuses; ///< p_Si [Pa]
    };

    /// p_Si - p_L of a state, with derivatives [Pa].
    struct Loads
    {
      std::vector<double> values;
      FullMatrix<double>  by_swept; ///< [i][j] by Q_Sj.
      std::vector<double> by_area;  ///< By the orifice's area.
    };

    /**
     * The state after @p dt.
     * @param ventricle Pressure there at the end of the step.
     * @param swept     Q_Si.
     * @param area      A.
     */
    State
    step(const State               &before,
         const double               dt,
         const double               ventricle,
         const std::vector<double> &swept,
         const double               area,
         Loads                     &loads) const;

    /// At rest.
    State
    at_rest(const double ventricle) const;

    /// Area of the orifice of the polygon of free edges: what exceeds that of
    /// edges that touch, never less than the leak; and its derivative.
    double
    orifice(const double polygon, double &derivative) const;

    const FluidParameters parameters;
    const double          aortic_area, jet_length, leak;
    const unsigned int    n_sinuses;
    const double          multiplicity;
  };
} // namespace Structure

#endif
