// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dynamics.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>

namespace Structure
{
  void
  DynamicsParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Type",
      "static",
      Patterns::Selection("static|dynamic"),
      "static: equilibrium at all times. dynamic: with inertia; "
      "bodies need a density.");
    prm.declare_entry(
      "Method",
      "generalised-alpha",
      Patterns::Selection("generalised-alpha|energy-momentum"),
      "Of the time integration. energy-momentum: motions that nothing "
      "disturbs keep energy, momentum and angular momentum, however large the "
      "steps; for shells of the linear law, with a 'Spectral radius' of 1.");
    prm.declare_entry("Spectral radius",
                      "0.8",
                      Patterns::Double(0., 1.),
                      "Of the generalised-alpha method at infinite frequency "
                      "[-]: 1 no numerical damping, 0 the strongest.");
    prm.declare_entry("Mass damping",
                      "0.0",
                      Patterns::Double(0.),
                      "Rayleigh's alpha: damping matrix over mass matrix "
                      "[1/time].");
    prm.declare_entry(
      "Stiffness damping",
      "0.0",
      Patterns::Double(0.),
      "Rayleigh's beta: damping matrix over the stiffness matrix "
      "of the undeformed bodies [time].");
  }


  void
  DynamicsParameters::read(ParameterHandler &prm)
  {
    is_on             = prm.get("Type") == "dynamic";
    keeps_energy      = prm.get("Method") == "energy-momentum";
    spectral_radius   = prm.get_double("Spectral radius");
    mass_damping      = prm.get_double("Mass damping");
    stiffness_damping = prm.get_double("Stiffness damping");
    AssertThrow(is_on || (mass_damping == 0. && stiffness_damping == 0.),
                ExcMessage("'Mass damping' or 'Stiffness damping' is set but "
                           "'Type' is 'static'. Remove one of them."));
    AssertThrow(is_on || !keeps_energy,
                ExcMessage("'Method' is 'energy-momentum' but 'Type' is "
                           "'static'; expected 'dynamic'."));
    AssertThrow(!keeps_energy || spectral_radius == 1.,
                ExcMessage("'Method' is 'energy-momentum' but 'Spectral "
                           "radius' is " +
                           prm.get("Spectral radius") + "; expected 1."));
  }


  TimeIntegration::TimeIntegration(const DynamicsParameters &parameters)
    : parameters(parameters)
  {
    const double rho = parameters.spectral_radius;
    alpha_m          = (2. * rho - 1.) / (rho + 1.);
    alpha_f          = rho / (rho + 1.);
    gamma            = 0.5 - alpha_m + alpha_f;
    beta = 0.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f);
  }


  void
  TimeIntegration::start_step(const double step)
  {
    dt  = step;
    a_u = 1. / (beta * dt * dt);
    v_u = gamma / (beta * dt);
  }


  void
  TimeIntegration::rates(const Vector_t &u, Vector_t &a, Vector_t &v) const
  {
    a = u;
    a -= u_n;
    a *= a_u;
    a.add(-1. / (beta * dt), v_n, 1. - 0.5 / beta, a_n);
    v = v_n;
    v.add(dt * (1. - gamma), a_n, dt * gamma, a);
  }


  void
  TimeIntegration::commit(const Vector_t &u, const Vector_t &static_force)
  {
    Vector_t a = u, v = u;
    rates(u, a, v);
    u_n = u;
    v_n = v;
    a_n = a;
    F_n = static_force;
  }
} // namespace Structure
