// SPDX-License-Identifier: LGPL-2.1-or-later

// Multigrid of the drivers: what it must be for CG, and what outlives a matrix.

#include "../support/blocks.h"

#include <structure/multigrid.h>

namespace
{
  using namespace Test;

  /// Values that no two unknowns share.
  Vector_t
  some_vector(const Model<3> &model, const double phase)
  {
    Vector_t v = model.make_vector();
    for (const auto i : v.locally_owned_elements())
      v(i) = std::sin(phase + 0.7 * i);
    v.compress(VectorOperation::insert);
    return v;
  }
} // namespace


TEST(Multigrid, CoarseLevelsOutliveTheMatrix)
{
  Blocks blocks;
  blocks.lower = "Cells = 8,8,8";
  blocks.upper = "Cells = 9,9,9";
  Log        log(MPI_COMM_WORLD, true);
  const auto s     = make<3>(blocks.text<3>(), log);
  Model<3>  &model = s->model;
  ASSERT_EQ(model.assemble(s->u, 1., true), "");

  auto first = std::make_unique<TrilinosWrappers::SparseMatrix>();
  first->reinit(model.matrix);
  first->copy_from(model.matrix);
  Multigrid multigrid(*first, model.rigid_body_modes());
  ASSERT_TRUE(multigrid.has_levels());
  const Vector_t v = some_vector(model, 0.), w = some_vector(model, 1.);
  Vector_t       before = model.make_vector(), after = before, other = before;
  multigrid.vmult(before, v);
  multigrid.vmult(other, w);
  EXPECT_NEAR(before * w, other * v, 1e-5 * v.l2_norm() * other.l2_norm());
  EXPECT_GT(before * v, 0.);

  multigrid.forget_matrix();
  first.reset();
  multigrid.update(model.matrix);
  multigrid.vmult(after, v);
  after -= before;
  EXPECT_EQ(after.l2_norm(), 0.);
}
