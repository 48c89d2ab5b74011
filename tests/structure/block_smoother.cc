// SPDX-License-Identifier: LGPL-2.1-or-later

// Sweeps of the smoother in single precision against their definition.

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <structure/block_smoother.h>

namespace
{
  using namespace dealii;
  using namespace Structure;

  /// A random symmetric matrix of n blocks of two or three unknowns (the last
  /// has two), definite by its diagonal, each block coupled to three others.
  void
  make_matrix(const unsigned int              n,
              FullMatrix<double>             &full,
              TrilinosWrappers::SparseMatrix &sparse)
  {
    const unsigned int                     size = 3 * n - 1;
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> entry(-1., 1.);
    full.reinit(size, size);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          const unsigned int apart = i / 3 - j / 3;
          if (apart <= 1 || apart == 7 || apart == n - 1)
            full(i, j) = full(j, i) = entry(random);
        }
    for (unsigned int i = 0; i < size; ++i)
      {
        double sum = 0.;
        for (unsigned int j = 0; j < size; ++j)
          sum += std::abs(full(i, j));
        full(i, i) = 1.02 * sum;
      }
    DynamicSparsityPattern pattern(size, size);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < size; ++j)
        if (full(i, j) != 0.)
          pattern.add(i, j);
    const IndexSet all = complete_index_set(size);
    sparse.reinit(all, all, pattern, MPI_COMM_SELF);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < size; ++j)
        if (full(i, j) != 0.)
          sparse.set(i, j, full(i, j));
    sparse.compress(VectorOperation::insert);
  }
} // namespace


// (D + L) x = b forward; (D + U) (y - x) = b - A x backward.
TEST(BlockSmoother, SweepsAreThoseOfBlockGaussSeidel)
{
  FullMatrix<double>             A;
  TrilinosWrappers::SparseMatrix sparse;
  make_matrix(20, A, sparse);
  const unsigned int size = A.m();
  BlockSmoother      smoother(sparse);
  smoother.copy_values();

  BlockSmoother::Values b(smoother.n_columns()), r, x(smoother.n_columns());
  for (unsigned int i = 0; i < size; ++i)
    b[i] = std::sin(1. + i);
  r = b;
  smoother.forward_from_zero(x, r);
  BlockSmoother::Values y = x;
  smoother.backward(y, b);
  for (unsigned int i = 0; i < size; ++i)
    {
      double below = -b[i], all = -b[i], above = 0.;
      for (unsigned int j = 0; j < size; ++j)
        {
          all += A(i, j) * x[j];
          if (j / 3 <= i / 3)
            below += A(i, j) * x[j];
          if (j / 3 >= i / 3)
            above += A(i, j) * (y[j] - x[j]);
        }
      EXPECT_NEAR(below, 0., 1e-5) << i;
      EXPECT_NEAR(r[i], -all, 1e-5) << i;
      EXPECT_NEAR(above, -all, 1e-5) << i;
    }
}
