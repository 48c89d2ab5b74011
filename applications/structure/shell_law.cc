// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell_law.h"

#include <cmath>
#include <limits>

namespace Structure
{
  namespace
  {
    PlaneMatrix
    hookes_law(const ShellSection &s)
    {
      const double c =
        s.youngs_modulus / (1. - s.poissons_ratio * s.poissons_ratio);
      PlaneMatrix C = {};
      C[0][0] = C[1][1] = c;
      C[0][1] = C[1][0] = c * s.poissons_ratio;
      C[2][2]           = 0.5 * c * (1. - s.poissons_ratio);
      return C;
    }

    PlaneVector
    times(const PlaneMatrix &A, const PlaneVector &x)
    {
      PlaneVector y = {};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          y[i] += A[i][j] * x[j];
      return y;
    }

    /// x^T P y with the deviator's matrix, sigma^T P sigma = 2/3 von Mises^2;
    /// P sigma is the direction of flow with engineering shear.
    PlaneVector
    deviator(const PlaneVector &stress)
    {
      return {{(2. * stress[0] - stress[1]) / 3.,
               (2. * stress[1] - stress[0]) / 3.,
               2. * stress[2]}};
    }

    double
    dot(const PlaneVector &a, const PlaneVector &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    PlaneResponse
    elasto_plastic(const ShellSection &s,
                   const PlaneVector  &strain,
                   const PlasticState &before)
    {
      const PlaneMatrix C  = hookes_law(s);
      const double      E  = s.youngs_modulus;
      const double      nu = s.poissons_ratio;
      const double      mu = E / (2. * (1. + nu));
      PlaneVector       elastic;
      for (unsigned int i = 0; i < 3; ++i)
        elastic[i] = strain[i] - before.strain[i];
      PlaneResponse r;
      r.stress  = times(C, elastic);
      r.tangent = C;
      r.state   = before;

      // twice the squared radii in the eigenvectors that C and P share
      const double sum  = r.stress[0] + r.stress[1];
      const double diff = r.stress[1] - r.stress[0];
      const double a    = sum * sum / 6.;
      const double b    = 0.5 * diff * diff + 2. * r.stress[2] * r.stress[2];
      const double of_a = E / (3. * (1. - nu)), of_b = 2. * mu;
      const double Y     = s.hardening.stress(before.equivalent);
      const double third = 1. / 3., root = std::sqrt(2. / 3.);
      if (s.hardening.yield_stress > 0. &&
          0.5 * (a + b) > third * Y * Y * (1. + 1e-12))
        {
          // Step 1: the plastic multiplier g. The function falls with g and is
          // convex for hardening: Newton's method from 0 does not overshoot;
          // bisection is there for curves that soften.
          double g = 0., low = 0., high = 0.;
          double radius = 0.;
          for (unsigned int iteration = 0; iteration < 100; ++iteration)
            {
              const double A = 1. + of_a * g, B = 1. + of_b * g;
              const double f2 = a / (A * A) + b / (B * B);
              radius          = std::sqrt(f2);
              const double df2 =
                -2. * (a * of_a / (A * A * A) + b * of_b / (B * B * B));
              const double alpha        = before.equivalent + root * g * radius;
              const double flow         = s.hardening.stress(alpha);
              const double value        = 0.5 * f2 - third * flow * flow;
              (value > 0. ? low : high) = g;
              if (std::abs(value) <= 1e-14 * Y * Y)
                break;
              const double d_alpha = root * (radius + g * 0.5 * df2 / radius);
              const double slope   = 0.5 * df2 - 2. * third * flow *
                                                 s.hardening.slope(alpha) *
                                                 d_alpha;
              double next = g - value / slope;
              if (!(next > low) || (high > 0. && next >= high))
                next = (high > 0.) ? 0.5 * (low + high) : 2. * g + 1. / of_b;
              if (std::abs(next - g) <= 1e-15 * next)
                break;
              g = next;
            }

          // Step 2: stress, in the eigenvectors.
          const double A = 1. + of_a * g, B = 1. + of_b * g;
          r.stress               = {{0.5 * (sum / A - diff / B),
                                     0.5 * (sum / A + diff / B),
                                     r.stress[2] / B}};
          const PlaneVector flow = deviator(r.stress);
          for (unsigned int i = 0; i < 3; ++i)
            r.state.strain[i] += g * flow[i];
          r.state.equivalent += root * g * radius;

          // Step 3: Xi = (C^-1 + g P)^-1, and the consistent tangent.
          PlaneMatrix  Xi = {};
          const double p  = 0.5 * (C[0][0] + C[0][1]) / A,
                       q  = 0.5 * (C[0][0] - C[0][1]) / B;
          Xi[0][0] = Xi[1][1] = p + q;
          Xi[0][1] = Xi[1][0] = p - q;
          Xi[2][2]            = C[2][2] / B;
          const PlaneVector n = times(Xi, flow);
          const double      K = s.hardening.slope(r.state.equivalent);
          const double      beta =
            2. * third * K * radius * radius / (1. - 2. * third * K * g);
          const double denominator = dot(flow, n) + beta;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              r.tangent[i][j] = Xi[i][j] - n[i] * n[j] / denominator;
        }
      for (unsigned int i = 0; i < 3; ++i)
        elastic[i] = strain[i] - r.state.strain[i];
      r.energy = 0.5 * dot(r.stress, elastic);
      return r;
    }

    PlaneResponse
    neo_hookean(const ShellSection &s, const PlaneVector &strain)
    {
      const double nu     = s.poissons_ratio;
      const double mu     = s.youngs_modulus / (2. * (1. + nu));
      const double lambda = 2. * mu * nu / (1. - 2. * nu);
      const double C11 = 1. + 2. * strain[0], C22 = 1. + 2. * strain[1],
                   C12 = strain[2];
      const double det = C11 * C22 - C12 * C12;
      if (!(det > 0. && C11 > 0.))
        {
          PlaneResponse nothing = {};
          nothing.is_valid      = false;
          nothing.stress.fill(std::numeric_limits<double>::quiet_NaN());
          return nothing;
        }

      // C_33 where mu (C_33 - 1) + lambda ln J = 0: concave and growing, so
      // that Newton's method from below converges
      double C33 = 1.;
      {
        const double log_det = std::log(det);
        C33                  = std::min(1., std::exp(-log_det));
        for (unsigned int i = 0; i < 100; ++i)
          {
            const double value =
              mu * (C33 - 1.) + 0.5 * lambda * (log_det + std::log(C33));
            const double next = C33 - value / (mu + 0.5 * lambda / C33);
            const bool   done = std::abs(next - C33) <= 1e-15 * C33;
            C33               = (next > 0.) ? next : 0.5 * C33;
            if (done)
              break;
          }
      }
      const double log_J   = 0.5 * std::log(det * C33);
      const double pull    = lambda * log_J;
      const double inv[3]  = {C22 / det, C11 / det, -C12 / det};
      const double unit[3] = {1., 1., 0.};

      PlaneResponse r;
      for (unsigned int i = 0; i < 3; ++i)
        r.stress[i] = mu * (unit[i] - inv[i]) + pull * inv[i];
      // components of the inverse by index pairs
      const double       G[2][2]  = {{inv[0], inv[2]}, {inv[2], inv[1]}};
      const unsigned int at[3][2] = {{0, 0}, {1, 1}, {0, 1}};
      const double       shear    = mu - pull;
      const double       across   = lambda + 2. * shear;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const auto [a, b] = at[i];
            const auto [c, d] = at[j];
            r.tangent[i][j]   = lambda * inv[i] * inv[j] +
                              shear * (G[a][c] * G[b][d] + G[a][d] * G[b][c]) -
                              lambda * lambda / across * inv[i] * inv[j];
          }
      r.energy = 0.5 * mu * (C11 + C22 + C33 - 3. - 2. * log_J) +
                 0.5 * lambda * log_J * log_J;
      return r;
    }
  } // namespace


  double
  Hardening::stress(const double a) const
  {
    return yield_stress + modulus * a +
           (saturation > 0. ?
              (saturation - yield_stress) * (1. - std::exp(-exponent * a)) :
              0.);
  }


  double
  Hardening::slope(const double a) const
  {
    return modulus + (saturation > 0. ? (saturation - yield_stress) * exponent *
                                          std::exp(-exponent * a) :
                                        0.);
  }


  PlaneResponse
  evaluate_plane_stress(const ShellSection &section,
                        const PlaneVector  &strain,
                        const PlasticState &before)
  {
    return section.is_neo_hookean ? neo_hookean(section, strain) :
                                    elasto_plastic(section, strain, before);
  }


  double
  von_mises(const PlaneVector &s)
  {
    return std::sqrt(s[0] * s[0] + s[1] * s[1] - s[0] * s[1] +
                     3. * s[2] * s[2]);
  }
} // namespace Structure
