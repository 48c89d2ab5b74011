// SPDX-License-Identifier: LGPL-2.1-or-later

// The fluid alone, and with leaflets that do not move. References: Poiseuille's
// flow; benchmark 2D-1 of M. Schaefer, S. Turek, Flow Simulation with
// High-Performance Computers II (1996) 547, with the digits of
// featflow.de; Bernoulli's law for flow that starts; the fluxes that
// SHELL_AND_FLUID 4.3 measured with another program.

#include "immersed/immersed_flow.h"

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>

#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace Immersed;

namespace
{
  /// Along the channel: a parabola.
  class Parabola : public Function<2>
  {
  public:
    Parabola(const double height, const double largest)
      : Function<2>(3)
      , height(height)
      , largest(largest)
    {}

    double
    value(const Point<2> &x, const unsigned int component) const override
    {
      return component == 0 ?
               4. * largest * x[1] * (height - x[1]) / (height * height) :
               0.;
    }

  private:
    const double height, largest;
  };


  /// A steady flow by Newton's method, and its residual without constraints.
  struct SteadyFlow
  {
    SteadyFlow(const Triangulation<2>                            &mesh,
               const Mapping<2>                                  &mapping,
               const FluidParameters                             &parameters,
               const std::map<types::boundary_id, Function<2> *> &velocities,
               const NavierStokes::Pressures                     &pressures)
      : fluid(parameters)
      , dof_handler(mesh)
    {
      dof_handler.distribute_dofs(fluid.fe);
      AffineConstraints<double> hanging_nodes, constraints;
      DoFTools::make_hanging_node_constraints(dof_handler, hanging_nodes);
      constraints.merge(hanging_nodes);
      hanging_nodes.close();
      std::map<types::global_dof_index, double> values;
      for (const auto &[id, function] : velocities)
        VectorTools::interpolate_boundary_values(
          mapping,
          dof_handler,
          id,
          *function,
          values,
          fluid.fe.component_mask(FEValuesExtractors::Vector(0)));
      // parallel where pressure is given
      for (const auto &[id, p] : pressures)
        VectorTools::interpolate_boundary_values(
          mapping,
          dof_handler,
          id,
          Functions::ZeroFunction<2>(3),
          values,
          fluid.fe.component_mask(FEValuesExtractors::Scalar(1)));
      for (const auto &value : values)
        constraints.add_line(value.first);
      constraints.close();
      DynamicSparsityPattern dsp(dof_handler.n_dofs());
      DoFTools::make_sparsity_pattern(dof_handler, dsp, constraints, false);
      SparsityPattern sparsity;
      sparsity.copy_from(dsp);
      SparseMatrix<double> matrix(sparsity);
      u.reinit(dof_handler.n_dofs());
      residual.reinit(u);
      for (const auto &[dof, value] : values)
        u(dof) = value;
      hanging_nodes.distribute(u); // they follow those at the boundary
      Vector<double> update(u);
      for (unsigned int i = 0; i < 12; ++i)
        {
          matrix   = 0.;
          residual = 0.;
          fluid.assemble(dof_handler,
                         mapping,
                         u,
                         u,
                         0.,
                         pressures,
                         constraints,
                         0,
                         matrix,
                         residual);
          last_norm = residual.l2_norm();
          if (i > 0 && last_norm < 1e-13)
            break;
          SparseDirectUMFPACK solver;
          solver.initialize(matrix);
          solver.vmult(update, residual);
          constraints.distribute(update);
          u += update;
        }
      AffineConstraints<double> none;
      none.close();
      DynamicSparsityPattern full(dof_handler.n_dofs());
      DoFTools::make_sparsity_pattern(dof_handler, full, none);
      SparsityPattern full_sparsity;
      full_sparsity.copy_from(full);
      SparseMatrix<double> full_matrix(full_sparsity);
      residual = 0.;
      fluid.assemble(dof_handler,
                     mapping,
                     u,
                     u,
                     0.,
                     pressures,
                     none,
                     0,
                     full_matrix,
                     residual);
    }

    NavierStokes   fluid;
    DoFHandler<2>  dof_handler;
    Vector<double> u, residual;
    double         last_norm = 0.;
  };


  /// 4 x 1 with sixteen cells across, 1000 at the left, for 20 steps of 0.01
  /// from rest; a wall between two points.
  double
  leak(const std::vector<Point<2>> &wall,
       const double                 grad_div,
       const double                 penalty)
  {
    Parameters p;
    p.length        = 4.;
    p.height        = 1.;
    p.n_x           = 64;
    p.n_y           = 16;
    p.n_refinements = p.refine_every = 0;
    p.fluid                          = {1., 0.03, grad_div};
    p.penalty                        = penalty;
    p.has_velocity                   = false;
    p.inflow                         = "1000";
    p.first_step                     = 0.01;
    p.has_contact                    = false;
    p.material                       = {1., 0., 0.01, 1.};
    p.leaflets                       = {{wall[0], wall[1], 64, true}};
    Structure::Log log(MPI_COMM_SELF, true);
    ImmersedFlow   flow(p, "", log);
    for (unsigned int i = 0; i < 20; ++i)
      {
        const std::string failure = flow.try_step(0.01);
        EXPECT_EQ(failure, "");
      }
    return flow.inflow();
  }
} // namespace


