// SPDX-License-Identifier: LGPL-2.1-or-later

// The shell element alone: derivatives, objectivity, patch tests, thin limit.

#include <structure/shell_element.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

using namespace dealii;
using namespace Structure;

namespace
{
  using Vector3 = Tensor<1, 3>;

  /// A warped element with directors that are not its normals.
  ShellElement
  warped(const unsigned int n, const double scale = 0.7)
  {
    std::vector<Vector3> R = {Vector3({0., 0., 0.}),
                              Vector3({1.1, 0.1, 0.2}),
                              Vector3({-0.1, 0.9, 0.1}),
                              Vector3({1., 1.2, -0.2})};
    std::vector<Vector3> D;
    R.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        D.push_back(Vector3({0.1 * i, -0.05 * i, 1.}));
        D.back() /= D.back().norm();
      }
    return ShellElement(R, D, {1000., 0.3, 0.1, 2.}, scale);
  }

  Vector<double>
  some_dofs(const unsigned int n)
  {
    Vector<double> u(n);
    for (unsigned int i = 0; i < n; ++i)
      u(i) = 0.2 * std::sin(3. * i + 1.);
    return u;
  }

  /// The patch of MacNeal & Harder: five quadrilaterals of a rectangle, or ten
  /// triangles.
  struct Patch
  {
    explicit Patch(const bool triangles, const double thickness)
    {
      X     = {Vector3({0., 0., 0.}),
               Vector3({0.24, 0., 0.}),
               Vector3({0.24, 0.12, 0.}),
               Vector3({0., 0.12, 0.}),
               Vector3({0.04, 0.02, 0.}),
               Vector3({0.18, 0.03, 0.}),
               Vector3({0.16, 0.08, 0.}),
               Vector3({0.08, 0.08, 0.})};
      cells = {
        {0, 1, 4, 5}, {1, 2, 5, 6}, {2, 3, 6, 7}, {3, 0, 7, 4}, {4, 5, 7, 6}};
      if (triangles)
        {
          std::vector<std::vector<unsigned int>> split;
          for (const auto &c : cells)
            {
              split.push_back({c[0], c[1], c[2]});
              split.push_back({c[3], c[2], c[1]});
            }
          cells = split;
        }
      for (const auto &c : cells)
        {
          std::vector<Vector3> R;
          for (const unsigned int i : c)
            R.push_back(X[i]);
          elements.emplace_back(R,
                                std::vector<Vector3>(c.size(),
                                                     Vector3({0., 0., 1.})),
                                ShellSection{1e6, 0.25, thickness, 0.},
                                scale);
        }
    }

    /// Solve with the outer nodes given; the largest error at the inner ones.
    double
    error(
      const std::function<std::array<double, 6>(const Vector3 &)> &field) const
    {
      const unsigned int n = 6 * X.size(), first = 6 * 4;
      FullMatrix<double> K(n, n);
      Vector<double>     f(n);
      for (unsigned int e = 0; e < cells.size(); ++e)
        {
          const unsigned int m = elements[e].n_dofs();
          FullMatrix<double> k(m, m);
          Vector<double>     g(m);
          elements[e].evaluate(Vector<double>(m), true, nullptr, g, k);
          for (unsigned int i = 0; i < m; ++i)
            for (unsigned int j = 0; j < m; ++j)
              K(6 * cells[e][i / 6] + i % 6, 6 * cells[e][j / 6] + j % 6) +=
                k(i, j);
        }
      FullMatrix<double> inner(n - first, n - first);
      Vector<double>     right(n - first), found(n - first);
      double             size = 0., worst = 0.;
      for (unsigned int i = first; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (j < first)
            right(i - first) -= K(i, j) * field(X[j / 6])[j % 6];
          else
            inner(i - first, j - first) = K(i, j);
      inner.gauss_jordan();
      inner.vmult(found, right);
      for (unsigned int i = first; i < n; ++i)
        {
          const double expected = field(X[i / 6])[i % 6];
          size                  = std::max(size, std::abs(expected));
          worst = std::max(worst, std::abs(found(i - first) - expected));
        }
      return worst / size;
    }

    static constexpr double scale = 0.1; ///< Of the directors.

    std::vector<Vector3>                   X;
    std::vector<std::vector<unsigned int>> cells;
    std::vector<ShellElement>              elements;
  };
} // namespace


