// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/tie_law.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace MortarContact
{
  namespace
  {
    /// Mixes closer to a pure mode than this are that mode: exponents below one
    /// have no derivative there.
    constexpr double pure_mode = 1e-12;

    /// Shear strength that pressure may reach, over that at which the elastic
    /// energy is the fracture energy.
    constexpr double least_softening = 0.99;
  } // namespace


  template <int dim>
  TieLaw<dim>::TieLaw(const TieStrength &strength)
    : strength(strength)
  {}


  template <int dim>
  double
  TieLaw<dim>::brittleness(const double stiffness) const
  {
    if (strength.law != TieStrength::Law::dycoss &&
        strength.law != TieStrength::Law::cohesive)
      return 0.;
    const double k_n =
      (strength.normal_stiffness > 0.) ? strength.normal_stiffness : stiffness;
    const double k_t = strength.shear_ratio * k_n;
    return std::max(strength.normal * strength.normal /
                      (2. * k_n * strength.energy_normal),
                    strength.shear * strength.shear /
                      (2. * k_t * strength.energy_shear));
  }


  template <int dim>
  typename TieLaw<dim>::Damage
  TieLaw<dim>::damage(const double opening,
                      const double sliding,
                      const double k_n,
                      const double k_t,
                      const double shear_strength) const
  {
    Damage       result;
    const double j2 = opening * opening + sliding * sliding;
    const double j  = std::sqrt(j2);
    if (j == 0.)
      return result;
    const double B =
      std::min(std::max(sliding * sliding / j2, pure_mode), 1. - pure_mode);
    const double jI = strength.normal / k_n, jII = shear_strength / k_t;

    // Step 1: where damage starts.
    const double j0 = jI * jII / std::sqrt((1. - B) * jII * jII + B * jI * jI);
    if (j <= j0)
      return result;
    const double dj0 =
      0.5 * j0 * j0 * j0 * (jII * jII - jI * jI) / (jI * jI * jII * jII);

    // Step 2: where it is complete.
    const double a  = strength.exponent;
    const double GI = strength.energy_normal, GII = strength.energy_shear;
    double       jF, djF;
    if (strength.benzeggagh_kenane)
      {
        const double k = (1. - B) * k_n + B * k_t;
        const double r = B * k_t / k, dr = k_t * k_n / (k * k);
        const double G  = GI + (GII - GI) * std::pow(r, a);
        const double dG = (GII - GI) * a * std::pow(r, a - 1.) * dr;
        jF              = 2. * G / (j0 * k);
        djF             = jF * (dG / G - dj0 / j0 - (k_t - k_n) / k);
      }
    else
      {
        const double u = (1. - B) * k_n / GI, v = B * k_t / GII;
        const double S  = std::pow(u, a) + std::pow(v, a);
        const double dS = a * (std::pow(v, a - 1.) * k_t / GII -
                               std::pow(u, a - 1.) * k_n / GI);
        jF              = 2. / j0 * std::pow(S, -1. / a);
        djF             = -jF * (dj0 / j0 + dS / (a * S));
      }

    // Step 3: damage. Brittle where the energy is spent before the strength.
    if (j >= jF || jF <= j0)
      {
        result.value = 1.;
        return result;
      }
    const double span = jF - j0;
    result.value      = jF * (j - j0) / (j * span);
    const double by_j = jF * j0 / (j2 * span);
    const double by_B = jF * (j - jF) / (j * span * span) * dj0 -
                        j0 * (j - j0) / (j * span * span) * djF;
    result.by_normal = by_j * opening / j - by_B * 2. * B * opening / j2;
    result.by_shear  = by_j * sliding / j + by_B * 2. * (1. - B) * sliding / j2;
    return result;
  }


  template <int dim>
  TieResponse<dim>
  TieLaw<dim>::evaluate(const Tensor<1, dim> &jump,
                        const double          stiffness,
                        const TieHistory     &history) const
  {
    constexpr unsigned int n = dim - 1;
    const double           k_n =
      (strength.normal_stiffness > 0.) ? strength.normal_stiffness : stiffness;
    const double k_t = (strength.law == TieStrength::Law::never) ?
                         k_n :
                         strength.shear_ratio * k_n;

    const double opening = std::max(jump[n], 0.);
    double       sliding = 0.;
    for (unsigned int c = 0; c < n; ++c)
      sliding += jump[c] * jump[c];
    sliding = std::sqrt(sliding);
    const double release =
      0.5 * (k_n * opening * opening + k_t * sliding * sliding);

    TieResponse<dim> r;
    r.history          = history;
    Damage       trial = {};
    const double t_n = k_n * jump[n], t_t = k_t * sliding; // whole
    if (strength.law == TieStrength::Law::strength)
      {
        // judged on accepted states: fails for the steps to come
        const double normal = std::max(t_n, 0.) / strength.normal;
        const double shear  = t_t / strength.shear;
        if (normal * normal + shear * shear >= 1.)
          r.history.damage = 1.;
      }
    else if (strength.law != TieStrength::Law::never)
      {
        double shear_strength = strength.shear;
        if (strength.law == TieStrength::Law::dycoss)
          shear_strength -=
            std::sin(strength.friction_angle) * std::min(0., t_n);
        // never so strong that the energy is spent before it softens
        shear_strength =
          std::min(shear_strength,
                   least_softening *
                     std::sqrt(2. * k_t * strength.energy_shear));
        trial = damage(opening, sliding, k_n, k_t, shear_strength);
        // the growth of the shear strength is left out of the derivative
        r.history.damage = std::max(history.damage, trial.value);
      }
    // what has failed before stays so; OPTION 2 fails after the step
    const double D     = (strength.law == TieStrength::Law::strength) ?
                           history.damage :
                           r.history.damage;
    const bool   grows = trial.value > history.damage && trial.value < 1.;
    r.history.release  = release;

    const double whole = 1. - D;
    r.energy           = whole * release;
    for (unsigned int c = 0; c < n; ++c)
      {
        r.traction[c]   = whole * k_t * jump[c];
        r.tangent[c][c] = whole * k_t;
      }
    if (jump[n] > 0.)
      {
        r.traction[n]   = whole * k_n * jump[n];
        r.tangent[n][n] = whole * k_n;
      }
    else
      {
        r.energy += 0.5 * k_n * jump[n] * jump[n];
        r.traction[n]   = k_n * jump[n];
        r.tangent[n][n] = k_n;
      }
    if (grows)
      {
        Tensor<1, dim> dD, t;
        for (unsigned int c = 0; c < n; ++c)
          {
            dD[c] = (sliding > 0.) ? trial.by_shear * jump[c] / sliding : 0.;
            t[c]  = k_t * jump[c];
          }
        if (jump[n] > 0.)
          {
            dD[n] = trial.by_normal;
            t[n]  = k_n * jump[n];
          }
        r.tangent -= outer_product(t, dD);
      }
    return r;
  }


  template class TieLaw<2>;
  template class TieLaw<3>;
} // namespace MortarContact
