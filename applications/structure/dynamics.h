// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_dynamics_h
#define mortar_contact_structure_dynamics_h

#include <deal.II/base/parameter_handler.h>

#include <deal.II/lac/trilinos_vector.h>

namespace Structure
{
  using namespace dealii;

  /// Settings of the time integration.
  struct DynamicsParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    bool   is_on           = false;
    bool   keeps_energy    = false; ///< The energy-momentum method.
    double spectral_radius = 0.8;   ///< At infinite frequency [-]
    double mass_damping = 0., stiffness_damping = 0.; ///< Rayleigh [1/s, s]
  };

  /**
   * The generalised-alpha method (J. Chung, G. Hulbert, J. Appl. Mech. 60
   * (1993) 371-375, doi:10.1115/1.2900803) with static forces F (internal less
   * external less contact) averaged over the step, M a_m + C v_f + (1 -
   * alpha_f) F(u) + alpha_f F_n = 0, a_m = (1 - alpha_m) a + alpha_m a_n,  v_f
   * = (1 - alpha_f) v + alpha_f v_n, u = u_n + dt v_n + dt^2 ((1/2 - beta) a_n
   * + beta a), v = v_n + dt ((1 - gamma) a_n + gamma a). Second order;
   * unconditionally stable for linear problems.
   *
   * The energy-momentum method is the same with a spectral radius of 1, where M
   * a_m = M (v - v_n)/dt and (v + v_n)/2 = (u - u_n)/dt, but with internal
   * forces of Body::evaluate_step() in place of the average: F has no internal
   * forces then.
   */
  class TimeIntegration
  {
  public:
    using Vector_t = TrilinosWrappers::MPI::Vector;

    explicit TimeIntegration(const DynamicsParameters &parameters = {});

    /// Prepare a step of length @p dt [s].
    void
    start_step(const double dt);

    /// a as a function of u is a_u u + a_0, v is v_u u + v_0.
    double a_u = 0., v_u = 0.;

    /// a and v of the displacements @p u of the end of the step.
    void
    rates(const Vector_t &u, Vector_t &a, Vector_t &v) const;

    /// Accept @p u, with F there.
    void
    commit(const Vector_t &u, const Vector_t &static_force);

    DynamicsParameters parameters;
    double             alpha_m, alpha_f, beta, gamma;
    double             dt = 0.;
    Vector_t           u_n, v_n, a_n, F_n; ///< At the start of the step.
  };
} // namespace Structure

#endif