TEST(ShellElement, ForcesAreTheGradientOfTheEnergyAndTheTangentTheirDerivative)
{
  for (const unsigned int n : {3u, 4u})
    {
      const ShellElement element = warped(n);
      Vector<double> u = some_dofs(6 * n), f(6 * n), plus(6 * n), minus(6 * n);
      FullMatrix<double> K(6 * n, 6 * n), none;
      element.evaluate(u, true, nullptr, f, K);
      const double h = 1e-6;
      for (unsigned int i = 0; i < 6 * n; ++i)
        {
          Vector<double> a = u, b = u;
          a(i) += h;
          b(i) -= h;
          EXPECT_NEAR((element.energy(a) - element.energy(b)) / (2. * h),
                      f(i),
                      1e-8 * f.linfty_norm());
          element.evaluate(a, false, nullptr, plus, none);
          element.evaluate(b, false, nullptr, minus, none);
          for (unsigned int j = 0; j < 6 * n; ++j)
            EXPECT_NEAR((plus(j) - minus(j)) / (2. * h),
                        K(j, i),
                        1e-9 * K.linfty_norm());
        }
    }
}



// The forces over a step do the work by which the energy changes, exactly; they
// have no resultant and no moment at the middle of the step.
TEST(ShellElement, ForcesOverAStepDoTheWorkOfTheStrainEnergy)
{
  for (const unsigned int n : {3u, 4u})
    {
      const ShellElement element = warped(n);
      const unsigned int n_dofs  = element.n_dofs();
      Vector<double>     u_n     = some_dofs(n_dofs), u(n_dofs);
      for (unsigned int i = 0; i < n_dofs; ++i)
        u(i) = 0.3 * std::cos(2. * i);
      Vector<double>     forces(n_dofs), plus(n_dofs), minus(n_dofs);
      FullMatrix<double> tangent(n_dofs, n_dofs), none;
      element.evaluate_step(u_n, u, true, nullptr, forces, tangent);
      Vector<double> motion = u;
      motion -= u_n;
      EXPECT_NEAR(forces * motion,
                  element.energy(u) - element.energy(u_n),
                  1e-12 * element.energy(u));
      Vector3 sum;
      for (unsigned int k = 0; k < n; ++k)
        sum += Vector3({forces(6 * k), forces(6 * k + 1), forces(6 * k + 2)});
      EXPECT_LT(sum.norm(), 1e-12 * forces.l2_norm());
      const double h = 1e-6;
      for (unsigned int j = 0; j < n_dofs; ++j)
        {
          Vector<double> w = u;
          w(j) += h;
          element.evaluate_step(u_n, w, false, nullptr, plus, none);
          w(j) -= 2. * h;
          element.evaluate_step(u_n, w, false, nullptr, minus, none);
          for (unsigned int i = 0; i < n_dofs; ++i)
            EXPECT_NEAR(tangent(i, j),
                        (plus(i) - minus(i)) / (2. * h),
                        1e-7 * tangent.frobenius_norm());
        }
      // where nothing moves they are the forces there
      element.evaluate_step(u, u, true, nullptr, forces, tangent);
      element.evaluate(u, false, nullptr, plus, none);
      plus -= forces;
      EXPECT_LT(plus.l2_norm(), 1e-13 * forces.l2_norm());
    }
}


TEST(ShellElement, ExtrapolatedStressesLeaveTheForcesAndVanishWithTheStep)
{
  const ShellElement element = warped(4);
  Vector<double>     u = some_dofs(24), before = u, f(24), g(24);
  FullMatrix<double> K(24, 24), mixed(24, 24);
  element.evaluate(u, true, nullptr, f, K);
  element.evaluate(u, true, &before, g, mixed);
  mixed.add(-1., K);
  EXPECT_LT(mixed.linfty_norm(), 1e-12 * K.linfty_norm());
  double last = 0.;
  for (const double step : {0.1, 0.05})
    {
      for (unsigned int i = 0; i < 24; ++i)
        before(i) = u(i) - step * std::cos(1. + i);
      element.evaluate(u, true, &before, g, mixed);
      EXPECT_EQ(f, g);
      mixed.add(-1., K);
      // of second order in the step: f2 is quadratic
      if (last > 0.)
        {
          EXPECT_NEAR(mixed.linfty_norm() / last, 0.25, 1e-6);
        }
      last = mixed.linfty_norm();
    }
}


