// SPDX-License-Identifier: LGPL-2.1-or-later

// Iterations with the preconditioner that solves the contact surfaces exactly.

#include "../support/blocks.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>

namespace
{
  using namespace Test;

  struct Counts
  {
    unsigned int amg = 0, contact = 0; ///< Iterations of CG.
    double       error = 0.; ///< Of the solution, to that of a direct solver.
  };

  /// Two blocks of 8^3 and 9^3 cells that overlap, with a penalty that is this
  /// many times the default.
  Counts
  counts(const double scale)
  {
    Blocks blocks;
    blocks.ratio = 3.;
    blocks.lower = "Cells = 8,8,8";
    blocks.upper = "Cells = 9,9,9";
    blocks.contact =
      "Law = linear|Tangent = symmetric|Stiffness scale = " + num(scale);
    Log        log(MPI_COMM_WORLD, true);
    const auto s     = make<3>(blocks.text<3>(), log);
    Model<3>  &model = s->model;
    EXPECT_EQ(model.assemble(s->u, 1., true), "");

    TrilinosWrappers::PreconditionAMG amg;
    amg.initialize(model.matrix);
    Counts     result;
    const auto solve = [&](const auto &preconditioner, Vector_t &x) {
      SolverControl control(2000, 1e-10 * model.rhs.l2_norm());
      x = model.make_vector();
      try
        {
          SolverCG<Vector_t>(control).solve(model.matrix,
                                            x,
                                            model.rhs,
                                            preconditioner);
        }
      catch (const SolverControl::NoConvergence &)
        {}
      return control.last_step();
    };
    Vector_t x, direct = model.make_vector();
    result.amg = solve(amg, x);
    MortarContact::ContactPreconditioner<TrilinosWrappers::PreconditionAMG>
      preconditioner;
    preconditioner.initialize(
      model.matrix, amg, model.interfaces[0]->active_dofs(model.owned_dofs()));
    // both surfaces, three displacements at each vertex
    EXPECT_EQ(preconditioner.contact_block().n_dofs(), 3u * (81 + 100));
    result.contact = solve(preconditioner, x);
    SolverControl                  control;
    TrilinosWrappers::SolverDirect solver(control);
    solver.initialize(model.matrix);
    solver.solve(direct, model.rhs);
    x -= direct;
    result.error = x.l2_norm() / direct.l2_norm();
    return result;
  }
} // namespace


// As many iterations for a penalty that is 1e6 times the default (those that
// multigrid of deal.II's defaults takes for the blocks alone); multigrid alone
// needs many times more.
TEST(ContactPreconditioner, IterationsDoNotDependOnThePenalty)
{
  const Counts soft = counts(1.), stiffest = counts(1e6);
  for (const Counts &c : {soft, stiffest})
    {
      EXPECT_LE(c.contact, soft.amg + 5);
      EXPECT_LT(c.error, 1e-4);
    }
  EXPECT_GT(stiffest.amg, 10 * stiffest.contact);
}
