// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_tests_facet_pair_h
#define mortar_contact_tests_facet_pair_h

// A pair of facets in general position, for tests of kernels.

#include <mortar_contact/mortar/pair_kernel.h>

#include <array>
#include <cmath>
#include <random>

namespace Test
{
  using namespace MortarContact;

  /// A secondary and a primary facet that overlap, warped, tilted and with
  /// varying stiffness; @p penetration is the distance of their centres.
  struct Pair3d
  {
    ContactFacet<3>   secondary, primary;
    SecondaryState<3> offset;

    Pair3d(const unsigned int n_s,
           const unsigned int n_p,
           const double       penetration,
           const double       tilt,
           const unsigned int seed)
    {
      std::mt19937                           rng(seed);
      std::uniform_real_distribution<double> u(-1., 1.);
      const auto make = [&](ContactFacet<3> &f, const unsigned int n) {
        const double corners[4][2] = {{-.5, -.5},
                                      {.5, -.5},
                                      {.5, .5},
                                      {-.5, .5}};
        f.current.n_vertices = f.reference.n_vertices = n;
        for (unsigned int a = 0; a < n; ++a)
          {
            const unsigned int c = (n == 3 && a == 2) ? 3 : a;
            for (unsigned int i = 0; i < 2; ++i)
              f.current.x[a][i] = corners[c][i] + 0.08 * u(rng);
            f.current.x[a][2] = 0.02 * u(rng);
            for (unsigned int i = 0; i < 3; ++i)
              f.reference.x[a][i] = f.current.x[a][i] * (1. + 0.05 * u(rng));
            // steep pairs reach deep: long enough for all points to count
            f.length[a]     = (tilt > 1. ? 2. : 0.1) * (1. + 0.1 * u(rng));
            f.compliance[a] = 1e-4 * (1. + 0.1 * u(rng));
          }
      };
      make(secondary, n_s);
      make(primary, n_p);
      // the primary faces down, turned and shifted in the plane, tilted
      const double angle = 0.4;
      for (unsigned int a = 0; a < n_p; ++a)
        {
          Tensor<1, 3> &x = primary.current.x[a];
          Tensor<1, 3>  y;
          y[0] = std::cos(angle) * x[0] - std::sin(angle) * x[1] + 0.23;
          y[1] = -(std::sin(angle) * x[0] + std::cos(angle) * x[1]) + 0.11;
          y[2] = -x[2];
          x[0] = std::cos(tilt) * y[0] - std::sin(tilt) * y[2];
          x[1] = y[1];
          x[2] = std::sin(tilt) * y[0] + std::cos(tilt) * y[2] - penetration;
        }
      offset.level = {{0.004, 0.006, 0.005, 0.003}};
      offset.share = 0.5;
    }

    void
    rotate(const Tensor<2, 3> &Q)
    {
      for (ContactFacet<3> *f : {&secondary, &primary})
        for (auto &x : f->current.x)
          x = Q * x;
    }
  };

  inline double
  norm(const PairVector<3> &v)
  {
    double s = 0.;
    for (const double x : v)
      s += x * x;
    return std::sqrt(s);
  }

  inline Tensor<2, 3>
  rotation(const double a, const double b)
  {
    Tensor<2, 3> Rz = Tensor<2, 3>(), Rx = Tensor<2, 3>();
    Rz[0][0] = Rz[1][1] = std::cos(a);
    Rz[1][0]            = std::sin(a);
    Rz[0][1]            = -std::sin(a);
    Rz[2][2]            = 1.;
    Rx[1][1] = Rx[2][2] = std::cos(b);
    Rx[2][1]            = std::sin(b);
    Rx[1][2]            = -std::sin(b);
    Rx[0][0]            = 1.;
    return Rz * Rx;
  }

  /// Force on all vertices and its moment about the origin.
  inline std::array<Tensor<1, 3>, 2>
  resultants(const PairVector<3> &f,
             const Facet<3>      &secondary,
             const Facet<3>      &primary)
  {
    std::array<Tensor<1, 3>, 2> sums;
    for (unsigned int a = 0; a < 8; ++a)
      {
        const Tensor<1, 3> &x = (a < 4) ? secondary.x[a] : primary.x[a - 4];
        const Tensor<1, 3>  fa({f[3 * a], f[3 * a + 1], f[3 * a + 2]});
        sums[0] += fa;
        sums[1] += cross_product_3d(x, fa);
      }
    return sums;
  }

  /**
   * Largest difference between a block's tangent and central differences of its
   * residual over the largest entry, best over several steps.
   * @param evaluate Block of two facets.
   */
  template <int dim, class Evaluate>
  double
  tangent_error(const Evaluate &evaluate, Facet<dim> s, Facet<dim> p)
  {
    constexpr unsigned int n     = max_facet_components<dim>;
    const PairBlock<dim>   block = evaluate(s, p, true);
    double                 best  = 1e300;
    for (const double h : {1e-4, 1e-5, 1e-6, 1e-7})
      {
        double error = 0., scale = 0.;
        for (unsigned int j = 0; j < 2 * n; ++j)
          {
            const auto moved = [&](const double by) {
              Facet<dim>  ms = s, mp = p;
              Facet<dim> &f = (j < n) ? ms : mp;
              f.x[(j % n) / dim][j % dim] += by;
              return evaluate(ms, mp, false).residual;
            };
            const auto plus = moved(h), minus = moved(-h);
            for (unsigned int i = 0; i < 2 * n; ++i)
              {
                const double fd = (plus[i] - minus[i]) / (2. * h);
                error = std::max(error, std::abs(fd - block.tangent[i][j]));
                scale = std::max(scale, std::abs(fd));
              }
          }
        best = std::min(best, error / scale);
      }
    return best;
  }
} // namespace Test

#endif
