// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hex_kernel.h"

#include <cmath>

namespace Structure
{
  namespace
  {
    /// Gradients of the trilinear functions at the Gauss points of the unit
    /// cell.
    struct ReferenceGradients
    {
      double at[8][HexKernel::n_nodes][3];

      ReferenceGradients()
      {
        const double g[2] = {0.5 - std::sqrt(1. / 12.),
                             0.5 + std::sqrt(1. / 12.)};
        for (unsigned int q = 0; q < 8; ++q)
          for (unsigned int a = 0; a < 8; ++a)
            for (unsigned int d = 0; d < 3; ++d)
              {
                double value = 1.;
                for (unsigned int e = 0; e < 3; ++e)
                  {
                    const bool   up = (a >> e) & 1u;
                    const double x  = g[(q >> e) & 1u];
                    value *= (e == d) ? (up ? 1. : -1.) : (up ? x : 1. - x);
                  }
                at[q][a][d] = value;
              }
      }
    };

    const ReferenceGradients reference;


    // All of it is inlined, so that the vectors stay in registers.
#define MORTAR_CONTACT_INLINE __attribute__((always_inline)) inline

    MORTAR_CONTACT_INLINE void
    invert(const Lanes (&A)[3][3], Lanes (&B)[3][3], Lanes &det)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const unsigned int k = (i + 1) % 3, l = (i + 2) % 3;
            const unsigned int m = (j + 1) % 3, n = (j + 2) % 3;
            B[j][i] = A[k][m] * A[l][n] - A[k][n] * A[l][m];
          }
      det = A[0][0] * B[0][0] + A[0][1] * B[1][0] + A[0][2] * B[2][0];
      const Lanes one = 1. / det;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          B[i][j] *= one;
    }


    MORTAR_CONTACT_INLINE void
    evaluate_cells(const HexKernel        &law,
                   const HexKernel::Cells &cells,
                   const bool              stored,
                   const bool              with_tangent,
                   HexKernel::Result      &out)
    {
      constexpr unsigned int n_q = 8, n = HexKernel::n_nodes;
      const Lanes            zero   = {};
      const double           lambda = law.bulk - 2. / 3. * law.mu;

      // Step 1: gradients by undeformed positions, weights, F, volumes.
      Lanes G[n_q][n][3], F[n_q][3][3], w[n_q], J[n_q];
      out.volume     = zero;
      out.new_volume = zero;
      out.energy     = zero;
      for (unsigned int q = 0; q < n_q; ++q)
        {
          Lanes D[3][3] = {}, B[3][3];
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int d = 0; d < 3; ++d)
                D[i][d] += cells.X[a][i] * reference.at[q][a][d];
          invert(D, B, w[q]);
          w[q] *= 1. / n_q;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int K = 0; K < 3; ++K)
              F[q][i][K] = zero + (i == K ? 1. : 0.);
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int K = 0; K < 3; ++K)
              {
                G[q][a][K] = B[0][K] * reference.at[q][a][0] +
                             B[1][K] * reference.at[q][a][1] +
                             B[2][K] * reference.at[q][a][2];
                for (unsigned int i = 0; i < 3; ++i)
                  F[q][i][K] += cells.u[a][i] * G[q][a][K];
              }
        }

      // Step 2: gradients by present positions.
      for (unsigned int q = 0; q < n_q; ++q)
        {
          Lanes B[3][3];
          invert(F[q], B, J[q]);
          for (unsigned int a = 0; a < n; ++a)
            {
              const Lanes G0 = G[q][a][0], G1 = G[q][a][1], G2 = G[q][a][2];
              for (unsigned int i = 0; i < 3; ++i)
                G[q][a][i] = B[0][i] * G0 + B[1][i] * G1 + B[2][i] * G2;
            }
          out.volume += w[q];
          out.new_volume += J[q] * w[q];
          if (q == 0)
            out.smallest_J = J[q];
          else
            // NaN of a node is in all points, and stays in the last one
            out.smallest_J = out.smallest_J < J[q] ? out.smallest_J : J[q];
        }
      for (unsigned int l = 0; l < HexKernel::width; ++l)
        if (!(out.smallest_J[l] > 0.))
          return;
      out.pressure =
        stored ? cells.pressure : law.bulk * (out.new_volume / out.volume - 1.);

      if (law.has_pressure)
        {
          const Lanes dilatation = out.new_volume / out.volume - 1.;
          out.energy = 0.5 * law.bulk * dilatation * dilatation * out.volume;
        }

      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int i = 0; i < 3; ++i)
          {
            out.forces[a][i] = zero;
            out.dv[a][i]     = zero;
          }
      if (with_tangent)
        for (unsigned int k = 0; k < HexKernel::n_pairs; ++k)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              out.tangent[k][i][j] = zero;

      for (unsigned int q = 0; q < n_q; ++q)
        {
          // Step 3: stress; tangent g_a c g_b =
          //   c1 (g_a.g_b 1 + g_b g_a^T) + c2 g_a g_b^T
          //   + c3 (tau_iso g_a g_b^T + g_a (tau_iso g_b)^T)
          Lanes tau[3][3], c1, c2;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              tau[i][j] =
                law.mu * (F[q][i][0] * F[q][j][0] + F[q][i][1] * F[q][j][1] +
                          F[q][i][2] * F[q][j][2]);
          const double c3      = law.has_pressure ? -2. / 3. : 0.;
          Lanes        spheric = zero;
          if (law.has_pressure)
            {
              Lanes factor;
              for (unsigned int l = 0; l < HexKernel::width; ++l)
                {
                  const double root = std::cbrt(J[q][l]);
                  factor[l]         = 1. / (root * root);
                }
              const Lanes alpha = factor * (tau[0][0] + tau[1][1] + tau[2][2]);
              out.energy += 0.5 * w[q] * (alpha - 3. * law.mu);
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  tau[i][j] *= factor;
              for (unsigned int i = 0; i < 3; ++i)
                tau[i][i] -= alpha * (1. / 3.);
              spheric = J[q] * out.pressure;
              c1      = alpha * (1. / 3.) - spheric;
              c2      = alpha * (-2. / 9.) + spheric;
            }
          else
            {
              Lanes log_J;
              for (unsigned int l = 0; l < HexKernel::width; ++l)
                log_J[l] = std::log(J[q][l]);
              out.energy += 0.5 * w[q] *
                            (tau[0][0] + tau[1][1] + tau[2][2] - 3. * law.mu -
                             2. * law.mu * log_J + lambda * log_J * log_J);
              for (unsigned int i = 0; i < 3; ++i)
                tau[i][i] += lambda * log_J - law.mu;
              c1 = law.mu - lambda * log_J;
              c2 = zero + lambda;
            }

          Lanes       t[n][3]; // tau_iso g_a, without the spherical part
          const auto &g = G[q];
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int i = 0; i < 3; ++i)
              {
                t[a][i] = tau[i][0] * g[a][0] + tau[i][1] * g[a][1] +
                          tau[i][2] * g[a][2];
                out.forces[a][i] += w[q] * (t[a][i] + spheric * g[a][i]);
                out.dv[a][i] += w[q] * J[q] * g[a][i];
              }
          if (!with_tangent)
            continue;
          const Lanes c1_w = c1 * w[q], c2_w = c2 * w[q], c3_w = c3 * w[q];
          const Lanes along = c1_w + spheric * w[q];
          for (unsigned int a = 0, k = 0; a < n; ++a)
            {
              Lanes by_g[3], by_t[3], c1_g[3];
              for (unsigned int i = 0; i < 3; ++i)
                {
                  by_g[i] = c2_w * g[a][i] + c3_w * t[a][i];
                  by_t[i] = c3_w * g[a][i];
                  c1_g[i] = c1_w * g[a][i];
                }
              for (unsigned int b = a; b < n; ++b, ++k)
                {
                  const Lanes isotropic =
                    along * (g[a][0] * g[b][0] + g[a][1] * g[b][1] +
                             g[a][2] * g[b][2]) +
                    w[q] * (t[a][0] * g[b][0] + t[a][1] * g[b][1] +
                            t[a][2] * g[b][2]);
                  for (unsigned int i = 0; i < 3; ++i)
                    {
                      for (unsigned int j = 0; j < 3; ++j)
                        out.tangent[k][i][j] += by_g[i] * g[b][j] +
                                                by_t[i] * t[b][j] +
                                                g[b][i] * c1_g[j];
                      out.tangent[k][i][i] += isotropic;
                    }
                }
            }
        }
    }


    // One version per instruction set, where compiler and machine can pick one
    // at the start. Calls with constants drop what is not asked.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#  define MORTAR_CONTACT_CLONES \
    __attribute__((target_clones("avx512f", "avx2,fma", "default")))
#else
#  define MORTAR_CONTACT_CLONES
#endif

    MORTAR_CONTACT_CLONES void
    evaluate_tangent(const HexKernel        &law,
                     const HexKernel::Cells &cells,
                     const bool              stored,
                     HexKernel::Result      &result)
    {
      evaluate_cells(law, cells, stored, true, result);
    }


    MORTAR_CONTACT_CLONES void
    evaluate_forces(const HexKernel        &law,
                    const HexKernel::Cells &cells,
                    const bool              stored,
                    HexKernel::Result      &result)
    {
      evaluate_cells(law, cells, stored, false, result);
    }
#undef MORTAR_CONTACT_CLONES
#undef MORTAR_CONTACT_INLINE
  } // namespace


  void
  HexKernel::evaluate(const Cells &cells,
                      const bool   stored,
                      const bool   with_tangent,
                      Result      &result) const
  {
    if (with_tangent)
      evaluate_tangent(*this, cells, stored, result);
    else
      evaluate_forces(*this, cells, stored, result);
  }
} // namespace Structure