TEST(NavierStokes, PoiseuilleIsExact)
{
  Triangulation<2> mesh;
  GridGenerator::subdivided_hyper_rectangle(
    mesh, {5, 3}, Point<2>(), Point<2>(4., 2.), true);
  mesh.begin_active()->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
  Parabola                   parabola(2., 0.7);
  Functions::ZeroFunction<2> zero(3);
  const double               mu = 0.3;
  const MappingQ1<2>         mapping;
  const SteadyFlow           flow(mesh,
                        mapping,
                        {1.3, mu, 0.},
                        {{0, &parabola}, {2, &zero}, {3, &zero}},
                        {{1, 0.25}});
  // dp/dx = -8 mu U/H^2; the stress of a parabola has no normal part
  const double fall = 8. * mu * 0.7 / 4. * 4.;
  EXPECT_NEAR(flow.fluid.mean_pressure(flow.dof_handler, mapping, flow.u, 0),
              0.25 + fall,
              1e-10);
  EXPECT_NEAR(flow.fluid.flux(flow.dof_handler, mapping, flow.u, 1),
              2. / 3. * 0.7 * 2.,
              1e-12);
}


TEST(NavierStokes, CylinderOfSchaeferAndTurek)
{
  Triangulation<2> mesh;
  GridGenerator::channel_with_cylinder(mesh, 0.03, 2, 2., true);
  mesh.refine_global(3);
  Parabola                   parabola(0.41, 0.3);
  Functions::ZeroFunction<2> zero(3);
  const MappingQ<2>          mapping(2);
  // 0 inlet, 1 outlet, 2 cylinder, 3 walls
  const SteadyFlow flow(mesh,
                        mapping,
                        {1., 1e-3, 0.},
                        {{0, &parabola}, {2, &zero}, {3, &zero}},
                        {{1, 0.}});
  EXPECT_LT(flow.last_norm, 1e-12);
  const IndexSet cylinder[] = {
    DoFTools::extract_boundary_dofs(flow.dof_handler,
                                    flow.fluid.fe.component_mask(
                                      FEValuesExtractors::Scalar(0)),
                                    {2}),
    DoFTools::extract_boundary_dofs(flow.dof_handler,
                                    flow.fluid.fe.component_mask(
                                      FEValuesExtractors::Scalar(1)),
                                    {2})};
  double coefficients[2] = {};
  for (unsigned int c = 0; c < 2; ++c)
    for (const auto dof : cylinder[c])
      coefficients[c] += 2. / (0.2 * 0.2 * 0.1) * flow.residual(dof);
  EXPECT_NEAR(coefficients[0], 5.57953523384, 2e-3 * 5.58);
  EXPECT_NEAR(coefficients[1], 0.010618948146, 2e-2 * 0.0106);
  Vector<double> front(3), back(3);
  VectorTools::point_value(
    mapping, flow.dof_handler, flow.u, Point<2>(0.15, 0.2), front);
  VectorTools::point_value(
    mapping, flow.dof_handler, flow.u, Point<2>(0.25, 0.2), back);
  EXPECT_NEAR(front(2) - back(2), 0.11752016697, 1e-2 * 0.1175);
}


// A fluid at rest that 1000 pushes: with total pressure at the inlet Q grows as
// sqrt(2 dp/rho) H tanh(...); short of that, Bernoulli's law for a channel.
TEST(ImmersedFlow, UnblockedFlowStartsAsBernoulliSays)
{
  // rho L dq/dt = dp - rho q^2/2 with q = q_0 tanh(t q_0/(2 L)), q_0^2 = 2 dp
  // (walls take some: the layer sqrt(pi mu t) is a tenth of the height)
  const double q_0  = std::sqrt(2000.);
  const double free = q_0 * std::tanh(0.2 * q_0 / (2. * 4.));
  // a wall on the wall
  const double Q = leak({Point<2>(2., 0.), Point<2>(3., 0.)}, 0., 1e4);
  EXPECT_LT(Q, free);
  EXPECT_GT(Q, 0.75 * free);
}


// What goes through a wall across the channel: the pressure over beta, and no
// more where grad-div keeps the volume within the cells that are cut.
TEST(ImmersedFlow, WallsLeakByPressureOverPenalty)
{
  const std::vector<Point<2>> straight = {Point<2>(2.03, 0.),
                                          Point<2>(2.03, 1.)};
  const double                tilt     = 0.5 * std::tan(0.4);
  const std::vector<Point<2>> oblique  = {Point<2>(2. - tilt, 0.),
                                          Point<2>(2. + tilt, 1.)};
  EXPECT_NEAR(leak(straight, 0., 1e4), 0.0985, 0.05 * 0.0985);
  EXPECT_NEAR(leak(straight, 100., 1e6), 0.00099, 0.05 * 0.00099);
  const double without = leak(oblique, 0., 1e4);
  EXPECT_GT(without, 2.);
  EXPECT_NEAR(leak(oblique, 100., 1e4), 0.123, 0.2 * 0.123);
  EXPECT_NEAR(leak(oblique, 100., 1e6), 0.0146, 0.5 * 0.0146);
}