TEST(ShellElement, RigidMotionHasNoEnergyAndNothingElseHas)
{
  for (const unsigned int n : {3u, 4u})
    {
      const double       scale   = 0.7;
      const ShellElement element = warped(n, scale);

      // eigenvalues at rest: six zeros
      Vector<double>           u(6 * n), f(6 * n);
      FullMatrix<double>       K(6 * n, 6 * n);
      LAPACKFullMatrix<double> eigen(6 * n, 6 * n);
      element.evaluate(u, true, nullptr, f, K);
      EXPECT_EQ(f.l2_norm(), 0.);
      eigen = K;
      eigen.compute_eigenvalues();
      std::vector<double> values;
      for (unsigned int i = 0; i < 6 * n; ++i)
        values.push_back(eigen.eigenvalue(i).real());
      std::sort(values.begin(), values.end());
      for (unsigned int i = 0; i < 6; ++i)
        EXPECT_LT(std::abs(values[i]), 1e-12 * values.back());
      EXPECT_GT(values[6], 1e-5 * values.back());

      // two radians about an inclined axis (Rodrigues), and a shift: R and D of
      // warped() again
      Vector3 axis({1., 2., -0.5});
      axis /= axis.norm();
      const auto turn = [&](const Vector3 &x) {
        return Vector3(std::cos(2.) * x +
                       std::sin(2.) * cross_product_3d(axis, x) +
                       (1. - std::cos(2.)) * (axis * x) * axis);
      };
      const Vector3 R[4] = {Vector3({0., 0., 0.}),
                            Vector3({1.1, 0.1, 0.2}),
                            Vector3({-0.1, 0.9, 0.1}),
                            Vector3({1., 1.2, -0.2})};
      for (unsigned int i = 0; i < n; ++i)
        {
          Vector3 D({0.1 * i, -0.05 * i, 1.});
          D /= D.norm();
          const Vector3 v = turn(R[i]) - R[i] + Vector3({3., -1., 2.});
          const Vector3 q = scale * (turn(D) - D);
          for (unsigned int c = 0; c < 3; ++c)
            {
              u(6 * i + c)     = v[c];
              u(6 * i + 3 + c) = q[c];
            }
        }
      EXPECT_LT(element.energy(u), 1e-28 * 1000.);
      element.evaluate(u, false, nullptr, f, K);
      EXPECT_LT(f.linfty_norm(), 1e-13 * 1000.);
    }
}


TEST(ShellElement, PassesMembraneBendingAndShearPatchTests)
{
  for (const bool triangles : {false, true})
    for (const double t : {1e-2, 1e-3})
      {
        const Patch patch(triangles, t);
        // MacNeal & Harder 1985: u = 1e-3 (x + y/2), v = 1e-3 (y + x/2)
        EXPECT_LT(patch.error([](const Vector3 &x) {
          return std::array<double, 6>{{1e-3 * (x[0] + 0.5 * x[1]),
                                        1e-3 * (x[1] + 0.5 * x[0]),
                                        0.,
                                        0.,
                                        0.,
                                        0.}};
        }),
                  1e-9);
        // w = 1e-3 (x^2 + xy + y^2)/2, directors normal to it
        EXPECT_LT(patch.error([](const Vector3 &x) {
          return std::array<double, 6>{
            {0.,
             0.,
             0.5e-3 * (x[0] * x[0] + x[0] * x[1] + x[1] * x[1]),
             -1e-3 * Patch::scale * (x[0] + 0.5 * x[1]),
             -1e-3 * Patch::scale * (x[1] + 0.5 * x[0]),
             0.}};
        }),
                  1e-6)
          << "bending, triangles " << triangles;
        // constant transverse shear (no equilibrium without couples, so by its
        // energy): 1/2 5/6 G t A (g_1^2 + g_2^2)
        double energy = 0.;
        for (const ShellElement &element : patch.elements)
          {
            Vector<double> u(element.n_dofs());
            for (unsigned int i = 0; i < u.size(); i += 6)
              {
                u(i + 3) = 1e-6 * Patch::scale;
                u(i + 4) = 2e-6 * Patch::scale;
              }
            energy += element.energy(u);
          }
        EXPECT_NEAR(energy /
                      (0.5 * 5. / 6. * 1e6 / 2.5 * t * 0.24 * 0.12 * 5e-12),
                    1.,
                    1e-5);
      }
}


TEST(ShellElement, RefusesElementsWithoutArea)
{
  const std::vector<Vector3> D(4, Vector3({0., 0., 1.}));
  std::vector<Vector3>       R = {Vector3({0., 0., 0.}),
                                  Vector3({1., 0., 0.}),
                                  Vector3({2., 0., 0.}),
                                  Vector3({3., 0., 0.})};
  EXPECT_THROW(ShellElement(R, D, {1., 0.3, 0.1, 0.}, 1.), ExceptionBase);
}
