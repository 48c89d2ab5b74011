// SPDX-License-Identifier: LGPL-2.1-or-later

// Leaflets without fluid. References: finite differences, rigid motions, the
// cantilever of K. Sze, X. Liu, S. Lo, Finite Elem. Anal. Des. 40 (2004) 1551
// (nu = 0, so that a strip is a beam).

#include "immersed/leaflets.h"

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/sparse_direct.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace Immersed;

namespace
{
  BeamElement::Nodes
  turned(const BeamElement::Nodes &x, const double angle)
  {
    Tensor<2, 2> R;
    R[0][0] = R[1][1] = std::cos(angle);
    R[1][0]           = std::sin(angle);
    R[0][1]           = -R[1][0];
    BeamElement::Nodes result;
    for (unsigned int i = 0; i < x.size(); ++i)
      result[i] = R * x[i];
    return result;
  }
} // namespace


TEST(Beam, ForcesAndTangentAreDerivatives)
{
  const BeamMaterial       material = {7., 0.3, 0.2, 1.};
  const BeamElement::Nodes X        = {{Tensor<1, 2>({0.1, 0.}),
                                        Tensor<1, 2>({0.9, 0.4}),
                                        Tensor<1, 2>({-0.45, 0.9}),
                                        Tensor<1, 2>({-0.4, 0.92})}};
  BeamElement::Nodes       x        = turned(X, 0.8);
  for (unsigned int i = 0; i < x.size(); ++i)
    x[i] += Tensor<1, 2>({0.03 * i, 0.02 - 0.05 * i});
  const BeamElement  element(material, X);
  Vector<double>     f, plus, minus;
  FullMatrix<double> K;
  element.differentiate(x, {}, f, &K);
  EXPECT_GT(f.l2_norm(), 0.1);
  const double eps = 1e-5;
  for (unsigned int i = 0; i < x.size(); ++i)
    for (unsigned int c = 0; c < 2; ++c)
      {
        BeamElement::Nodes up = x, down = x;
        up[i][c] += eps;
        down[i][c] -= eps;
        EXPECT_NEAR(f(2 * i + c),
                    (element.energy(up) - element.energy(down)) / (2. * eps),
                    1e-8);
        element.differentiate(up, {}, plus, nullptr);
        element.differentiate(down, {}, minus, nullptr);
        for (unsigned int k = 0; k < 8; ++k)
          EXPECT_NEAR(K(k, 2 * i + c), (plus(k) - minus(k)) / (2. * eps), 1e-8);
      }
}


TEST(Beam, RigidMotionsCostNothing)
{
  const BeamElement::Nodes X = {{Tensor<1, 2>({0., 0.}),
                                 Tensor<1, 2>({2., 1.}),
                                 Tensor<1, 2>({-0.4, 0.9}),
                                 Tensor<1, 2>({-0.5, 0.8})}};
  const BeamElement        element({5., 0.2, 0.3, 1.}, X);
  for (const double angle : {0.3, 2., 3.1})
    {
      BeamElement::Nodes x = turned(X, angle);
      for (unsigned int i = 0; i < 2; ++i)
        x[i] += Tensor<1, 2>({3., -7.});
      EXPECT_LT(element.energy(x), 1e-26);
    }
}


// L = 10, h = 0.1, E = 1.2e6, end shear 4: the tip moves by 3.286 back and
// 6.698 aside.
TEST(Beam, CantileverOfSze)
{
  const Leaflets leaflets({{Point<2>(0., 0.), Point<2>(10., 0.), 40, false}},
                          {1.2e6, 0., 0.1, 0.});
  const auto     n = leaflets.dof_handler.n_dofs();
  AffineConstraints<double> constraints;
  leaflets.constrain(constraints);
  constraints.close();
  DynamicSparsityPattern dsp(n);
  leaflets.add_couplings(dsp, constraints);
  SparsityPattern sparsity;
  sparsity.copy_from(dsp);
  SparseMatrix<double>    matrix(sparsity);
  Vector<double>          u(n), rhs(n), update(n);
  types::global_dof_index loaded = 0;
  for (const auto &cell : leaflets.dof_handler.active_cell_iterators())
    for (unsigned int a = 0; a < 2; ++a)
      if (cell->vertex_index(a) == leaflets.tip(0))
        loaded = cell->vertex_dof_index(a, 1);
  // the whole force at once: with the exact tangent it takes 18 iterations
  for (unsigned int i = 0;; ++i)
    {
      ASSERT_LT(i, 10u);
      matrix = 0.;
      rhs    = 0.;
      leaflets.assemble(u, update, {}, 0., constraints, matrix, rhs);
      rhs(loaded) += 4.;
      if (rhs.l2_norm() < 1e-8)
        break;
      SparseDirectUMFPACK solver;
      solver.initialize(matrix);
      solver.vmult(update, rhs);
      constraints.distribute(update);
      u += update;
    }
  const Point<2> tip = leaflets.place(leaflets.tip(0), u);
  EXPECT_NEAR(10. - tip[0], 3.286, 0.01 * 3.286);
  EXPECT_NEAR(tip[1], 6.698, 0.01 * 6.698);
}
